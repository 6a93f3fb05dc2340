# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Loads the plugin, creates each filter, sets and reads each property, and runs the filters on the
contour of a volume: they must give what the VTK classes give."""

import arris
import session
from paraview import simple
from session import fetch, read, same, used, values
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

session.load()


def set_and_read(proxy, **properties):
    """Each property takes a value and gives it back; then it has its default again."""
    for name, value in properties.items():
        default = read(proxy, name)
        setattr(proxy, name, value)
        assert read(proxy, name) == value, (name, read(proxy, name), value)
        assert default != value, (name, "the test must set something else than the default")
        setattr(proxy, name, default)
    others = {"Input", "SharpPoints", "SmoothPoints", *session.USED}
    assert set(proxy.ListProperties()) - others == set(properties), proxy.ListProperties()


# The contour that both are given. ParaView orders its points in a way of its own.
contour = session.contour()
plain_contour = vtkTrivialProducer()
plain_contour.SetOutput(fetch(contour))
triangles = fetch(contour).GetNumberOfPolys()
assert triangles > 1000
ASSEMBLY = {"PatchArrayName": "Material", "MergeTolerance": 1e-4}
WINDOW = {"SharpAngle": 30.0, "Window": 2.5, "WindowRatio": 1.5, "WindowSearch": "Spatial",
          **ASSEMBLY}


def plain(make, proxy=None):
    """The VTK class on the same contour, with the same window: ParaView's default follows the data."""
    filter_ = make()
    filter_.SetInputConnection(plain_contour.GetOutputPort())
    if proxy is not None:
        filter_.SetWindow(proxy.Window)
    filter_.Update()
    return filter_


# The four steps.
ussod = simple.USSOD(Input=contour)
set_and_read(ussod, **WINDOW)
plain_ussod = plain(arris.vtkUSSODFilter, ussod)
same(fetch(ussod), plain_ussod.GetOutput(), "USSOD")
assert used(ussod) == [getattr(plain_ussod, "Get" + name)() for name in session.USED]
region = fetch(ussod).GetPointData().GetArray("SharpRegion")
assert 0 < sum(v[0] for v in values(region)) < region.GetNumberOfTuples()

thinning = simple.SharpThinning(Input=ussod)
set_and_read(thinning, **ASSEMBLY)
plain_thinning = arris.vtkSharpThinningFilter()
plain_thinning.SetInputConnection(plain_ussod.GetOutputPort())
plain_thinning.Update()
same(fetch(thinning), plain_thinning.GetOutput(), "Sharp Thinning")
same(fetch(thinning, 1), plain_thinning.GetSkeleton(), "Sharp Thinning, Skeleton")
assert thinning.SMProxy.GetOutputPort("Skeleton").GetPortIndex() == 1

sharpening = simple.Sharpening(Input=thinning)
set_and_read(sharpening, Window=2.5, WindowRatio=1.5, **ASSEMBLY)
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

# All in one, with the values that an enumeration shows.
one_click = simple.SharpEdgeReconstruction(Input=contour)
set_and_read(one_click, Method="Paper", Denoise=1, AllowEdgeFlips=1, **WINDOW)
assert one_click.Window == 0.0  # automatic
for method in ("Robust", "Paper"):
    one_click.Method = method
    plain_one_click = arris.vtkSharpEdgeReconstruction()
    getattr(plain_one_click, "SetMethodTo" + method)()
    plain_one_click.SetInputConnection(plain_contour.GetOutputPort())
    plain_one_click.Update()
    same(fetch(one_click), plain_one_click.GetOutput(), f"Sharp Edge Reconstruction, {method}")
    assert fetch(one_click).GetNumberOfPolys() == triangles

# And the look before.
preview = simple.SharpEdgePreview(Input=contour)
set_and_read(preview, TubeRadius=0.3, **WINDOW)
plain_preview = plain(arris.vtkSharpEdgePreview, preview)
same(fetch(preview), plain_preview.GetOutput(), "Sharp Edge Preview")
same(fetch(preview, 1), plain_preview.GetMarks(), "Sharp Edge Preview, Marks")
assert preview.SMProxy.GetOutputPort("Marks").GetPortIndex() == 1
print(f"{triangles} triangles: ParaView and VTK agree")
