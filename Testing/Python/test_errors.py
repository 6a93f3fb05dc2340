# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Errors as a script meets them: one event with text, and empty output."""

import math
import unittest

import meshes
from arris import (
    vtkSharpEdgeExtractor,
    vtkSharpEdgeReconstruction,
    vtkSharpeningFilter,
    vtkSharpThinningFilter,
    vtkUSSODFilter,
)
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkPolyData


class Errors(unittest.TestCase):
    def assert_one_error(self, filter_, data, about):
        heard = []

        @calldata_type(VTK_STRING)
        def listen(caller, event, text):
            heard.append(text)

        filter_.AddObserver("ErrorEvent", listen)
        filter_.GetExecutive().AddObserver("ErrorEvent", listen)
        filter_.SetInputData(data)
        filter_.Update()
        self.assertEqual(len(heard), 1, heard)
        self.assertIn(about, heard[0])
        for port in range(filter_.GetNumberOfOutputPorts()):
            output = filter_.GetOutputDataObject(port)
            if output.IsA("vtkTable"):
                self.assertEqual(output.GetNumberOfRows(), 0)
                continue
            self.assertEqual(output.GetNumberOfPoints(), 0)
            self.assertEqual(output.GetNumberOfCells(), 0)

    def test_a_point_that_is_no_number(self):
        for make in (vtkUSSODFilter, vtkSharpEdgeReconstruction, vtkSharpEdgeExtractor):
            data = meshes.copy(meshes.box(16))
            data.GetPoints().SetPoint(3, math.nan, 0.0, 0.0)
            self.assert_one_error(make(), data, "point 3")

    def test_arrays_that_are_missing(self):
        self.assert_one_error(vtkSharpThinningFilter(), meshes.box(16), "SharpRegion")
        self.assert_one_error(vtkSharpeningFilter(), meshes.box(16), "ThinningRound")

    def test_parameters_out_of_range(self):
        for make in (vtkUSSODFilter, vtkSharpEdgeReconstruction):
            for name, bad in (("SharpAngle", -1), ("WindowRatio", -1), ("WindowSearch", 9)):
                with self.subTest(f"{make.__name__}.{name}"):
                    filter_ = make()
                    getattr(filter_, "Set" + name)(bad)
                    self.assert_one_error(filter_, meshes.box(16), name)

    def test_a_mesh_without_triangles_has_no_features(self):
        self.assert_one_error(vtkSharpEdgeExtractor(), vtkPolyData(), "no triangles")

    def test_triangles_that_share_nothing_have_no_features(self):
        self.assert_one_error(vtkSharpEdgeExtractor(), meshes.soup(0.1), "MergeTolerance")

    def test_angles_of_features_out_of_range(self):
        for name, bad in (("FeatureAngle", 0), ("CornerAngle", 181), ("ContinuationAngle", 31)):
            with self.subTest(name):
                filter_ = vtkSharpEdgeExtractor()
                getattr(filter_, "Set" + name)(bad)
                self.assert_one_error(filter_, meshes.box(16), name)

    def test_a_value_of_the_wrong_type_is_refused_at_once(self):
        with self.assertRaises(TypeError):
            vtkUSSODFilter().SetSharpAngle("forty")


if __name__ == "__main__":
    unittest.main()
