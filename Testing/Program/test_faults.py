# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Files that end too early, disks that are full, limits, kills: an error, and the old file stays."""

import os
import random
import resource
import shutil
import signal
import subprocess
import time
import unittest

import meshes
from program import MESH_WRITERS, PROGRAM, VOLUME_WRITERS, ProgramTest, box_volume

OLD = "what was there before"


def limit(kind, value):
    return lambda: resource.setrlimit(kind, (value, value))


class Faults(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("old.vtp", OLD)

    def assert_cut(self, name, whole, *arguments, may_pass=False):
        """Cut anywhere, a file is refused in one line. Text without a count may end after a line.

        The last tenth is left whole: there may be but the closing tags and empty lines.
        """
        places = random.Random(name)
        cuts = [1] + [places.randrange(2, len(whole) * 9 // 10) for _ in range(4)]
        for cut in cuts:
            with self.subTest(name, cut=cut, of=len(whole)):
                self.write(name, whole[:cut])
                run = self.run_program(*arguments)
                if not (may_pass and run.returncode == 0):
                    self.assert_one_line(run, 1, name + ": ")
                self.assertEqual((self.folder / "old.vtp").read_text(), OLD)
                (self.folder / "new.vtp").unlink(missing_ok=True)

    def whole(self, name, data, binary):
        path = self.folder / name
        writers = MESH_WRITERS if data.IsA("vtkPolyData") else VOLUME_WRITERS
        writer = writers[path.suffix]()
        for switch in (
            "SetFileTypeToBinary" if binary else "SetFileTypeToASCII",
            "SetDataModeToAppended" if binary else "SetDataModeToAscii",
        ):
            if hasattr(writer, switch):
                getattr(writer, switch)()
        writer.SetInputData(data)
        writer.SetFileName(str(path))
        writer.Write()
        return path.read_bytes()

    def test_cut_meshes(self):
        mesh = meshes.box(8)
        for suffix in MESH_WRITERS:
            for binary in (False, True):
                name = f"cut{'-binary' * binary}{suffix}"
                whole = self.whole(name, mesh, binary)
                args = (name, "-o", "new.vtp", "-q")
                self.assert_cut(name, whole, "sharpen", *args, may_pass=suffix == ".obj")

    def test_cut_volumes(self):
        volume = box_volume(8)
        for suffix in (".vti", ".mha", ".vtk"):
            for binary in (False, True):
                name = f"cut{'-binary' * binary}{suffix}"
                whole = self.whole(name, volume, binary)
                args = ("contour", name, "--value=0", "-o", "new.vtp", "-q")
                self.assert_cut(name, whole, *args)
        header = (
            "NRRD0004\ntype: float\ndimension: 3\nsizes: 8 8 8\nendian: little\nencoding: raw\n\n"
        )
        whole = header.encode() + bytes(4 * 8**3)
        self.assert_cut("cut.nrrd", whole, "contour", "cut.nrrd", "--value=0", "-o", "new.vtp")

    def test_cut_values_beside_their_header(self):
        self.whole("cut.mhd", box_volume(8), True)
        data = next(path for path in self.folder.glob("cut.*") if path.suffix != ".mhd")
        whole = data.read_bytes()
        for cut in (0, 1, len(whole) // 2, len(whole) * 9 // 10):
            with self.subTest(cut=cut, of=len(whole)):
                data.write_bytes(whole[:cut])
                run = self.run_program("contour", "cut.mhd", "--value=0", "-o", "old.vtp", "-q")
                self.assert_one_line(run, 1, "cut.mhd: ")
                self.assertEqual((self.folder / "old.vtp").read_text(), OLD)

    def test_header_without_an_end(self):
        """VTK's reader would look for it for ever."""
        for text in ("NRRD", "NRRD0004\ntype: float\ndimension: 3\nsizes: 8 8 8", "NRRD0004\n"):
            self.write("endless.nrrd", text)
            text = "endless.nrrd: cannot be read: its header does not end"
            self.assert_fails(text, "contour", "endless.nrrd", "--value=0", "-o", "new.vtp")

    def test_limit_of_the_size_of_files(self):
        for suffix in MESH_WRITERS:
            if suffix == ".vtp":
                continue  # its own test, below
            for stem in ("old", "new"):
                name = stem + suffix
                if stem == "old":
                    self.write(name, OLD)
                with self.subTest(name):
                    self.assert_fails(
                        f"{name}: cannot be written: File too large; raise",
                        *("sharpen", "box.vtp", "-q", "-o", name),
                        preexec_fn=limit(resource.RLIMIT_FSIZE, 20000),
                    )
        args = ("edges", "box.vtp", "-q", "-o", "new.eMesh")
        text = "new.eMesh: cannot be written: File too large"
        self.assert_fails(text, *args, preexec_fn=limit(resource.RLIMIT_FSIZE, 1000))

    def test_limit_where_the_writer_crashes(self):
        """As VTK's for .vtp does; the link to its file in memory is then left over."""
        text = "old.vtp: cannot be written: its writer has failed"
        args = ("sharpen", "box.vtp", "-q", "-o", "old.vtp")
        self.assert_fails(text, *args, preexec_fn=limit(resource.RLIMIT_FSIZE, 20000))
        for path in self.scratch.glob("arris-*"):
            shutil.rmtree(path)

    def test_limit_of_memory(self):
        # So much that the program starts, and so little that this mesh does not fit.
        self.write("large.ply", meshes.box(150))
        refused = 0
        for megabytes in (70, 80, 90, 100, 400):
            with self.subTest(megabytes):
                before = self.files()
                run = self.run_program(
                    *("sharpen", "large.ply", "-q", "-o", "old.vtp", "--threads", 1),
                    preexec_fn=limit(resource.RLIMIT_AS, megabytes << 20),
                )
                if run.returncode in (0, 127):  # it fits, or not even the program does
                    self.write("old.vtp", OLD)
                    continue
                refused += 1
                self.assert_one_line(run, 1, "out of memory; use a machine with more")
                self.assertTrue(self.files() == before)
        self.assertGreater(refused, 0)

    def test_read_only_folder(self):
        run = self.run_in_own_mounts(
            "mkdir closed && mount -t tmpfs none closed && echo old > closed/old.vtp &&"
            " mount -o remount,ro closed || exit 9\n"
            "for name in old new; do\n"
            '  "$0" sharpen box.vtp -q -o closed/$name.vtp; echo $?\n'
            "done\n"
            "cat closed/*; ls -A closed"
        )
        self.assertEqual(run.stdout, "1\n1\nold\nold.vtp\n")
        for name, line in zip(("old", "new"), run.stderr.splitlines()):
            text = f"arris: closed/{name}.vtp: cannot be written: Read-only file system; write to"
            self.assertEqual(line[: len(text)], text)

    def test_kill_at_any_time(self):
        """What is at the output's name is the old file or the new one, whole."""
        start = time.monotonic()
        self.assert_done("sharpen", "box.vtp", "-q", "-o", "whole.vtp")
        duration = time.monotonic() - start
        whole = (self.folder / "whole.vtp").read_bytes()
        for i in range(12):
            with self.subTest(i):
                self.write("old.vtp", OLD)
                args = [PROGRAM, "sharpen", "box.vtp", "-q", "-o", "old.vtp"]
                with subprocess.Popen(args, cwd=self.folder) as process:
                    time.sleep(duration * (0.4 + 0.06 * i))  # around when it writes
                    process.send_signal(signal.SIGKILL)
                found = (self.folder / "old.vtp").read_bytes()
                self.assertIn(found, (OLD.encode(), whole))
        self.assertEqual(os.listdir(self.scratch), [])


if __name__ == "__main__":
    unittest.main()
