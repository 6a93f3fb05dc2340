"""The bound for methods that keep the connectivity: the input's vertices snapped with the truth."""

import numpy as np
from scipy.spatial import cKDTree

from meshes import Locator, Mesh


def snap(truth, mesh, cell):
    """Moves as few vertices as may be onto the true curves, and one onto each true corner.

    Every vertex is given the smooth surface nearest to it. A mesh edge between two surfaces within
    1.5 cells of a sharp curve crosses it, and one of its ends, the one nearer to the curve if
    neither was chosen yet, goes to the nearest point of the curve. All other vertices within 2.5
    cells of a curve go to the surface. The nearest unused vertex goes to each corner.
    """
    points = mesh.points.copy()
    _, tri, on_surface = truth.locator.closest(points)
    to_curve, _, on_curve = truth.curve_locator.closest(points)
    surface = truth.surface_of[tri]
    near = to_curve < 2.5 * cell
    points[near] = on_surface[near]

    ends, _ = mesh.edges()
    crossing = surface[ends[:, 0]] != surface[ends[:, 1]]
    crossing &= to_curve[ends].max(axis=1) < 1.5 * cell
    ends = ends[crossing]
    ends = np.where((to_curve[ends[:, 0]] <= to_curve[ends[:, 1]])[:, None], ends, ends[:, ::-1])
    chosen = np.zeros(len(points), dtype=bool)
    for one, two in ends[np.argsort(to_curve[ends[:, 0]])]:
        if not chosen[two]:
            chosen[one] = True
    points[chosen] = on_curve[chosen]

    free = chosen | near
    for corner, valence in zip(truth.corners, truth.valences):
        candidates = np.flatnonzero(chosen if valence >= 2 else free | (valence == 0))
        if len(candidates):
            distance, k = cKDTree(points[candidates]).query(corner)
            if distance < 1.5 * cell:
                points[candidates[k]] = corner
                chosen[candidates[k]] = free[candidates[k]] = False
    return Mesh(points, mesh.tris)
