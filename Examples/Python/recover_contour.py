# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Contours a volume, gives the contour its sharp edges back, and finds these edges.

    python3 recover_contour.py Data/bracket-small.mha --value 0 -o made

Needs `arris` on PYTHONPATH: the folder lib/python3/dist-packages of a build or an installation.
"""

import argparse
import pathlib

from arris import vtkSharpEdgeExtractor, vtkSharpEdgeReconstruction
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOImage import vtkMetaImageReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter


def write(port, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(port)
    writer.SetFileName(str(path))
    writer.SetDataModeToBinary()  # ParaView 5.11 on Debian 12 cannot read appended data
    if not writer.Write():
        raise SystemExit(f"cannot write {path}")
    print(f"wrote {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("volume", help="a MetaImage file (.mha, .mhd)")
    parser.add_argument("--value", type=float, default=0.0, help="contour here (default: 0)")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("."),
                        help="the folder to write to (default: this one)")
    arguments = parser.parse_args()

    reader = vtkMetaImageReader()
    if not reader.CanReadFile(arguments.volume):
        raise SystemExit(f"{arguments.volume} is missing or not a MetaImage")
    reader.SetFileName(arguments.volume)

    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetValue(0, arguments.value)

    recovery = vtkSharpEdgeReconstruction()
    recovery.SetInputConnection(contour.GetOutputPort())

    edges = vtkSharpEdgeExtractor()
    edges.SetInputConnection(recovery.GetOutputPort())
    edges.Update()

    mesh = recovery.GetOutput()
    moved = mesh.GetPointData().GetArray("Displacement")
    print(f"{mesh.GetNumberOfPolys()} triangles, moved by up to {moved.GetMaxNorm():.3f}")
    print(f"{edges.GetOutput().GetNumberOfLines()} feature curves, "
          f"{edges.GetCorners().GetNumberOfPoints()} corners")

    arguments.output.mkdir(parents=True, exist_ok=True)
    write(recovery.GetOutputPort(), arguments.output / "recovered.vtp")
    write(edges.GetOutputPort(), arguments.output / "edges.vtp")


if __name__ == "__main__":
    main()
