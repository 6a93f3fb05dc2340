# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The bracket of Data/ with the same questions answered as the solids of `solids`."""

from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOImage import vtkMetaImageReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

DATA = Path(__file__).resolve().parents[2] / "Data"


def read(reader, name):
    reader.SetFileName(str(DATA / name))
    reader.Update()
    return reader.GetOutput()


def distances_to(surface_or_lines, points):
    """The distance from each point to the nearest place on the cells of a vtkPolyData."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface_or_lines)
    locator.BuildLocator()
    cell, cell_id, sub_id, squared = vtkGenericCell(), reference(0), reference(0), reference(0.0)
    nearest = [0.0, 0.0, 0.0]
    result = np.empty(len(points))
    for i, point in enumerate(points):
        locator.FindClosestPoint(point, nearest, cell, cell_id, sub_id, squared)
        result[i] = np.sqrt(squared.get())
    return result


class Bracket:
    """The exact surface and curves, and the volume at every `stride`-th sample."""

    def __init__(self, stride):
        self.surface = read(vtkPLYReader(), "bracket.ply")
        self.lines = read(vtkXMLPolyDataReader(), "bracket-edges.vtp")
        extract = vtkExtractVOI()
        extract.SetInputData(read(vtkMetaImageReader(), "bracket.mha"))
        extract.SetSampleRate(stride, stride, stride)
        extract.SetVOI(extract.GetInput().GetExtent())
        extract.Update()
        self.volume = extract.GetOutput()

    def distance(self, points):
        return distances_to(self.surface, points)

    def curves(self):
        points = vtk_to_numpy(self.lines.GetPoints().GetData()).astype(float)
        lines = self.lines.GetLines()
        offsets = vtk_to_numpy(lines.GetOffsetsArray())
        ids = vtk_to_numpy(lines.GetConnectivityArray())
        return [points[ids[a:b]] for a, b in zip(offsets[:-1], offsets[1:])]
