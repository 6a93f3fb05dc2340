# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Every command does its work."""

import json
import unittest

import meshes
import numpy
from program import (
    BOX,
    BOX_CURVE_LENGTH,
    BOX_VOLUME,
    BRACKET,
    ProgramTest,
    box_volume,
    signed_volume,
)
from vtkmodules.util.numpy_support import vtk_to_numpy


def names(attributes):
    return {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}


class Commands(ProgramTest):
    def test_sharpen(self):
        rounded = self.read("box.vtp")
        for method in ("robust", "paper"):
            with self.subTest(method):
                self.assert_done("sharpen", "box.vtp", "-o", "out.vtp", "--method", method)
                sharp = self.read("out.vtp")
                self.assertEqual(sharp.GetNumberOfPolys(), rounded.GetNumberOfPolys())
                lost = BOX_VOLUME - signed_volume(rounded)
                self.assertLess(abs(BOX_VOLUME - signed_volume(sharp)), 0.3 * lost)
                fields = names(sharp.GetFieldData())
                self.assertLessEqual({"Lambda", "SharpAngle", "AverageEdgeLength"}, fields)
                self.assertEqual("Roughness" in fields, method == "robust")
                self.assertFalse([name for name in fields if name.endswith("Seconds")])

    def test_sharpen_is_robust_unless_told_otherwise(self):
        self.assert_done("sharpen", "box.vtp", "-o", "default.vtp")
        for method in ("robust", "paper"):
            self.assert_done("sharpen", "box.vtp", "-o", method + ".vtp", "--method", method)
        files = self.files()
        self.assertEqual(files["default.vtp"], files["robust.vtp"])
        self.assertNotEqual(files["default.vtp"], files["paper.vtp"])

    def test_sharpen_in_place(self):
        self.assert_done("sharpen", "box.vtp", "-o", "sharp.vtp")
        self.assert_done("sharpen", "box.vtp", "-o", "box.vtp")
        self.assertEqual(self.files()["box.vtp"], self.files()["sharp.vtp"])

    def test_classify(self):
        self.assert_done("classify", "box.vtp", "-o", "out.vtp", "--json", "out.json")
        mesh = self.read("out.vtp")
        self.assertTrue((meshes.points(mesh) == meshes.points(self.read("box.vtp"))).all())
        arrays = names(mesh.GetPointData())
        self.assertLessEqual({"USSOD", "NormalDeviation", "SharpRegion"}, arrays)
        sharp = vtk_to_numpy(mesh.GetPointData().GetArray("SharpRegion"))
        count = self.read_json("out.json")["counts"]["sharp_vertices"]
        self.assertEqual(numpy.count_nonzero(sharp), count)
        self.assertTrue(0 < count < mesh.GetNumberOfPoints())

    def pick(self):
        """A vertex of the box where it is sharpest and one where it is smoothest, as x,y,z."""
        self.assert_done("classify", "box.vtp", "-o", "classified.vtp")
        mesh = self.read("classified.vtp")
        deviation = vtk_to_numpy(mesh.GetPointData().GetArray("NormalDeviation"))
        return (
            ",".join(repr(float(c)) for c in mesh.GetPoint(int(i)))
            for i in (deviation.argmax(), deviation.argmin())
        )

    def test_picked_points(self):
        sharp, smooth = self.pick()
        for command in (("classify",), ("sharpen", "--method", "paper"), ("sharpen",)):
            with self.subTest(command):
                picks = ("--sharp-at", sharp, "--sharp-at", sharp, "--smooth-at", smooth)
                args = (*command, "box.vtp", "-o", "out.vtp", *picks, "--json", "out.json")
                self.assertIn("by the picked points: window", self.assert_done(*args))
                used = self.read_json("out.json")["parameters"]
                self.assertTrue(used["picked"])
                self.assertAlmostEqual(used["window_ratio"], 0.5, places=9)
                self.assertGreater(used["sharp_angle"], 60.0)
                numbers = ("--window", repr(used["window"]), "--sharp-angle", used["sharp_angle"])
                self.assert_done(*command, "box.vtp", "-o", "hand.vtp", *numbers)
                self.assertEqual(self.files()["hand.vtp"], self.files()["out.vtp"])

    def test_picked_points_that_contradict_each_other(self):
        sharp, smooth = self.pick()
        args = ("classify", "box.vtp", "-o", "out.vtp", "--sharp-at", smooth, "--smooth-at", sharp)
        self.assert_fails("box.vtp: the picked points contradict each other: (", *args)

    def test_edges_and_corners(self):
        self.assert_done("sharpen", "box.vtp", "-o", "sharp.vtp")
        said = self.assert_done("edges", "sharp.vtp", "-o", "edges.vtp", "--corners", "c.vtp")
        self.assertIn("features: 12 curves of length 12.4, 8 corners, 6 surfaces", said)
        points = meshes.points(self.read("c.vtp"))
        self.assertEqual(len(points), BOX["corners"])
        x, y, z = meshes.turned(*points.T.astype(float))
        off = numpy.abs([abs(x) - 0.6, abs(y) - 0.5, abs(z) - 0.45]).max()
        self.assertLess(off, 0.01)
        self.assertGreater(self.read("edges.vtp").GetNumberOfLines(), 0)

    def test_a_feature_angle_that_nothing_reaches(self):
        args = ("edges", "box.vtp", "-o", "e.vtp", "--feature-angle", "179")
        self.assertIn("features: 0 curves", self.assert_done(*args))
        self.assertEqual(self.read("e.vtp").GetNumberOfCells(), 0)

    def test_regions(self):
        self.assert_done("sharpen", "box.vtp", "-o", "sharp.vtp")
        self.assert_done("regions", "sharp.vtp", "-o", "out.vtp", "--json", "out.json")
        ids = vtk_to_numpy(self.read("out.vtp").GetCellData().GetArray("SurfaceId"))
        self.assertEqual(len(set(ids)), BOX["surfaces"])
        result = self.read_json("out.json")
        self.assertLessEqual(BOX.items(), result["counts"].items())
        self.assertAlmostEqual(result["curve_length"], BOX_CURVE_LENGTH, delta=0.01)

    def test_contour_points_outward(self):
        args = ("contour", BRACKET, "--value=0", "--method", "paper", "-o")
        for side, sign in (("auto", 1), ("above", 1), ("below", -1)):
            with self.subTest(side):
                self.assert_done(*args, "out.vtp", "--inside", side)
                volume = sign * signed_volume(self.read("out.vtp"))
                self.assertAlmostEqual(volume, 344478.0, delta=3000.0)  # that of bracket.ply

    def test_contour_points_outward_whatever_the_sign(self):
        self.write("positive.vti", box_volume())
        self.write("negative.vti", box_volume(sign=-1))
        for name, side, sign in (
            ("positive.vti", "auto", 1),
            ("negative.vti", "auto", 1),
            ("negative.vti", "below", 1),
            ("negative.vti", "above", -1),
        ):
            with self.subTest(name, side=side):
                self.assert_done("contour", name, "--value=0", "-o", "out.vtp", "--inside", side)
                volume = signed_volume(self.read("out.vtp"))
                self.assertAlmostEqual(volume, sign * BOX_VOLUME, delta=0.01)

    def test_contour_at_negative_values(self):
        for value in (("--value", "-.5"), ("--value=-.5",)):
            self.assert_done("contour", BRACKET, *value, "-o", "out.ply", "--method", "paper")

    def test_compare_with_itself(self):
        said = self.assert_done("compare", "box.vtp", "box.vtp", "--samples", "9999", "--json", "-")
        for direction in ("reference_to_mesh", "mesh_to_reference", "larger"):
            for measure in ("max", "mean", "rms"):
                self.assertLess(json.loads(said)[direction][measure], 1e-12)

    def test_compare_with_a_mesh_beside(self):
        mesh = meshes.copy(self.read("box.vtp"))
        meshes.points(mesh)[:] += (0.0, 0.0, 5.0)
        self.write("beside.ply", mesh)
        args = ("compare", "box.vtp", "beside.ply", "--samples", "100", "--json", "-")
        larger = json.loads(self.assert_done(*args))["larger"]
        self.assertTrue(4.5 < larger["max"] < 5.5, larger)
        self.assertLess(larger["mean"], larger["max"])


if __name__ == "__main__":
    unittest.main()
