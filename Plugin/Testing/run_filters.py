# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Loads the plugin, creates each filter, sets and reads each property, and runs the filters on the
contour of a volume: they must give what the VTK classes give.

    run_filters.py Arris.so bracket-small.mha
"""

import sys

import arris
from paraview import servermanager, simple
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

plugin, volume = sys.argv[1:]
simple.LoadPlugin(plugin)


def values(array):
    return [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]


def same(paraview, plain, what):
    """The points, cells and arrays of two meshes are the same, but for seconds."""
    assert paraview.GetNumberOfPoints() == plain.GetNumberOfPoints() > 0, what
    assert values(paraview.GetPoints().GetData()) == values(plain.GetPoints().GetData()), what
    for cells in ("GetVerts", "GetLines", "GetPolys"):
        ours, theirs = getattr(paraview, cells)(), getattr(plain, cells)()
        assert ours.GetNumberOfCells() == theirs.GetNumberOfCells(), (what, cells)
        assert values(ours.GetConnectivityArray()) == values(theirs.GetConnectivityArray()), what
    for data in ("GetPointData", "GetCellData", "GetFieldData"):
        ours, theirs = getattr(paraview, data)(), getattr(plain, data)()
        for i in range(theirs.GetNumberOfArrays()):
            name = theirs.GetArrayName(i)
            assert ours.HasArray(name), (what, name)
            if not name.endswith("Seconds"):
                assert values(ours.GetArray(name)) == values(theirs.GetArray(i)), (what, name)


def fetch(proxy, port=0):
    return servermanager.Fetch(proxy, idx=port)


def read(proxy, name):
    value = proxy.GetProperty(name).GetData()
    return value if isinstance(value, (int, float, str)) else list(value)


def set_and_read(proxy, **properties):
    """Each property takes a value and gives it back; then it has its default again."""
    for name, value in properties.items():
        default = read(proxy, name)
        setattr(proxy, name, value)
        assert read(proxy, name) == value, (name, read(proxy, name), value)
        assert default != value, (name, "the test must set something else than the default")
        setattr(proxy, name, default)
    known = set(proxy.ListProperties()) - {"Input", "Kappa"}
    assert known == set(properties), known ^ set(properties)


# The contour that both are given. ParaView orders its points in a way of its own.
reader = simple.MetaFileSeriesReader(FileNames=[volume])
reader.UpdatePipeline()
contour = simple.Contour(Input=reader, ContourBy=["POINTS", reader.PointData.keys()[0]],
                         Isosurfaces=[0.0], ComputeNormals=0, ComputeScalars=0)
plain_contour = vtkTrivialProducer()
plain_contour.SetOutput(fetch(contour))
triangles = fetch(contour).GetNumberOfPolys()
assert triangles > 1000

# The four steps.
ussod = simple.USSOD(Input=contour)
set_and_read(ussod, SharpAngle=30.0, Window=2.5, WindowRatio=1.5, WindowSearch="Spatial")
plain_ussod = arris.vtkUSSODFilter()
plain_ussod.SetInputConnection(plain_contour.GetOutputPort())
plain_ussod.Update()
same(fetch(ussod), plain_ussod.GetOutput(), "USSOD")
ussod.SMProxy.UpdatePropertyInformation()
assert ussod.GetPropertyValue("Kappa") == plain_ussod.GetKappa() > 0.0
region = fetch(ussod).GetPointData().GetArray("SharpRegion")
assert 0 < sum(v[0] for v in values(region)) < region.GetNumberOfTuples()

thinning = simple.SharpThinning(Input=ussod)
set_and_read(thinning)
plain_thinning = arris.vtkSharpThinningFilter()
plain_thinning.SetInputConnection(plain_ussod.GetOutputPort())
plain_thinning.Update()
same(fetch(thinning), plain_thinning.GetOutput(), "Sharp Thinning")
same(fetch(thinning, 1), plain_thinning.GetSkeleton(), "Sharp Thinning, Skeleton")

sharpening = simple.Sharpening(Input=thinning)
set_and_read(sharpening, Window=2.5, WindowRatio=1.5)
plain_sharpening = arris.vtkSharpeningFilter()
plain_sharpening.SetInputConnection(plain_thinning.GetOutputPort())
plain_sharpening.Update()
same(fetch(sharpening), plain_sharpening.GetOutput(), "Sharpening")

extractor = simple.SharpEdgeExtractor(Input=sharpening)
set_and_read(extractor, FeatureAngle=45.0, ContinuationAngle=20.0, MaximumAngle=170.0,
             CornerAngle=90.0, NoiseFactor=5.0, BoundaryEdges=0, NonManifoldEdges=0, GapLength=1.0,
             TailLength=1.0, MinimumLength=1.0, MergeTolerance=0.5, ResampleStep=1.0,
             FitPrimitives=0, FitTolerance=0.5)
plain_extractor = arris.vtkSharpEdgeExtractor()
plain_extractor.SetInputConnection(plain_sharpening.GetOutputPort())
plain_extractor.Update()
for port, name in enumerate(("Curves", "Corners", "Surfaces")):
    assert extractor.SMProxy.GetOutputPort(name).GetPortIndex() == port
    same(fetch(extractor, port), plain_extractor.GetOutput(port), f"Sharp Edge Extractor, {name}")
assert extractor.SMProxy.GetOutputPort("Faces").GetPortIndex() == 3
table, plain_table = fetch(extractor, 3), plain_extractor.GetFaces()
assert table.GetNumberOfRows() == plain_table.GetNumberOfRows() > 0
for i in range(plain_table.GetNumberOfColumns()):
    ours = table.GetColumnByName(plain_table.GetColumnName(i))
    for row in range(plain_table.GetNumberOfRows()):
        theirs = plain_table.GetColumn(i).GetVariantValue(row)
        assert ours.GetVariantValue(row) == theirs, (plain_table.GetColumnName(i), row)

# And all in one, with the values that an enumeration shows.
one_click = simple.SharpEdgeReconstruction(Input=contour)
set_and_read(one_click, Method="Paper", SharpAngle=30.0, Window=2.5, WindowRatio=1.5,
             WindowSearch="Spatial")
plain_one_click = arris.vtkSharpEdgeReconstruction()
plain_one_click.SetInputConnection(plain_contour.GetOutputPort())
for method in ("Robust", "Paper"):
    one_click.Method = method
    getattr(plain_one_click, "SetMethodTo" + method)()
    plain_one_click.Update()
    same(fetch(one_click), plain_one_click.GetOutput(), f"Sharp Edge Reconstruction, {method}")
    assert fetch(one_click).GetNumberOfPolys() == triangles
print(f"{triangles} triangles: ParaView and VTK agree")
