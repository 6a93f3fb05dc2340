#!/usr/bin/env python3
"""Writes the few meshes of the bed that the tests guard the method with, and their true edges.

Into Testing/Data/Bed: NAME.vtp, sampled, and NAME-edges.vtp, the sharp edges of the exact solid with
the width of a sampling cell as the field value Cell.
"""

from pathlib import Path

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import cache
import cases
import sampling
from meshes import to_polydata

FOLDER = Path(__file__).resolve().parents[2] / "Data" / "Bed"
GUARDED = (  # solid, sampling
    ("l_bracket", "contour64"),
    ("random0", "contour64"),
    ("pyramid6", "irregular32"),
    ("fading", "contour32"),
    ("box_rotated", "segmentation32"),
)


def main():
    """The command line."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for solid, name in GUARDED:
        truth = cases.truth_of(solid)
        mesh = cases.input_mesh(cache.default_folder(), solid, name)
        stem = f"{solid}-{name}"
        _write(FOLDER / f"{stem}.vtp", to_polydata(mesh.points, mesh.tris))
        edges = to_polydata(truth.mesh.points, truth.segments, lines=True)
        cell = vtkDoubleArray()
        cell.SetName("Cell")
        cell.InsertNextValue(sampling.cell_size(name))
        edges.GetFieldData().AddArray(cell)
        _write(FOLDER / f"{stem}-edges.vtp", edges)


def _write(path, data):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(_only_what_is_used(data))
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToLZMA()
    writer.Write()


def _only_what_is_used(data):
    """Without the points that no cell uses."""
    from vtkmodules.vtkFiltersCore import vtkCleanPolyData

    clean = vtkCleanPolyData()
    clean.SetInputData(data)
    clean.PointMergingOff()
    clean.Update()
    return clean.GetOutput()


if __name__ == "__main__":
    main()
