# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The paper's first example: two cubes through each other and a sphere, each of another material.

    python3 recover_assembly.py -o made

A field tells the material at each point of a grid; surface nets make the surface between all of
them a mesh, whose patches meet along curves; then it gets its edges back, these curves among them.

Needs numpy, and `arris` on PYTHONPATH: the folder lib/python3/dist-packages of a build or an
installation.
"""

import argparse
import pathlib

import numpy as np
from arris import vtkSharpEdgeReconstruction
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

CELLS = 34  # a side of the cube from -32 to 32


def turn(*degrees):
    """The matrix that turns about x, then y, then z."""
    matrix = np.eye(3)
    for (i, j), angle in zip(((1, 2), (2, 0), (0, 1)), np.radians(degrees)):
        about = np.eye(3)
        about[i, i] = about[j, j] = np.cos(angle)
        about[j, i], about[i, j] = np.sin(angle), -np.sin(angle)
        matrix = about @ matrix
    return matrix


def materials(points):
    """How deep points are in what is outside, in the cubes and in the sphere; the first that has a
    point keeps it."""
    points = (points - (0.3, -0.2, 0.1)) @ turn(22, 37, 48)  # no face lies along the grid
    one = 13 - np.abs(points - (-5, -4, -3)).max(axis=-1)
    two = 12 - np.abs((points - (8, 7, 5)) @ turn(24, 31, 40)).max(axis=-1)
    ball = 13 - np.linalg.norm(points - (5, -12, 8), axis=-1)
    two = np.minimum(two, -one)
    ball = np.minimum(ball, -np.maximum(one, two))
    return np.stack([-np.maximum(np.maximum(one, two), ball), one, two, ball])


def surface_net(inside):
    """One vertex in each cell of several materials, one face for each edge between two of them."""
    label, axes = inside.argmax(axis=0), np.eye(3, dtype=int)
    count = label.shape[0]
    sums, hits, quads, ids = np.zeros((count**3, 3)), np.zeros(count**3), [], []
    for axis in range(3):
        start = np.argwhere(np.diff(label, axis=axis) != 0)
        end = start + axes[axis]
        a, b = label[tuple(start.T)], label[tuple(end.T)]
        before = inside[(a, *start.T)] - inside[(b, *start.T)]
        after = inside[(a, *end.T)] - inside[(b, *end.T)]
        crossing = start + np.outer(before / (before - after), axes[axis])
        u, w = axes[(axis + 1) % 3], axes[(axis + 2) % 3]
        cells = np.stack([(start - du * u - dw * w) @ (count**2, count, 1)
                          for du, dw in ((0, 0), (1, 0), (1, 1), (0, 1))], axis=1)
        for corner in cells.T:
            np.add.at(sums, corner, crossing)
            np.add.at(hits, corner, 1)
        quads.append(np.where((a > b)[:, None], cells[:, ::-1], cells))
        ids.append(10 * np.minimum(a, b) + np.maximum(a, b))
    used = np.flatnonzero(hits)
    points = -32 + 64 / (count - 1) * sums[used] / hits[used, None]
    quads = np.searchsorted(used, np.vstack(quads))
    return points, quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3), np.repeat(np.concatenate(ids), 2)


def polydata(points, triangles, ids):
    """A vtkPolyData with the cell array PatchId."""
    mesh, vtk_points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    rows = np.insert(triangles, 0, 3, axis=1).astype(np.int64)
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    array = numpy_to_vtk(ids.astype(np.int32), deep=True)
    array.SetName("PatchId")
    mesh.GetCellData().SetScalars(array)
    return mesh


def sampled():
    """The surface between the materials as it is known after sampling."""
    axis = np.linspace(-32, 32, CELLS + 1)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    return polydata(*surface_net(materials(grid)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--method", choices=("robust", "paper"), default="robust")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("."),
                        help="the folder to write to (default: this one)")
    arguments = parser.parse_args()

    before = sampled()
    recovery = vtkSharpEdgeReconstruction()
    recovery.SetInputData(before)
    if arguments.method == "paper":
        recovery.SetMethodToPaper()  # with the window and angle of the paper: 0.75 and 41.4 degrees
    recovery.Update()
    after = recovery.GetOutput()
    moved = after.GetPointData().GetArray("Displacement")
    print(f"{after.GetNumberOfPolys()} triangles in {recovery.GetNumberOfPatches()} patches with "
          f"{recovery.GetNumberOfCommonVertices()} common vertices, "
          f"moved by up to {moved.GetMaxNorm():.2f}")

    arguments.output.mkdir(parents=True, exist_ok=True)
    for name, mesh in (("before", before), ("after", after)):
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(mesh)
        writer.SetFileName(str(arguments.output / f"{name}.vtp"))
        writer.SetDataModeToBinary()  # ParaView 5.11 on Debian 12 cannot read appended data
        if not writer.Write():
            raise SystemExit(f"cannot write {arguments.output / name}.vtp")


if __name__ == "__main__":
    main()
