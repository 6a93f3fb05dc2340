# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What the image tests show."""

import os
import pathlib
import subprocess
import sys
import tempfile

import meshes
from arris import vtkSharpEdgeExtractor, vtkSharpEdgeReconstruction
from pictures import actor, draw, read
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkClipPolyData, vtkFlyingEdges3D
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkCylinderSource
from vtkmodules.vtkIOImage import vtkMetaImageReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "Examples/Python"))
import recover_assembly  # noqa: E402

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
    return draw([actor(mesh), lines], direction=(1.0, -1.2, 0.9), zoom=1.4)


COLORS = [(0.84, 0.15, 0.16), (0.12, 0.38, 0.78), (0.15, 0.55, 0.20), (0.95, 0.50, 0.05)]


def colored(data, array, count, of_cells=True):
    """Cells or points in colors by their number in an array."""
    shown = actor(data)
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(count)
    for number in range(count):
        colors.SetTableValue(number, *COLORS[number % len(COLORS)])
    mapper = shown.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToMapScalars()
    if of_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(array)
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(0, count - 1)
    shown.GetProperty().LightingOff()
    shown.GetProperty().SetLineWidth(4)
    shown.GetProperty().SetPointSize(9)
    return shown


def solids():
    """A cube, a cylinder and a cone."""
    joined = vtkAppendPolyData()
    cylinder, cone = vtkCylinderSource(), vtkConeSource()
    for source, place in ((vtkCubeSource(), 0.0), (cylinder, 1.5), (cone, -1.5)):
        source.SetCenter(place, 0.0, 0.0)
        joined.AddInputConnection(source.GetOutputPort())
    cylinder.SetResolution(32)
    cone.SetResolution(32)
    cone.SetDirection(0.0, 1.0, 0.0)
    joined.Update()
    return joined.GetOutput()


def features(feature_angle=30.0):
    """Each curve of the solids in a color, corners and the tip as points."""
    mesh = solids()
    extract = vtkSharpEdgeExtractor()
    extract.SetFeatureAngle(feature_angle)
    extract.SetInputData(mesh)
    extract.Update()
    curves, corners = extract.GetOutput(), extract.GetCorners()
    shown = [actor(mesh)]
    shown.append(colored(curves, "CurveId", max(2, curves.GetNumberOfCells())))
    shown.append(colored(corners, "Tip", 2, of_cells=False))
    return draw(shown, direction=(0.3, 0.5, 1.0))


def edges_command(*options):
    """The solids as `arris edges --picture` draws them, at half the size."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, picture = os.path.join(folder, "solids.vtp"), os.path.join(folder, "edges.png")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(mesh)
        writer.SetInputData(solids())
        writer.Write()
        subprocess.run(
            [
                os.environ["ARRIS_PROGRAM"],
                *("edges", mesh, "-o", os.path.join(folder, "edges.vtp")),
                *("--picture", picture, "--quiet", *options),
            ],
            check=True,
        )
        return read(picture, 0.5)


def patches(mesh):
    """The patches of an assembly in colors, cut open to show those inside."""
    plane, clip = vtkPlane(), vtkClipPolyData()
    plane.SetOrigin(4.0, -2.0, 4.0)
    plane.SetNormal(-0.5, 0.2, -0.8)
    clip.SetInputData(mesh)
    clip.SetClipFunction(plane)
    clip.Update()
    shown = colored(clip.GetOutput(), "PatchId", 24)
    shown.GetProperty().LightingOn()
    return shown


def assembly(recover=True):
    """Two cubes and a sphere of three materials, cut open."""
    mesh = recover_assembly.sampled()
    shown = patches(recovered(mesh) if recover else mesh)
    return draw([shown], direction=(0.5, 0.1, 1.0), zoom=1.4)
