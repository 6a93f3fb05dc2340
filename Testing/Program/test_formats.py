# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The same mesh in and out of every format."""

import json
import os
import unittest

import meshes
import numpy
from program import (
    BOX,
    BOX_VOLUME,
    MESH_WRITERS,
    READERS,
    VOLUME_WRITERS,
    ProgramTest,
    box_volume,
    signed_volume,
)


class Formats(ProgramTest):
    def test_every_mesh_format_out_and_in_again(self):
        self.assert_done("sharpen", "box.vtp", "-o", "sharp.vtp")
        expected = self.read("sharp.vtp")
        for suffix in READERS:
            with self.subTest(suffix):
                name = "out" + suffix
                self.assert_done("sharpen", "box.vtp", "-o", name)
                mesh = self.read(name)
                self.assertEqual(mesh.GetNumberOfPoints(), expected.GetNumberOfPoints())
                self.assertEqual(mesh.GetNumberOfPolys(), expected.GetNumberOfPolys())
                self.assertAlmostEqual(signed_volume(mesh), signed_volume(expected), delta=1e-5)
                said = self.assert_done("edges", name, "-o", "edges.vtp", "--json", "-")
                self.assertLessEqual(BOX.items(), json.loads(said)["counts"].items())

    def test_extensions_in_capitals(self):
        self.assert_done("sharpen", "box.vtp", "-o", "SHARP.PLY")
        self.assert_done("sharpen", "box.vtp", "-o", "sharp.ply")
        self.assertEqual(self.files()["SHARP.PLY"], self.files()["sharp.ply"])
        self.assert_done("edges", "SHARP.PLY", "-o", "edges.VTP")

    def test_every_mesh_format_of_vtk(self):
        box = self.read("box.vtp")
        for suffix in MESH_WRITERS:
            with self.subTest(suffix):
                self.write("in" + suffix, box)
                self.assert_done("sharpen", "in" + suffix, "-o", "out.vtp")
                mesh = self.read("out.vtp")
                self.assertEqual(mesh.GetNumberOfPoints(), box.GetNumberOfPoints())
                self.assertAlmostEqual(signed_volume(mesh), BOX_VOLUME, delta=0.01)

    def test_every_curve_format(self):
        self.assert_done("edges", "box.vtp", "-o", "edges.vtp")
        expected = self.read("edges.vtp")
        for suffix in (".vtk", ".obj"):
            with self.subTest(suffix):
                self.assert_done("edges", "box.vtp", "-o", "edges" + suffix)
                curves = self.read("edges" + suffix)
                self.assertEqual(curves.GetNumberOfLines(), expected.GetNumberOfLines())
                self.assertEqual(curves.GetNumberOfPoints(), expected.GetNumberOfPoints())

    def test_every_volume_format(self):
        volume = box_volume()
        for suffix in VOLUME_WRITERS:
            self.write("box" + suffix, volume)
        samples = numpy.asarray(volume.GetPointData().GetScalars(), dtype="<f8").tobytes()
        spacing = volume.GetSpacing()[0]
        header = (
            "NRRD0004\ntype: double\ndimension: 3\nsizes: 20 20 20\nendian: little\n"
            f"encoding: raw\nspace origin: (-1,-1,-1)\nspace: left-posterior-superior\n"
            f"space directions: ({spacing!r},0,0) (0,{spacing!r},0) (0,0,{spacing!r})\n\n"
        )
        self.write("box.nrrd", header.encode() + samples)
        rounded = signed_volume(self.read("box.vtp"))
        for suffix in (*VOLUME_WRITERS, ".nrrd"):
            with self.subTest(suffix):
                self.assert_done("contour", "box" + suffix, "--value", "0", "-o", "out.ply")
                mesh = self.read("out.ply")
                self.assertGreater(signed_volume(mesh), rounded)
                self.assertAlmostEqual(signed_volume(mesh), BOX_VOLUME, delta=0.01)

    def test_a_symbolic_link_stays(self):
        self.write("target.ply", "old")
        os.symlink("target.ply", self.folder / "link.ply")
        os.chmod(self.folder / "target.ply", 0o640)
        self.assert_done("sharpen", "box.vtp", "-o", "link.ply")
        self.assertTrue((self.folder / "link.ply").is_symlink())
        self.assertEqual((self.folder / "target.ply").stat().st_mode & 0o777, 0o640)
        self.assertEqual(
            self.read("target.ply").GetNumberOfPoints(), len(meshes.points(self.read("box.vtp")))
        )


if __name__ == "__main__":
    unittest.main()
