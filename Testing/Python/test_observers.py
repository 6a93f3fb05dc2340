# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Progress and abort from observers written in Python: they run on the caller's thread."""

import threading
import unittest

import meshes
from arris import vtkSharpEdgeReconstruction


class Observers(unittest.TestCase):
    def setUp(self):
        self.filter = vtkSharpEdgeReconstruction()
        self.filter.SetInputData(meshes.bracket(40))
        self.reports = []

    def test_progress_rises_to_one_on_this_thread(self):
        def listen(caller, event):
            self.reports.append(caller.GetProgress())
            self.assertIs(threading.current_thread(), threading.main_thread())

        self.filter.AddObserver("ProgressEvent", listen)
        self.filter.Update()
        self.assertEqual(self.reports, sorted(self.reports))
        self.assertEqual(self.reports[-1], 1.0)
        self.assertGreater(len(self.reports), 3)

    def test_abort_leaves_nothing_and_the_next_run_is_whole(self):
        def stop(caller, event):
            if caller.GetProgress() > 0.5:
                caller.SetAbortExecute(1)

        tag = self.filter.AddObserver("ProgressEvent", stop)
        self.filter.Update()
        self.assertEqual(self.filter.GetOutput().GetNumberOfPoints(), 0)
        self.filter.RemoveObserver(tag)
        self.filter.Modified()
        self.filter.Update()
        self.assertEqual(
            self.filter.GetOutput().GetNumberOfPoints(), self.filter.GetInput().GetNumberOfPoints()
        )


if __name__ == "__main__":
    unittest.main()
