# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Curves, corners and faces in numpy, as a script would use them."""

import unittest

import meshes
import numpy
from arris import vtkSharpEdgeExtractor, vtkSharpEdgeReconstruction
from vtkmodules.util.numpy_support import vtk_to_numpy


def extracted(mesh, **parameters):
    extract = vtkSharpEdgeExtractor()
    for name, value in parameters.items():
        getattr(extract, "Set" + name)(value)
    extract.SetInputData(mesh)
    extract.Update()
    return extract


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def point_array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def column(table, name):
    return [table.GetValueByName(row, name).ToString() for row in range(table.GetNumberOfRows())]


class OfACube(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.extract = extracted(meshes.soup())

    def test_curves(self):
        curves = self.extract.GetOutput()
        numpy.testing.assert_allclose(cell_array(curves, "Length"), numpy.ones(12))
        numpy.testing.assert_allclose(cell_array(curves, "DihedralAngle"), 90.0, atol=1e-4)
        self.assertFalse(cell_array(curves, "Closed").any())
        self.assertFalse(cell_array(curves, "CurveKind").any())
        left, right = (cell_array(curves, side + "SurfaceId") for side in ("Left", "Right"))
        self.assertTrue((left < right).all())
        pairs = set(zip(left.tolist(), right.tolist()))
        self.assertEqual(len(pairs), 12, "each two faces share an edge, but for opposite ones")

    def test_points_are_those_of_the_mesh(self):
        curves = self.extract.GetOutput()
        ids = point_array(curves, "MeshPointId")
        mesh = meshes.points(self.extract.GetSurfaces())
        numpy.testing.assert_array_equal(meshes.points(curves), mesh[ids])
        lengths = numpy.linalg.norm(point_array(curves, "Tangent"), axis=1)
        numpy.testing.assert_allclose(lengths, 1.0)

    def test_corners(self):
        corners = self.extract.GetCorners()
        self.assertEqual(point_array(corners, "Valence").tolist(), [3] * 8)
        ids = point_array(corners, "CurveIds")
        self.assertEqual(ids.shape, (8, 3))
        self.assertEqual(numpy.bincount(ids.ravel()).tolist(), [2] * 12)
        self.assertFalse(point_array(corners, "Tip").any())

    def test_faces(self):
        faces = self.extract.GetFaces()
        self.assertEqual(column(faces, "Primitive"), ["plane"] * 6)
        numpy.testing.assert_allclose([float(area) for area in column(faces, "Area")], 1.0)
        axes = vtk_to_numpy(faces.GetColumnByName("Axis"))
        numpy.testing.assert_allclose(numpy.abs(axes).max(axis=1), 1.0)
        self.assertEqual(cell_array(self.extract.GetSurfaces(), "SurfaceId").max(), 5)

    def test_resampled(self):
        curves = extracted(meshes.soup(), ResampleStep=0.25).GetOutput()
        self.assertEqual(curves.GetNumberOfPoints(), 12 * 5)
        self.assertEqual((point_array(curves, "MeshPointId") == -1).sum(), 12 * 3)


class OfSampledMeshes(unittest.TestCase):
    def test_a_recovered_box_has_twelve_curves(self):
        recover = vtkSharpEdgeReconstruction()
        recover.SetInputData(meshes.box(32))
        recover.Update()
        extract = extracted(recover.GetOutput())
        lengths = numpy.sort(cell_array(extract.GetOutput(), "Length"))
        numpy.testing.assert_allclose(lengths, numpy.repeat([0.9, 1.0, 1.2], 4), atol=0.01)
        self.assertEqual(extract.GetCorners().GetNumberOfPoints(), 8)
        self.assertEqual(column(extract.GetFaces(), "Primitive"), ["plane"] * 6)

    def test_a_noisy_plate_has_none(self):
        steps = numpy.arange(81.0)
        x, y = numpy.meshgrid(steps, steps)
        grid = numpy.stack([x, y, 0.0 * x], axis=-1)
        edge = (2.0 + 2.0**0.5) / 3.0
        grid += numpy.random.default_rng(7).normal(size=grid.shape) * 0.1 * edge
        a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
        halves = numpy.concatenate([numpy.stack(t, axis=2) for t in ((a, b, c), (a, c, d))])
        curves = extracted(meshes.triangles(halves.reshape(-1, 3, 3)), MergeTolerance=0.0)
        kinds = cell_array(curves.GetOutput(), "CurveKind")
        self.assertEqual(set(kinds.tolist()), {2}, "its boundary alone")


if __name__ == "__main__":
    unittest.main()
