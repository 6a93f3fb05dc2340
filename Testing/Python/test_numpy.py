# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The arrays of the filters in numpy, and arrays made there as input."""

import unittest

import meshes
import numpy
from arris import vtkSharpeningFilter, vtkSharpEdgeReconstruction, vtkSharpThinningFilter
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def point_array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = meshes.bracket(32)
        recover = vtkSharpEdgeReconstruction()
        recover.SetMethodToPaper()
        recover.SetInputData(cls.mesh)
        recover.Update()
        cls.output = recover.GetOutput()

    def test_types(self):
        expected = {
            "USSOD": numpy.float64,
            "NormalDeviation": numpy.float64,
            "SharpRegion": numpy.uint8,
            "ThinningRound": numpy.int32,
            "SkeletonRole": numpy.uint8,
            "Displacement": numpy.float64,
        }
        for name, kind in expected.items():
            self.assertEqual(point_array(self.output, name).dtype, kind, name)

    def test_displacement_is_what_moved(self):
        moved = meshes.points(self.output).astype(float) - meshes.points(self.mesh)
        numpy.testing.assert_array_equal(point_array(self.output, "Displacement"), moved)
        still = point_array(self.output, "ThinningRound") == -1
        self.assertTrue((moved[still] == 0).all())
        self.assertTrue((moved[~still] != 0).any())

    def test_skeleton_is_the_last_round(self):
        rounds = point_array(self.output, "ThinningRound")
        roles = point_array(self.output, "SkeletonRole")
        numpy.testing.assert_array_equal(roles > 0, rounds == rounds.max())

    def test_a_region_from_numpy(self):
        mesh = meshes.copy(self.mesh)
        near_wall = (meshes.points(mesh)[:, 0] < -0.3).astype(numpy.uint8)
        region = numpy_to_vtk(near_wall, deep=True)
        region.SetName("Mine")
        mesh.GetPointData().AddArray(region)
        thin = vtkSharpThinningFilter()
        thin.SetInputData(mesh)
        thin.SetInputArrayToProcess(0, 0, 0, 0, "Mine")
        thin.Update()
        rounds = point_array(thin.GetOutput(), "ThinningRound")
        numpy.testing.assert_array_equal(rounds > 0, near_wall == 1)

    def test_rounds_of_any_number_type(self):
        expected = None
        for kind in (numpy.int8, numpy.int64, numpy.float32):
            mesh = meshes.copy(self.mesh)
            rounds = numpy_to_vtk(point_array(self.output, "ThinningRound").astype(kind), deep=True)
            rounds.SetName("ThinningRound")
            mesh.GetPointData().AddArray(rounds)
            sharpen = vtkSharpeningFilter()
            sharpen.SetInputData(mesh)
            sharpen.Update()
            points = meshes.points(sharpen.GetOutput()).copy()
            expected = points if expected is None else expected
            numpy.testing.assert_array_equal(points, expected)
        numpy.testing.assert_array_equal(expected, meshes.points(self.output))


if __name__ == "__main__":
    unittest.main()
