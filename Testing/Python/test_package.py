# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The package `arris` as a script imports it."""

import subprocess
import sys
import unittest

import arris

FILTERS = [
    "vtkSharpEdgeExtractor",
    "vtkSharpEdgeReconstruction",
    "vtkSharpThinningFilter",
    "vtkSharpeningFilter",
    "vtkUSSODFilter",
]


class Package(unittest.TestCase):
    def test_holds_all_filters(self):
        for name in FILTERS:
            with self.subTest(name):
                self.assertEqual(getattr(arris, name)().GetClassName(), name)

    def test_imports_first_without_vtk(self):
        # In a fresh interpreter: nothing else has loaded VTK's classes before.
        for name in FILTERS:
            with self.subTest(name):
                script = f"from arris import {name}; print({name}().GetClassName())"
                run = subprocess.run(
                    [sys.executable, "-c", script], capture_output=True, text=True, check=False
                )
                self.assertEqual(run.stdout.strip(), name, run.stderr)

    def test_filters_are_vtk_algorithms(self):
        from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

        for name in FILTERS:
            self.assertIsInstance(getattr(arris, name)(), vtkPolyDataAlgorithm)

    def test_filters_are_documented(self):
        for name in FILTERS:
            self.assertGreater(len(getattr(arris, name).__doc__), 200, name)


if __name__ == "__main__":
    unittest.main()
