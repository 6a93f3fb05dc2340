# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What goes to standard output and into JSON, and that results never change."""

import json
import unittest

from program import BRACKET, ProgramTest

COMMANDS = {
    "sharpen": ("sharpen", "box.vtp", "-o", "sharpen.vtp"),
    "classify": ("classify", "box.vtp", "-o", "classify.vtp"),
    "edges": ("edges", "box.vtp", "-o", "edges.vtp", "--corners", "corners.vtp"),
    "regions": ("regions", "box.vtp", "-o", "regions.vtp"),
    "contour": ("contour", BRACKET, "--value", "0", "--method", "paper", "-o", "contour.vtp"),
    "compare": ("compare", "box.vtp", "box.vtp", "--samples", "100"),
}

COMMON = {"program", "version", "command", "threads", "seconds"}
FILES = {"input", "output", "parameters", "counts"}
MESH = {"vertices", "triangles"}
RECOVERY = FILES | {"average_edge_length", "displacement", "assembly"}
RECOVERY_COUNTS = MESH | {"sharp_vertices", "skeleton_vertices", "moved_vertices"}
PAPER = {"method", "window", "window_ratio", "sharp_angle", "window_search", "picked"}
ROBUST = {
    "method",
    "window",
    "window_ratio",
    "window_range",
    "sharp_angle",
    "denoise",
    "allow_flips",
    "picked",
}
CURVES = MESH | {"curves", "corners", "surfaces"}
FEATURES = {
    "feature_angle",
    "continuation_angle",
    "maximum_angle",
    "corner_angle",
    "noise_factor",
    "boundary",
    "non_manifold",
    "gap",
    "tail",
    "minimum_length",
    "merge_tolerance",
}
STEPS = {"classification", "thinning", "sharpening"}
EXPECTED = {  # keys at the top, in parameters, in counts and in seconds
    "sharpen": (
        RECOVERY | {"recognised", "edge_flips", "outcomes"},
        ROBUST,
        RECOVERY_COUNTS,
        {"read", "write"} | STEPS,
    ),
    "classify": (
        FILES | {"average_edge_length", "assembly"},
        PAPER - {"method"},
        MESH | {"sharp_vertices"},
        None,
    ),
    "edges": (
        FILES | {"curve_length"},
        FEATURES | {"resample"},
        CURVES,
        {"read", "extraction", "write"},
    ),
    "regions": (FILES | {"curve_length"}, FEATURES, CURVES, {"read", "extraction", "write"}),
    "contour": (
        RECOVERY,
        PAPER | {"value", "inside"},
        RECOVERY_COUNTS,
        {"read", "contour", "write"} | STEPS,
    ),
    "compare": (
        {"reference", "mesh", "diagonal", "reference_to_mesh", "mesh_to_reference", "larger"},
        None,
        None,
        {"read", "compare"},
    ),
}
DISTANCES = {"max", "mean", "rms", "max_percent", "mean_percent", "rms_percent", "samples"}


class Output(ProgramTest):
    def test_words_on_standard_output_alone(self):
        for command, arguments in COMMANDS.items():
            with self.subTest(command):
                said = self.assert_done(*arguments)  # standard error stays empty: no terminal
                if "-o" in arguments:
                    output = arguments[arguments.index("-o") + 1]
                    self.assertIn(f"wrote {output}\n", said)

    def test_quiet(self):
        for command, arguments in COMMANDS.items():
            with self.subTest(command):
                for quiet in ("-q", "--quiet"):
                    self.assertEqual(self.assert_done(*arguments, quiet), "")

    def test_json(self):
        for command, arguments in COMMANDS.items():
            with self.subTest(command):
                result = json.loads(self.assert_done(*arguments, "--json", "-"))
                top, parameters, counts, seconds = EXPECTED[command]
                self.assertEqual(set(result), COMMON | top)
                self.assertEqual(result["program"], "arris")
                self.assertEqual(result["command"], command)
                self.assertGreater(result["seconds"]["total"], 0.0)
                for key, names in (("parameters", parameters), ("counts", counts)):
                    if names is not None:
                        self.assertEqual(set(result[key]), names)
                if seconds is not None:
                    self.assertEqual(set(result["seconds"]), seconds | {"total"})
                if "displacement" in top:
                    self.assertEqual(set(result["displacement"]), {"largest", "mean_of_moved"})
                    skeleton = result["counts"]["skeleton_vertices"]
                    self.assertEqual(set(skeleton), {"branch", "joint", "end"})
                if command == "compare":
                    self.assertEqual(set(result["larger"]), DISTANCES)

    def test_json_file_with_words(self):
        said = self.assert_done(*COMMANDS["sharpen"], "--json", "out.json", "--threads", "1")
        self.assertIn("box.vtp: 728 vertices, 1452 triangles\n", said)
        result = self.read_json("out.json")
        self.assertEqual((result["threads"], result["counts"]["vertices"]), (1, 728))

    def test_same_bytes_for_any_threads_and_every_time(self):
        for suffix in (".vtp", ".vtk", ".ply", ".stl", ".obj"):
            with self.subTest(suffix):
                self.assert_same("sharpen", "box.vtp", "-o", suffix=suffix)
        self.assert_same("contour", BRACKET, "--value", "0", "-o", suffix=".vtp")
        for suffix in (".vtp", ".obj", ".csv", ".eMesh"):
            self.assert_same("edges", "box.vtp", "-o", suffix=suffix)
        self.assert_same("regions", "box.vtp", "-o", suffix=".vtp")

    def assert_same(self, *arguments, suffix):
        first, *others = [
            self.bytes_with(threads, *arguments, suffix=suffix) for threads in (1, 2, 2)
        ]
        self.assertGreater(len(first), 1000)
        for other in others:
            self.assertTrue(other == first, f"{arguments[0]} to {suffix} differs")

    def bytes_with(self, threads, *arguments, suffix):
        output = self.folder / ("same" + suffix)
        output.unlink(missing_ok=True)
        self.assert_done(*arguments, output.name, "--threads", threads)
        return output.read_bytes()


if __name__ == "__main__":
    unittest.main()
