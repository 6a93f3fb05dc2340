# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Curves, corners and faces in the files that other programs read."""

import csv
import re
import unittest

import meshes
import numpy
from program import ProgramTest

# Eight corners and twelve edges, the unit cube's.
CORNERS = {(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)}


def edge_mesh(text):
    """Points and edges of an OpenFOAM featureEdgeMesh in ASCII, read by its grammar: a dictionary
    FoamFile, then two lists, each its length and its items in parentheses; comments anywhere."""
    text = re.sub(r"//[^\n]*", " ", text)
    header, rest = re.fullmatch(r"\s*FoamFile\s*\{(.*?)\}(.*)", text, re.DOTALL).groups()
    entries = dict(re.findall(r"(\w+)\s+([^;]+);", header))
    lists = re.findall(r"(\d+)\s*\(((?:\s*\([^()]*\))*)\s*\)", rest)
    assert len(lists) == 2 and not re.sub(r"[\d.()eE+\s-]", "", rest), rest
    parsed = []
    for count, body in lists:
        items = [tuple(map(float, item.split())) for item in re.findall(r"\(([^()]*)\)", body)]
        assert len(items) == int(count)
        parsed.append(items)
    return entries, parsed[0], [tuple(map(int, edge)) for edge in parsed[1]]


class Features(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.stl", meshes.soup())

    def rows(self, name):
        with open(self.folder / name, encoding="ascii", newline="") as file:
            return list(csv.DictReader(file))

    def test_tables(self):
        self.assert_done(
            *("edges", "cube.stl", "-o", "curves.csv"),
            *("--corners", "corners.csv", "--faces", "faces.csv"),
        )
        curves = self.rows("curves.csv")
        self.assertEqual([int(row["CurveId"]) for row in curves], list(range(12)))
        for row in curves:
            self.assertEqual(float(row["Length"]), 1.0)
            self.assertAlmostEqual(float(row["DihedralAngle"]), 90.0, places=4)
            self.assertEqual((row["CurveKind"], row["Closed"]), ("convex", "0"))
            self.assertLess(int(row["LeftSurfaceId"]), int(row["RightSurfaceId"]))
        corners = self.rows("corners.csv")
        places = {tuple(float(row[f"Point:{i}"]) for i in range(3)) for row in corners}
        self.assertEqual(places, CORNERS)
        for row in corners:
            self.assertEqual((row["Valence"], row["CornerKind"], row["Tip"]), ("3", "convex", "0"))
            self.assertEqual(len({row[f"CurveIds:{i}"] for i in range(3)}), 3)
        faces = self.rows("faces.csv")
        self.assertEqual([int(row["SurfaceId"]) for row in faces], list(range(6)))
        for row in faces:
            self.assertEqual((row["Primitive"], row["Triangles"]), ("plane", "2"))
            self.assertEqual((float(row["Area"]), row["BoundaryLoops"]), (1.0, "1"))
            self.assertAlmostEqual(float(row["Residual"]), 0.0)

    def test_table_of_regions(self):
        self.assert_done("regions", "cube.stl", "-o", "regions.vtp", "--faces", "faces.csv")
        self.assertEqual([row["Primitive"] for row in self.rows("faces.csv")], ["plane"] * 6)

    def test_feature_edges_for_openfoam(self):
        self.assert_done("edges", "cube.stl", "-o", "cube.eMesh")
        entries, points, edges = edge_mesh((self.folder / "cube.eMesh").read_text("ascii"))
        self.assertEqual(
            entries,
            {
                "version": "2.0",
                "format": "ascii",
                "class": "featureEdgeMesh",
                "object": "cube.eMesh",
            },
        )
        self.assertEqual(sorted(points), sorted(CORNERS), "each of them once")
        self.assertEqual(len(set(map(frozenset, edges))), 12)
        for a, b in edges:
            self.assertEqual(numpy.abs(numpy.subtract(points[a], points[b])).sum(), 1.0)

    def test_names_that_openfoam_could_not_read(self):
        self.assert_done("edges", "cube.stl", "-o", "my (cube); {1}.eMesh")
        entries, _, _ = edge_mesh((self.folder / "my (cube); {1}.eMesh").read_text("ascii"))
        self.assertEqual(entries["object"], "my__cube____1_.eMesh")

    def test_lines(self):
        self.assert_done("edges", "cube.stl", "-o", "cube.obj")
        lines = [s.split() for s in (self.folder / "cube.obj").read_text("ascii").splitlines()]
        points = [tuple(map(float, line[1:])) for line in lines if line and line[0] == "v"]
        edges = [tuple(map(int, line[1:])) for line in lines if line and line[0] == "l"]
        self.assertEqual(set(points), CORNERS)
        self.assertEqual(len(edges), 12)
        for a, b in edges:
            self.assertEqual(numpy.abs(numpy.subtract(points[a - 1], points[b - 1])).sum(), 1.0)

    def test_resampled(self):
        self.assert_done("edges", "cube.stl", "-o", "fine.vtp", "--resample", "0.1")
        self.assertEqual(self.read("fine.vtp").GetNumberOfPoints(), 12 * 11)

    def test_options_reach_the_filter(self):
        open_box = meshes.copy(self.read("cube.stl"))
        open_box.BuildCells()
        open_box.DeleteCell(0)
        open_box.DeleteCell(1)
        open_box.RemoveDeletedCells()
        self.write("open.ply", open_box)
        for options, curves in (
            ((), 12),
            (("--no-boundary",), 8),
            (("--no-boundary", "--feature-angle", "100"), 0),
            (("--no-boundary", "--maximum-angle", "80"), 0),
            (("--no-boundary", "--minimum-length", "2"), 0),
            (("--no-boundary", "--corner-angle", "180", "--tail", "0", "--gap", "0"), 8),
        ):
            with self.subTest(options):
                said = self.assert_done("edges", "open.ply", "-o", "open.vtp", *options)
                self.assertIn(f"features: {curves} curves", said)

    def test_wrong_options(self):
        for option, value in (("--tail", "-1"), ("--resample", "0"), ("--noise-factor", "nan")):
            run = self.run_program("edges", "cube.stl", "-o", "x.vtp", option, value)
            self.assert_one_line(run, 2, f"{option}: ")
        run = self.run_program("edges", "cube.stl", "-o", "x.vtp", "--continuation-angle", "31")
        self.assert_one_line(run, 1, "cube.stl: ContinuationAngle must be from 0 to FeatureAngle")


if __name__ == "__main__":
    unittest.main()
