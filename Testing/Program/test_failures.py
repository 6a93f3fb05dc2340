# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Whatever fails is said in one line that names the file; no output file is made or changed."""

import os
import unittest

import meshes
from program import BRACKET, ProgramTest
from vtkmodules.vtkCommonDataModel import vtkPolyData

READ = "{}: cannot be read: "
POINTS = (
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\n{}end_header\n0 0 0\n1 0 0\n0 1 0\n"
)
FACES = "element face 1\nproperty list uchar int vertex_indices\n"
POINTS_ONLY = POINTS.format("")
MISSING_POINT = POINTS.format(FACES) + "3 0 1 7\n"


class Failures(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("old.vtp", "what was there before")

    def assert_sharpen_fails(self, name, text):
        for output in ("new.vtp", "old.vtp"):
            with self.subTest(name, output=output):
                self.assert_fails(text.format(name), "sharpen", name, "-o", output)

    def assert_contour_fails(self, name, text, value="0"):
        for output in ("new.vtp", "old.vtp"):
            with self.subTest(name, output=output):
                args = ("contour", name, "--value", value, "-o", output)
                self.assert_fails(text.format(name), *args)

    def test_input_that_is_not_there(self):
        self.assert_sharpen_fails("missing.ply", READ + "no such file; check its name")
        self.assert_contour_fails("missing.mha", READ + "no such file; check its name")

    def test_input_that_is_no_file(self):
        self.assert_sharpen_fails(".", READ + "it is not a regular file")

    def test_empty_files(self):
        for name in ("empty.ply", "empty.stl", "empty.vtp"):
            self.write(name, "")
            self.assert_sharpen_fails(name, READ + "the file is empty")

    def test_unknown_extensions(self):
        text = "{} is not a mesh format that Arris knows by its extension; use .vtp".format
        for name in ("x.xyz", "noext"):
            self.assert_fails(text(name + ":"), "sharpen", "box.vtp", "-o", name)
            self.write(name, "1 2 3\n")
            self.assert_sharpen_fails(name, text("{}:"))
        self.assert_contour_fails("box.vtp", "{}: is not a volume format that Arris knows")

    def test_cut_meshes(self):
        for suffix, cause in (
            (".ply", "it ends at face "),
            (".stl", "it ends after "),
            (".vtp", "Error parsing XML"),
            (".vtk", "Error reading binary data"),
        ):
            self.assert_done("sharpen", "box.vtp", "-o", "whole" + suffix, "--method", "paper")
            whole = (self.folder / ("whole" + suffix)).read_bytes()
            self.write("cut" + suffix, whole[: len(whole) * 2 // 3])
            self.assert_sharpen_fails("cut" + suffix, READ + cause)

    def test_cut_volume(self):
        whole = BRACKET.read_bytes()
        self.write("cut.mha", whole[: len(whole) // 2])
        self.assert_contour_fails("cut.mha", READ + "MetaImage: M_ReadElementsData: data not read")

    def test_files_that_are_no_meshes(self):
        for suffix, text in (
            (".ply", READ + "it does not begin as a PLY file"),
            (".stl", READ + "it does not begin as an STL file"),
            (".vtp", READ),
            (".vtk", "{}: is not a legacy VTK file with polygonal data"),
            (".obj", "{}: "),
        ):
            self.write("junk" + suffix, "To be, or not to be, that is the question.\n" * 9)
            self.assert_sharpen_fails("junk" + suffix, text)

    def test_files_that_are_no_volumes(self):
        for suffix in (".vti", ".mha", ".nrrd", ".vtk"):
            text = "{}: is not" if suffix == ".vtk" else READ
            self.write("junk" + suffix, "To be, or not to be, that is the question.\n" * 9)
            self.assert_contour_fails("junk" + suffix, text)

    def test_no_triangles(self):
        self.write("points.ply", POINTS_ONLY)
        none = vtkPolyData()
        none.SetPoints(self.read("box.vtp").GetPoints())
        self.write("none.vtp", none)
        for name in ("points.ply", "none.vtp"):
            self.assert_sharpen_fails(name, "{}: holds no triangles; give a mesh")

    def test_meshes_that_do_not_hold_together(self):
        self.write("missing-point.ply", MISSING_POINT)
        self.assert_sharpen_fails("missing-point.ply", "{}: has a cell that names a point that is")
        mesh = meshes.copy(self.read("box.vtp"))
        mesh.GetPoints().SetPoint(2, float("nan"), 0.0, 0.0)
        self.write("nan.vtp", mesh)
        self.assert_sharpen_fails("nan.vtp", "{}: point 2 has a coordinate that is not a finite")

    def test_damaged_obj(self):
        head = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        for text, cause in (
            (head + "f 1 2 9\n", "a face names v 9, but there are 3"),
            (head + "f 1 2 0\n", "line 4 names '0', which is not there"),
            ("v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n", "line 3 does not hold 3 finite numbers"),
        ):
            self.write("bad.obj", text)
            self.assert_sharpen_fails("bad.obj", READ + cause)

    def test_places_that_cannot_be_written(self):
        (self.folder / "folder.vtp").mkdir()
        for output, cause in (
            ("no/folder/x.vtp", "No such file or directory; make its folder first"),
            ("box.vtp/x.vtp", "Not a directory; write to another place"),
            ("folder.vtp", "it is a folder; give the name of a file"),
        ):
            with self.subTest(output):
                text = f"{output}: cannot be written: {cause}"
                self.assert_fails(text, "sharpen", "box.vtp", "-o", output)

    @unittest.skipIf(os.geteuid() == 0, "root may do everything")
    def test_permissions(self):
        (self.folder / "closed").mkdir(mode=0o555)
        text = "closed/x.vtp: cannot be written: Permission denied"
        self.assert_fails(text, "sharpen", "box.vtp", "-o", "closed/x.vtp")
        (self.folder / "box.vtp").chmod(0)
        run = self.run_program("sharpen", "box.vtp", "-o", "new.vtp")
        self.assert_one_line(run, 1, "box.vtp: cannot be read: Permission denied")

    def test_no_space_left(self):
        # In a mount namespace of its own: a disk of 16 kB, with a file on it already.
        script = (
            "mkdir full && mount -t tmpfs -o size=16k none full || exit 9\n"
            "echo old > full/old.vtp\n"
            '"$0" sharpen box.vtp -q -o full/new.vtp; echo $?\n'
            '"$0" sharpen box.vtp -q -o full/old.vtp; echo $?\n'
            "cat full/*; ls -A full"
        )
        run = self.run_in_own_mounts(script)
        self.assertEqual(run.stdout, "1\n1\nold\nold.vtp\n")
        lines = run.stderr.splitlines()
        self.assertEqual(len(lines), 2, run.stderr)
        for name, line in zip(("new", "old"), lines):
            text = f"arris: full/{name}.vtp: cannot be written: No space left on device; free some"
            self.assertEqual(line[: len(text)], text)

    def test_standard_output_is_full(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            run = self.run_program("compare", "box.vtp", "box.vtp", stdout=full)
        self.assert_one_line(run, 1, "standard output: cannot be written; send it")

    def test_formats_that_cannot_hold_the_result(self):
        for command, text in (
            ("classify", "x.ply: .ply files cannot hold arrays"),
            ("regions", "x.ply: .ply files cannot hold arrays"),
            ("edges", "x.ply: .ply files cannot hold curves; use .vtp, .vtk, .obj, .csv or .eMesh"),
        ):
            self.assert_fails(text, command, "box.vtp", "-o", "x.ply")
        text = "x.vtp: is no table format that Arris writes; use .csv"
        for command in ("edges", "regions"):
            self.assert_fails(text, command, "box.vtp", "-o", "y.vtp", "--faces", "x.vtp")
        text = "x.jpg: is not a picture format that Arris writes; use .png"
        self.assert_fails(text, "edges", "box.vtp", "-o", "x.vtp", "--picture", "x.jpg")

    def test_triangles_that_share_nothing(self):
        self.write("soup.ply", meshes.soup(0.1))
        text = "soup.ply: no two triangles share an edge"
        for command in ("edges", "regions"):
            self.assert_fails(text, command, "soup.ply", "-o", "x.vtp")
        self.assert_done("edges", "soup.ply", "-o", "x.vtp", "--merge-tolerance", "0.2")

    def test_json_is_not_written_on_failure(self):
        self.write("old.json", "{}")
        args = ("sharpen", "missing.ply", "-o", "new.vtp", "--json")
        self.assert_fails("missing.ply: ", *args, "old.json")
        self.assert_fails("missing.ply: ", *args, "new.json")

    def test_a_value_without_a_surface(self):
        text = f"{BRACKET}: has no surface at the value 1e+09; give a --value between -11.9998 and"
        self.assert_contour_fails(BRACKET, text, value="1e9")

    def test_compare_with_no_area(self):
        self.write("points.ply", POINTS_ONLY)
        for args in (("points.ply", "box.vtp"), ("box.vtp", "points.ply")):
            run = self.run_program("compare", *args)
            self.assert_one_line(run, 1, "")
            self.assertIn("points.ply", run.stderr)

    def test_a_picture_without_a_display(self):
        args = ("edges", "box.vtp", "-o", "edges.vtp", "--json", "e.json", "--picture", "e.png")
        run = self.run_program(*args)
        self.assert_one_line(run, 1, "e.png: cannot be drawn: there is no X display that VTK can")
        self.assertGreater(self.read("edges.vtp").GetNumberOfLines(), 0)
        self.assertEqual(self.read_json("e.json")["output"], "edges.vtp")
        self.assertNotIn("e.png", self.files())


if __name__ == "__main__":
    unittest.main()
