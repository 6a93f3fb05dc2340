# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""scripts/shrink leaves of a mesh what makes a command go wrong, and no more."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import meshes
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

SHRINK = Path(__file__).resolve().parents[2] / "scripts" / "shrink"
BAD = (1.5, 1.25, 1.75)


class Shrink(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.mesh = meshes.box(8)
        self.mesh.GetPoints().SetPoint(50, BAD)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.folder / "box.vtp"))
        writer.SetInputData(self.mesh)
        writer.Write()

    def shrink(self, *command):
        return subprocess.run(
            [sys.executable, SHRINK, "box.vtp", "-o", "small.vtp", "--", *command],
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=False,
        )

    def test_leaves_one_triangle_at_the_point_that_matters(self):
        run = self.shrink("sh", "-c", "! grep -q '1.5 1.25 1.75' {}")
        self.assertEqual(run.returncode, 0, run.stderr)
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "small.vtp"))
        reader.Update()
        small = reader.GetOutput()
        self.assertEqual(small.GetNumberOfPolys(), 1)
        self.assertEqual(small.GetNumberOfPoints(), 3)
        points = vtk_to_numpy(small.GetPoints().GetData())
        self.assertTrue((points == BAD).all(axis=1).any())
        self.assertEqual(points.dtype, numpy.float32)

    def test_says_when_nothing_goes_wrong(self):
        run = self.shrink("true", "{}")
        self.assertEqual(run.returncode, 1)
        self.assertIn("does not go wrong", run.stderr)
        self.assertFalse((self.folder / "small.vtp").exists())


if __name__ == "__main__":
    unittest.main()
