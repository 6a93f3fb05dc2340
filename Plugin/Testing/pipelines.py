# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Time series, collections of meshes, progress and abort."""

import session
from paraview import simple
from session import fetch, values

session.load()
contour = session.contour()


def check_time():
    """A mesh that grows with time is recovered at each step as it would be alone."""
    source = simple.ProgrammableSource(OutputDataSetType="vtkPolyData")
    source.ScriptRequestInformation = """
executive = self.GetExecutive()
info = executive.GetOutputInformation(0)
info.Remove(executive.TIME_STEPS())
for time in (1.0, 2.0, 3.0):
    info.Append(executive.TIME_STEPS(), time)
info.Remove(executive.TIME_RANGE())
info.Append(executive.TIME_RANGE(), 1.0)
info.Append(executive.TIME_RANGE(), 3.0)
"""
    source.Script = """
from vtkmodules.vtkFiltersSources import vtkConeSource
info = self.GetExecutive().GetOutputInformation(0)
time = info.Get(self.GetExecutive().UPDATE_TIME_STEP())
cone = vtkConeSource()
cone.SetResolution(12)
cone.SetHeight(time)
cone.Update()
self.GetOutput().ShallowCopy(cone.GetOutput())
"""
    recovery = simple.SharpEdgeReconstruction(Input=source)
    recovery.UpdatePipelineInformation()
    information = recovery.GetClientSideObject().GetOutputInformation(0)
    times = information.Get(recovery.GetClientSideObject().GetExecutive().TIME_STEPS())
    assert list(times) == [1.0, 2.0, 3.0], times
    heights = []
    for time in times:
        recovery.UpdatePipeline(time)
        bounds = fetch(recovery).GetBounds()
        heights.append(round(bounds[1] - bounds[0], 6))
    assert heights == [1.0, 2.0, 3.0], heights


def check_collection():
    """The meshes of a collection are one assembly, and keep the collection's structure."""
    sphere = simple.Sphere(ThetaResolution=20)
    group = simple.GroupDatasets(Input=[contour, sphere],
                                 OutputType="vtkPartitionedDataSetCollection")
    one = simple.SharpEdgeReconstruction(Input=simple.AppendGeometry(Input=[contour, sphere]))
    whole = simple.SharpEdgeReconstruction(Input=group)
    whole.UpdatePipeline()
    together = whole.GetClientSideObject().GetOutputDataObject(0)
    assert together.IsA("vtkPartitionedDataSetCollection"), together.GetClassName()
    assert together.GetNumberOfPartitionedDataSets() == 2
    points = []
    for i in range(2):
        points += values(together.GetPartitionAsDataObject(i, 0).GetPoints().GetData())
    assert points == list(values(fetch(one).GetPoints().GetData()))


def check_progress_and_abort():
    recovery = simple.SharpEdgeReconstruction(Input=contour)
    recovery.UpdatePipeline()
    expected = values(fetch(recovery).GetPoints().GetData())
    filter_ = recovery.GetClientSideObject()
    heard = []
    filter_.AddObserver("ProgressEvent", lambda caller, event: heard.append(caller.GetProgress()))
    filter_.Modified()
    filter_.Update()
    assert len(heard) > 5 and heard == sorted(heard) and heard[-1] == 1.0, heard

    tag = filter_.AddObserver("ProgressEvent", lambda caller, event: caller.SetAbortExecute(True))
    filter_.Modified()
    filter_.Update()
    assert filter_.GetOutput().GetNumberOfPoints() == 0
    filter_.RemoveObserver(tag)
    filter_.SetAbortExecute(False)
    filter_.Modified()
    filter_.Update()
    assert values(filter_.GetOutput().GetPoints().GetData()) == expected


check_time()
check_collection()
check_progress_and_abort()
print("time, collections, progress and abort work")
