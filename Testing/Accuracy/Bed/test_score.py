"""The scorer against figures known in closed form: python3 -m unittest, in this folder."""

import unittest

import numpy as np

from crossings import crossing_pairs
from meshes import Mesh
from primitives import box, cone, cylinder
from score import distance_figures, flipped, score
from truth import Truth

SIDE = 20.0


class BoxTruth(unittest.TestCase):
    """A cube, whose every figure can be said by heart."""

    @classmethod
    def setUpClass(cls):
        cls.truth = Truth(box(SIDE, SIDE, SIDE).rotate((10, 20, 30)))

    def test_length_and_corners(self):
        self.assertAlmostEqual(self.truth.curve_length(), 12 * SIDE, places=6)
        self.assertEqual(sorted(self.truth.valences), [3] * 8)

    def test_truth_scores_full(self):
        mesh = self.truth.mesh
        figures = score(self.truth, mesh, mesh, cell=1.0)
        for key in ("recall", "precision", "corners"):
            self.assertAlmostEqual(figures[key], 100.0)
        for key in ("e_max", "flips", "slivers", "crossings", "far_moved", "false_length"):
            self.assertAlmostEqual(figures[key], 0.0, places=5)

    def test_shifted_along_an_edge(self):
        """Shifted by s along x: two faces are s off, and so is one end of each edge along x."""
        truth, shift = Truth(box(SIDE, SIDE, SIDE)), 0.05
        moved = Mesh(truth.mesh.points + (shift, 0, 0), truth.mesh.tris)
        figures = distance_figures(truth, moved)
        percent = 100 / (SIDE * np.sqrt(3))
        self.assertAlmostEqual(figures["e_max"], shift * percent, places=6)
        self.assertAlmostEqual(figures["e_mean"], shift / 3 * percent, places=3)
        figures = score(truth, truth.mesh, moved, cell=1.0)
        self.assertAlmostEqual(figures["recall"], 100.0)
        self.assertAlmostEqual(figures["far_moved"], 100.0)
        figures = score(truth, truth.mesh, moved, cell=0.1)
        self.assertAlmostEqual(figures["recall"], 100 / 3, delta=0.5)
        self.assertAlmostEqual(figures["corners"], 0.0)

    def test_flipped_triangle_counts(self):
        mesh = self.truth.mesh
        far = self.truth.distance_to_features(mesh.centroids())
        tris = mesh.tris.copy()
        tris[far.argmax()] = tris[far.argmax()][::-1]
        bad = flipped(self.truth, Mesh(mesh.points, tris), cell=1.0)
        self.assertEqual(np.flatnonzero(bad).tolist(), [far.argmax()])


class OtherTruths(unittest.TestCase):
    """Curved edges and tips."""

    def test_cylinder_rims(self):
        truth = Truth(cylinder(10, 12))
        self.assertAlmostEqual(truth.curve_length(), 2 * 2 * np.pi * 10, delta=0.02)
        self.assertEqual(len(truth.corners), 0)

    def test_cone_tip(self):
        truth = Truth(cone(10, 0, 15).rotate((0, 40, 0)).translate((1, 2, 3)))
        tip = np.array((1, 2, 3)) + 15 * np.array((np.sin(np.radians(40)), 0,
                                                   np.cos(np.radians(40))))
        self.assertEqual(truth.valences.tolist(), [0])
        np.testing.assert_allclose(truth.corners[0], tip, atol=1e-9)


class Crossings(unittest.TestCase):
    """Two triangles through each other cross; two that touch at a corner do not."""

    def test_pairs(self):
        points = np.array([(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1), (1, 9, 1),
                           (-4, 0, 1)], dtype=float)
        tris = np.array([(0, 1, 2), (3, 4, 5), (0, 6, 4)])
        pairs = crossing_pairs(Mesh(points, tris))
        self.assertEqual(pairs.tolist(), [[0, 1]])
        self.assertEqual(len(crossing_pairs(Mesh(points, tris), among=[2])), 0)


if __name__ == "__main__":
    unittest.main()
