# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Solids sampled on a grid, and contoured."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

WIDTH = 2.0  # of the sampled cube; the solids are about 1.5 wide


def sampled_solid(solid, samples):
    """The solid's distance on samples^3 points, positive inside, and the width of a cell."""
    cell = WIDTH / (samples - 1)
    axis = np.linspace(-WIDTH / 2, WIDTH / 2, samples)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    values = -solid.distance(np.column_stack([x.ravel(), y.ravel(), z.ravel()]))
    volume = vtkImageData()
    volume.SetDimensions(samples, samples, samples)
    volume.SetSpacing(cell, cell, cell)
    volume.SetOrigin(-WIDTH / 2, -WIDTH / 2, -WIDTH / 2)
    volume.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return volume, cell


def zero_contour(volume):
    edges = vtkFlyingEdges3D()
    edges.SetInputData(volume)
    edges.SetValue(0, 0.0)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.Update()
    return edges.GetOutput()
