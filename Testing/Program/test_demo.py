# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The demo, on the small volume of the bracket: its comparison takes less time."""

import os
import unittest

from program import BRACKET, DATA, ProgramTest

MESHES = ("before.ply", "before.vtp", "after.ply", "after.vtp", "edges.vtp", "corners.vtp")


class Demo(ProgramTest):
    def test_without_a_display(self):
        data = self.folder / "data"
        data.mkdir()
        os.symlink(BRACKET, data / "bracket.mha")
        for name in ("bracket.ply", "bracket-edges.vtp"):
            os.symlink(DATA / name, data / name)
        args = ("demo", "--data", "data", "-o", "out", "--json", "demo.json")
        run = self.run_program(*args, environment={"ARRIS_DATA": "/nowhere"})
        self.assert_one_line(run, 1, "out/before-after.png: cannot be drawn: there is no X display")
        self.assertIn("after", run.stdout)
        self.assertEqual(sorted(os.listdir(self.folder / "out")), sorted(MESHES))
        for name in MESHES:
            self.assertGreater(self.read("out/" + name).GetNumberOfPoints(), 0, name)
        result = self.read_json("demo.json")
        self.assertEqual(result["command"], "demo")
        self.assertEqual(result["parameters"]["feature_angle"], 20.0)
        for when in ("before", "after"):
            self.assertGreater(result[when]["larger"]["max"], 0.0)
            self.assertTrue(0.0 < result[when]["edge_recall"] <= 1.0)
            self.assertTrue(0.0 < result[when]["edge_precision"] <= 1.0)

    def test_data_that_is_not_there(self):
        args = ("demo", "-o", "out", "--data")
        (self.folder / "empty").mkdir()
        self.assert_fails("empty: holds no bracket.mha; give the folder Data", *args, "empty")

    def test_a_file_in_place_of_the_folder(self):
        text = "box.vtp: cannot be made: Not a directory; choose another folder with -o"
        self.assert_fails(text, "demo", "-o", "box.vtp")


if __name__ == "__main__":
    unittest.main()
