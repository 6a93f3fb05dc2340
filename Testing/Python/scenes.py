# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What the image tests show."""

import os

import meshes
from arris import vtkSharpEdgeExtractor, vtkSharpEdgeReconstruction
from pictures import actor, draw
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOImage import vtkMetaImageReader

SAMPLES = 40
FEW_SAMPLES = 20  # a chamfer must be many pixels wide to be seen as one


def recovered(mesh):
    recover = vtkSharpEdgeReconstruction()
    recover.SetMethodToPaper()  # which will not change
    recover.SetInputData(mesh)
    recover.Update()
    return recover.GetOutput()


def bracket(recover=True):
    """The L-bracket with its edges, or as sampling left it."""
    mesh = meshes.bracket(FEW_SAMPLES)
    return draw([actor(recovered(mesh) if recover else mesh)], direction=(0.9, 0.7, 0.8))


def roles(array="SkeletonRole"):
    """The sampled bracket with the parts its vertices play: branch, joint, end."""
    mesh = meshes.bracket(SAMPLES)
    mesh.GetPointData().AddArray(recovered(mesh).GetPointData().GetArray("SkeletonRole"))
    mesh.GetPointData().AddArray(recovered(mesh).GetPointData().GetArray("SharpRegion"))
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(4)
    for role, color in enumerate([(0.8, 0.8, 0.8), (0.1, 0.3, 0.9), (0.9, 0.1, 0.1), (0, 0.7, 0)]):
        colors.SetTableValue(role, *color)
    shown = actor(mesh)
    mapper = shown.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToMapScalars()  # or bytes would be taken as colors
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(array)
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(0, 3)
    mapper.InterpolateScalarsBeforeMappingOff()
    return draw([shown])


def curves(feature_angle=40.0):
    """The real part's feature curves and the surface they lie on."""
    reader = vtkMetaImageReader()
    reader.SetFileName(os.path.join(os.environ["ARRIS_DATA"], "bracket.mha"))
    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetValue(0, 0.0)
    contour.Update()
    mesh = recovered(contour.GetOutput())
    extract = vtkSharpEdgeExtractor()
    extract.SetFeatureAngle(feature_angle)
    extract.SetContinuationAngle(feature_angle)
    extract.SetInputData(mesh)
    extract.Update()
    lines = actor(extract.GetOutput(), (0.8, 0.05, 0.05))
    lines.GetProperty().SetLineWidth(2)
    lines.GetProperty().LightingOff()
    return draw([actor(mesh), lines], direction=(1.0, -1.2, 0.9), zoom=1.5)
