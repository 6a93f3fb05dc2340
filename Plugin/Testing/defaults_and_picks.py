# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Defaults that follow the data, points picked by selections, errors, and what is not computed
again, on the contour of a volume."""

import session
from paraview import simple
from session import extremes, fetch, points_of, select, used
from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow

session.load()
contour = session.contour()


def field(proxy, name):
    return fetch(proxy).GetFieldData().GetArray(name).GetValue(0)


def check_defaults():
    """The window is 0.75 average edge lengths; its range ends at 3. Closed meshes have each edge
    twice, so the mean over triangles is that over edges."""
    ussod = simple.USSOD(Input=contour)
    edge = field(ussod, "AverageEdgeLength")
    domain = ussod.GetProperty("Window").SMProperty.FindDomain("vtkSMEdgeLengthDomain")
    assert domain.GetMinimum(0) == 0.0
    assert abs(domain.GetMaximum(0) - 3.0 * edge) < 1e-6 * edge
    for proxy in (ussod, simple.SharpEdgePreview(Input=contour)):
        assert abs(proxy.Window - 0.75 * edge) < 1e-6 * edge, (proxy.Window, edge)
    assert simple.SharpEdgeReconstruction(Input=contour).Window == 0.0

    # An input that has not been updated has no edges yet: the window is automatic.
    late = simple.USSOD(Input=simple.Sphere(ThetaResolution=20))
    assert late.Window == 0.0
    assert field(late, "Lambda") > 0.0


def check_picks():
    ussod = simple.USSOD(Input=contour)
    sharp, smooth = extremes(ussod)
    before = used(ussod)
    ussod.SharpPoints = select(sharp)
    ussod.SmoothPoints = select(smooth)
    region = points_of(fetch(ussod), "SharpRegion")
    assert (region[sharp], region[smooth]) == (1, 0)
    picked = used(ussod)
    assert picked != before
    assert field(ussod, "Lambda") == picked[0] and field(ussod, "SharpAngle") == picked[2]

    # The same vertex by other kinds of selection, and nothing when the selection is taken away.
    position = list(fetch(contour).GetPoint(sharp))
    for selection in (
            simple.LocationSelectionSource(FieldType="POINT", Locations=position),
            simple.ThresholdSelectionSource(FieldType="POINT", ArrayName="Id",
                                            Thresholds=[sharp - 0.5, sharp + 0.5])):
        numbered = simple.GenerateIds(Input=contour, PointIdsArrayName="Id")
        other = simple.USSOD(Input=numbered, Window=ussod.Window, SharpPoints=selection,
                             SmoothPoints=select(smooth))
        assert used_after_update(other) == picked, selection
    ussod.SharpPoints = None
    ussod.SmoothPoints = None
    assert used_after_update(ussod) == before


def used_after_update(proxy):
    proxy.UpdatePipeline()
    return used(proxy)


def check_picks_of_the_whole():
    paper = simple.SharpEdgeReconstruction(Input=contour, Method="Paper")
    ussod = simple.USSOD(Input=contour)
    sharp, _ = extremes(ussod)
    paper.SharpPoints = select(sharp)
    ussod.SharpPoints = select(sharp)
    assert used_after_update(paper) == used_after_update(ussod)
    assert points_of(fetch(paper), "SharpRegion") == points_of(fetch(ussod), "SharpRegion")
    robust = simple.SharpEdgeReconstruction(Input=contour, SharpPoints=select(sharp))
    assert used_after_update(robust) == used(ussod)


def check_errors(log):
    """Contradictory picks and parameters out of range: one line that says so."""
    screen = vtkOutputWindow.GetInstance()
    window = vtkFileOutputWindow()
    window.SetFileName(log)
    window.SetFlush(True)
    ussod = simple.USSOD(Input=contour)
    sharp, smooth = extremes(ussod)
    ussod.SharpPoints = select(smooth)
    ussod.SmoothPoints = select(sharp)
    vtkOutputWindow.SetInstance(window)
    ussod.UpdatePipeline()
    vtkOutputWindow.SetInstance(screen)
    assert fetch(ussod).GetNumberOfPoints() == 0
    with open(log, encoding="utf-8") as file:
        said = [line for line in file if "vtkUSSODFilter (" in line]
    assert len(said) == 1, said
    assert f"point {sharp}, picked as smooth" in said[0], said
    assert f"point {smooth}, picked as sharp" in said[0], said


def check_nothing_is_computed_twice():
    preview = simple.SharpEdgePreview(Input=contour)
    first = fetch(preview)
    assert field(preview, "ClassificationSeconds") > 0.0
    preview.SharpAngle = 60.0
    assert field(preview, "ClassificationSeconds") == 0.0
    again = fetch(preview)
    assert points_of(again, "NormalDeviation") == points_of(first, "NormalDeviation")
    assert sum(points_of(again, "SharpRegion")) < sum(points_of(first, "SharpRegion"))
    time = preview.GetClientSideObject().GetOutputDataObject(0).GetMTime()
    preview.UpdatePipeline()
    assert preview.GetClientSideObject().GetOutputDataObject(0).GetMTime() == time
    preview.Window = 1.5 * preview.Window
    assert field(preview, "ClassificationSeconds") > 0.0


check_defaults()
check_picks()
check_picks_of_the_whole()
check_nothing_is_computed_twice()
check_errors("errors.txt")
print("defaults, picks, errors: as they should be")
