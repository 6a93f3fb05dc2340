# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the program ARRIS_PROGRAM in a temporary folder, and reads and writes files for it."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import meshes
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkMetaImageWriter
from vtkmodules.vtkIOLegacy import (
    vtkPolyDataReader,
    vtkPolyDataWriter,
    vtkStructuredPointsWriter,
)
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
)

PROGRAM = Path(os.environ["ARRIS_PROGRAM"]).resolve()
DATA = Path(os.environ["ARRIS_DATA"]).resolve()
BRACKET = DATA / "bracket-small.mha"

READERS = {
    ".vtp": vtkXMLPolyDataReader,
    ".vtk": vtkPolyDataReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".obj": vtkOBJReader,
}
MESH_WRITERS = {
    ".vtp": vtkXMLPolyDataWriter,
    ".vtk": vtkPolyDataWriter,
    ".ply": vtkPLYWriter,
    ".stl": vtkSTLWriter,
    ".obj": vtkOBJWriter,
}
VOLUME_WRITERS = {
    ".vti": vtkXMLImageDataWriter,
    ".mha": vtkMetaImageWriter,
    ".mhd": vtkMetaImageWriter,
    ".vtk": vtkStructuredPointsWriter,
}

# The edges and the volume of the box, as it was before sampling.
BOX = {"curves": 12, "corners": 8, "surfaces": 6}
BOX_CURVE_LENGTH = 8.0 * (0.6 + 0.5 + 0.45)
BOX_VOLUME = 8.0 * 0.6 * 0.5 * 0.45


def box_volume(samples=20, sign=1):
    """The volume that meshes.box(samples) is the contour of: positive inside, times the sign."""
    axis = numpy.linspace(-1.0, 1.0, samples)
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    values = sign * meshes.box_distance(*meshes.turned(x, y, z), (0.6, 0.5, 0.45))
    image = vtkImageData()
    image.SetDimensions(samples, samples, samples)
    image.SetOrigin(-1.0, -1.0, -1.0)
    image.SetSpacing([axis[1] - axis[0]] * 3)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return image


def signed_volume(mesh):
    corners = meshes.points(mesh)[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())]
    a, b, c = corners.reshape(-1, 3, 3).astype(float).transpose(1, 0, 2)
    return numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6.0


class ProgramTest(unittest.TestCase):
    """Every test has a folder of its own, with box.vtp in it; the program runs there."""

    maxDiff = None

    def setUp(self):
        whole = tempfile.TemporaryDirectory(prefix="arris-test-")
        self.addCleanup(whole.cleanup)
        self.folder = Path(whole.name) / "work"
        self.scratch = Path(whole.name) / "scratch"  # for the program's own temporary files
        self.folder.mkdir()
        self.scratch.mkdir()
        self.write("box.vtp", meshes.box(20))

    def tearDown(self):
        self.assertEqual(os.listdir(self.scratch), [], "temporary files were left over")

    def write(self, name, data):
        """Writes text, bytes, a mesh or a volume."""
        path = self.folder / name
        if isinstance(data, (str, bytes)):
            path.write_bytes(data.encode() if isinstance(data, str) else data)
            return
        writers = VOLUME_WRITERS if isinstance(data, vtkImageData) else MESH_WRITERS
        writer = writers[path.suffix]()
        writer.SetInputData(data)
        writer.SetFileName(str(path))
        writer.Write()

    def read(self, name):
        path = self.folder / name
        self.assertTrue(path.is_file(), name)
        reader = READERS[path.suffix.lower()]()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutput()

    def read_json(self, name):
        return json.loads((self.folder / name).read_text())

    def files(self):
        return {
            str(path.relative_to(self.folder)): path.read_bytes() if path.is_file() else None
            for path in self.folder.rglob("*")
        }

    def run_program(self, *arguments, **options):
        """Without a display, whatever the test runs on."""
        environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
        environment["TMPDIR"] = str(self.scratch)
        environment.update(options.pop("environment", {}))
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            env=environment,
            text=True,
            check=False,
            timeout=300,
            **options,
        )

    def run_in_own_mounts(self, script):
        """A shell script with the program as $0, where it may mount; skips where nobody may."""
        run = subprocess.run(
            ["unshare", "-rm", "sh", "-c", script, PROGRAM],
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=False,
        )
        if "unshare" in run.stderr or run.returncode == 9:
            self.skipTest("may not mount: " + run.stderr)
        return run

    def assert_done(self, *arguments, **options):
        """Exit status 0 and nothing on standard error. Returns standard output."""
        run = self.run_program(*arguments, **options)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def assert_one_line(self, run, status, text):
        """That exit status, and one line on standard error with `arris: ` and the text."""
        self.assertEqual(run.returncode, status, run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        self.assertEqual(run.stderr[: len(text) + 7], "arris: " + text)
        self.assertTrue(run.stderr.endswith("\n"), run.stderr)

    def assert_fails(self, text, *arguments, status=1, **options):
        """No file is made, changed or left over either."""
        before = self.files()
        run = self.run_program(*arguments, **options)
        self.assert_one_line(run, status, text)
        self.assertRegex(run.stderr, "; .+")  # there is advice
        after = self.files()
        self.assertEqual(sorted(after), sorted(before))
        self.assertTrue(after == before, "a file was changed")
