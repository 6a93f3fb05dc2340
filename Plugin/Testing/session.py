# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What the plugin's tests share: the plugin ARRIS_PLUGIN loaded, the contour of the volume
ARRIS_VOLUME, and ways to look at data and properties."""

import os

from paraview import servermanager, simple

PLUGIN = os.environ["ARRIS_PLUGIN"]
VOLUME = os.environ["ARRIS_VOLUME"]
USED = ("UsedWindow", "UsedWindowRatio", "UsedSharpAngle", "Kappa")


def load():
    simple.LoadPlugin(PLUGIN)


def contour():
    reader = simple.MetaFileSeriesReader(FileNames=[VOLUME])
    reader.UpdatePipeline()
    surface = simple.Contour(Input=reader, ContourBy=["POINTS", reader.PointData.keys()[0]],
                             Isosurfaces=[0.0], ComputeNormals=0, ComputeScalars=0)
    surface.UpdatePipeline()
    return surface


def fetch(proxy, port=0):
    return servermanager.Fetch(proxy, idx=port)


def values(array):
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


def points_of(data, name):
    """The values of a point array of one component."""
    return [value[0] for value in values(data.GetPointData().GetArray(name))]


def same(ours, theirs, what):
    """The points, cells and arrays of two meshes are the same, but for seconds."""
    assert ours.GetNumberOfPoints() == theirs.GetNumberOfPoints() > 0, what
    assert values(ours.GetPoints().GetData()) == values(theirs.GetPoints().GetData()), what
    for cells in ("GetVerts", "GetLines", "GetPolys", "GetStrips"):
        a, b = getattr(ours, cells)(), getattr(theirs, cells)()
        assert a.GetNumberOfCells() == b.GetNumberOfCells(), (what, cells)
        assert values(a.GetConnectivityArray()) == values(b.GetConnectivityArray()), what
    for data in ("GetPointData", "GetCellData", "GetFieldData"):
        a, b = getattr(ours, data)(), getattr(theirs, data)()
        for i in range(b.GetNumberOfArrays()):
            name = b.GetArrayName(i)
            assert a.HasArray(name), (what, name)
            if not name.endswith("Seconds"):
                assert values(a.GetArray(name)) == values(b.GetArray(i)), (what, name)


def read(proxy, name):
    value = proxy.GetProperty(name).GetData()
    return value if isinstance(value, (int, float, str)) else list(value)


def used(proxy):
    """What the last update used: the window, its ratio, the angle and kappa."""
    proxy.SMProxy.UpdatePropertyInformation()
    return [proxy.GetPropertyValue(name) for name in USED]


def select(*ids):
    """A selection of points as the user's rubber band makes it: pairs of a process and an id."""
    pairs = [number for i in ids for number in (0, int(i))]
    return simple.IDSelectionSource(FieldType="POINT", IDs=pairs)


def extremes(classified):
    """The numbers of the sharpest and of the smoothest point."""
    deviation = points_of(fetch(classified), "NormalDeviation")
    return deviation.index(max(deviation)), deviation.index(min(deviation))
