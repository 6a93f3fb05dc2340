# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Each filter as in a user's script: ports, properties, results."""

import unittest

import meshes
from arris import (
    vtkSharpEdgeExtractor,
    vtkSharpEdgeReconstruction,
    vtkSharpeningFilter,
    vtkSharpThinningFilter,
    vtkUSSODFilter,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkSelection, vtkSelectionNode

PAPERS_ANGLE = 41.4096221092709  # acos(0.75) in degrees


class Ports(unittest.TestCase):
    def test_numbers(self):
        outputs = {
            vtkUSSODFilter: 1,
            vtkSharpThinningFilter: 2,
            vtkSharpeningFilter: 1,
            vtkSharpEdgeExtractor: 4,
            vtkSharpEdgeReconstruction: 1,
        }
        for kind, count in outputs.items():
            with self.subTest(kind.__name__):
                picks = 2 if hasattr(kind, "SetPickedPointsSharp") else 0
                self.assertEqual(kind().GetNumberOfInputPorts(), 1 + picks)
                self.assertEqual(kind().GetNumberOfOutputPorts(), count)

    def test_names(self):
        extractor = vtkSharpEdgeExtractor()
        extractor.SetInputData(meshes.box(16))
        extractor.Update()
        self.assertIs(extractor.GetCorners(), extractor.GetOutput(1))
        self.assertIs(extractor.GetSurfaces(), extractor.GetOutput(2))
        self.assertIs(extractor.GetFaces(), extractor.GetOutputDataObject(3))
        thinning = vtkSharpThinningFilter()
        self.assertIs(thinning.GetSkeleton(), thinning.GetOutput(1))


class Properties(unittest.TestCase):
    def check(self, make, name, default, other):
        with self.subTest(f"{make.__name__}.{name}"):
            filter_ = make()
            get, set_ = getattr(filter_, "Get" + name), getattr(filter_, "Set" + name)
            self.assertAlmostEqual(get(), default, places=12)
            before = filter_.GetMTime()
            set_(other)
            self.assertEqual(get(), other)
            self.assertGreater(filter_.GetMTime(), before)

    def test_round_trip(self):
        for make in (vtkUSSODFilter, vtkSharpeningFilter, vtkSharpEdgeReconstruction):
            automatic = make is vtkSharpEdgeReconstruction  # 0 leaves it to the method
            self.check(make, "Window", 0.0, 0.125)
            self.check(make, "WindowRatio", 0.0 if automatic else 0.75, 1.5)
        self.check(vtkUSSODFilter, "SharpAngle", PAPERS_ANGLE, 30.0)
        self.check(vtkSharpEdgeReconstruction, "SharpAngle", 0.0, 30.0)
        self.check(vtkSharpEdgeReconstruction, "Denoise", False, True)
        self.check(vtkSharpEdgeReconstruction, "AllowEdgeFlips", False, True)
        for make in (vtkUSSODFilter, vtkSharpEdgeReconstruction):
            self.check(make, "WindowSearch", make.CONNECTED, make.SPATIAL)
        self.check(
            vtkSharpEdgeReconstruction,
            "Method",
            vtkSharpEdgeReconstruction.ROBUST,
            vtkSharpEdgeReconstruction.PAPER,
        )
        self.check(vtkSharpEdgeExtractor, "FeatureAngle", 30.0, 20.0)
        for name, default, other in (
            ("CornerAngle", 60.0, 90.0),
            ("ContinuationAngle", 0.0, 10.0),
            ("MaximumAngle", 180.0, 170.0),
            ("NoiseFactor", 30.0, 0.0),
            ("BoundaryEdges", True, False),
            ("NonManifoldEdges", True, False),
            ("GapLength", -1.0, 0.5),
            ("TailLength", -1.0, 0.5),
            ("MinimumLength", 0.0, 0.5),
            ("MergeTolerance", 1e-6, 1e-3),
            ("ResampleStep", 0.0, 0.5),
            ("FitPrimitives", True, False),
            ("FitTolerance", 0.03, 0.1),
        ):
            self.check(vtkSharpEdgeExtractor, name, default, other)

    def test_setters_of_named_values(self):
        for make in (vtkUSSODFilter, vtkSharpEdgeReconstruction):
            filter_ = make()
            filter_.SetWindowSearchToSpatial()
            self.assertEqual(filter_.GetWindowSearch(), make.SPATIAL)
            filter_.SetWindowSearchToConnected()
            self.assertEqual(filter_.GetWindowSearch(), make.CONNECTED)
        recover = vtkSharpEdgeReconstruction()
        recover.SetMethodToPaper()
        self.assertEqual(recover.GetMethod(), recover.PAPER)
        recover.SetMethodToRobust()
        self.assertEqual(recover.GetMethod(), recover.ROBUST)

    def test_kappa_is_that_of_the_last_update(self):
        classify = vtkUSSODFilter()
        self.assertEqual(classify.GetKappa(), 0.0)
        classify.SetInputData(meshes.box(16))
        classify.SetWindow(0.5)
        classify.Update()
        self.assertAlmostEqual(classify.GetKappa(), 0.25 / 0.5, places=12)
        self.assertFalse(hasattr(classify, "SetKappa"))


class Picks(unittest.TestCase):
    def setUp(self):
        self.mesh = meshes.box(20)
        self.classify = vtkUSSODFilter()
        self.classify.SetInputData(self.mesh)
        self.classify.Update()
        deviation = self.array("NormalDeviation")
        self.sharp, self.smooth = int(deviation.argmax()), int(deviation.argmin())

    def array(self, name):
        return vtk_to_numpy(self.classify.GetOutput().GetPointData().GetArray(name))

    def positions(self, *ids):
        points = vtkPoints()
        for i in ids:
            points.InsertNextPoint(self.mesh.GetPoint(i))
        return points

    def test_positions(self):
        self.classify.SetPickedPointsSharp(self.positions(self.sharp))
        self.classify.SetPickedPointsSmooth(self.positions(self.smooth))
        self.classify.Update()
        region = self.array("SharpRegion")
        self.assertEqual((region[self.sharp], region[self.smooth]), (1, 0))
        least = self.array("NormalDeviation")[self.sharp]
        self.assertAlmostEqual(self.classify.GetUsedSharpAngle(), least, places=6)
        self.assertEqual(self.classify.GetUsedWindowRatio(), 0.5)

    def test_a_selection(self):
        ids = vtkIdTypeArray()
        ids.InsertNextValue(self.sharp)
        node = vtkSelectionNode()
        node.SetContentType(node.INDICES)
        node.SetFieldType(node.POINT)
        node.SetSelectionList(ids)
        selection = vtkSelection()
        selection.AddNode(node)
        self.classify.SetPickedPointsSharp(self.positions(self.sharp))
        self.classify.Update()
        angle = self.classify.GetUsedSharpAngle()
        self.classify.SetPickedPointsSharp(None)
        self.classify.Update()
        self.assertEqual(self.classify.GetUsedSharpAngle(), self.classify.GetSharpAngle())
        self.classify.SetPickedPointsSharpData(selection)
        self.classify.Update()
        self.assertEqual(self.classify.GetUsedSharpAngle(), angle)


class Chain(unittest.TestCase):
    def test_of_stages_gives_what_the_whole_gives(self):
        mesh = meshes.bracket(32)
        classify, thin, sharpen = vtkUSSODFilter(), vtkSharpThinningFilter(), vtkSharpeningFilter()
        classify.SetInputData(mesh)
        thin.SetInputConnection(classify.GetOutputPort())
        sharpen.SetInputConnection(thin.GetOutputPort())
        sharpen.Update()
        whole = vtkSharpEdgeReconstruction()
        whole.SetMethodToPaper()
        whole.SetInputData(mesh)
        whole.Update()
        self.assertTrue(
            (meshes.points(sharpen.GetOutput()) == meshes.points(whole.GetOutput())).all()
        )
        self.assertFalse((meshes.points(whole.GetOutput()) == meshes.points(mesh)).all())

    def test_ends_in_curves_corners_and_faces(self):
        recover = vtkSharpEdgeReconstruction()
        recover.SetInputData(meshes.box(32))
        extract = vtkSharpEdgeExtractor()
        extract.SetInputConnection(recover.GetOutputPort())
        extract.Update()
        self.assertGreaterEqual(extract.GetOutput().GetNumberOfLines(), 12)
        self.assertGreaterEqual(extract.GetCorners().GetNumberOfVerts(), 8)
        ids = extract.GetSurfaces().GetCellData().GetArray("SurfaceId")
        self.assertGreaterEqual(ids.GetRange()[1], 5)


if __name__ == "__main__":
    unittest.main()
