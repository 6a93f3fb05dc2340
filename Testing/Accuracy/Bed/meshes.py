"""Triangle meshes as two arrays: reading, writing and what every other file asks of them."""

from dataclasses import dataclass
from pathlib import Path

import igl
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

READERS = {
    ".vtk": vtkPolyDataReader,
    ".vtp": vtkXMLPolyDataReader,
    ".ply": vtkPLYReader,
    ".stl": vtkSTLReader,
    ".obj": vtkOBJReader,
}


@dataclass
class Mesh:
    """Points (n x 3, double) and triangles (m x 3, point ids)."""

    points: np.ndarray
    tris: np.ndarray

    def corners(self):
        """The three corner positions of every triangle: m x 3 x 3."""
        return self.points[self.tris]

    def centroids(self):
        """The centroid of every triangle."""
        return self.corners().mean(axis=1)

    def normals_and_areas(self):
        """Unit normal (zero for a triangle without area) and area of every triangle."""
        a, b, c = self.corners().transpose(1, 0, 2)
        cross = np.cross(b - a, c - a)
        length = np.linalg.norm(cross, axis=1)
        return cross / np.maximum(length, 1e-300)[:, None], length / 2

    def smallest_angles(self):
        """The smallest angle of every triangle in degrees."""
        corners = self.corners()
        angles = []
        for k in range(3):
            u = corners[:, (k + 1) % 3] - corners[:, k]
            v = corners[:, (k + 2) % 3] - corners[:, k]
            angles.append(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(axis=1)))
        return np.degrees(np.min(angles, axis=0))

    def edges(self):
        """Edges with exactly two triangles: their end points (k x 2) and triangles (k x 2)."""
        return edges_of(self.tris)

    def mean_edge_length(self):
        """The mean length of the edges."""
        ends, _ = self.edges()
        return np.linalg.norm(self.points[ends[:, 0]] - self.points[ends[:, 1]], axis=1).mean()

    def diagonal(self):
        """The length of the diagonal of the bounding box."""
        return np.linalg.norm(np.ptp(self.points, axis=0))

    def volume(self):
        """The signed volume inside; negative where the triangles face inward."""
        a, b, c = self.corners().transpose(1, 0, 2)
        return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def edges_of(tris):
    """Edges shared by exactly two triangles: their end points (k x 2) and triangles (k x 2)."""
    ends = np.sort(np.concatenate([tris[:, [0, 1]], tris[:, [1, 2]], tris[:, [2, 0]]]), axis=1)
    owner = np.tile(np.arange(len(tris)), 3)
    key = ends[:, 0] * (tris.max() + 1) + ends[:, 1]
    order = np.argsort(key, kind="stable")
    _, first, count = np.unique(key[order], return_index=True, return_counts=True)
    first = first[count == 2]
    one, two = order[first], order[first + 1]
    return ends[one], np.stack([owner[one], owner[two]], axis=1)


class Locator:
    """Closest points on triangles or segments (rows of point ids), by a bounding-box tree."""

    def __init__(self, points, cells):
        self.points = np.ascontiguousarray(points, dtype=np.float64)
        self.cells = np.ascontiguousarray(cells, dtype=np.int64)
        self.tree = igl.AABB()
        if len(self.cells):
            self.tree.init(self.points, self.cells)

    def closest(self, queries):
        """Distance, cell and closest point of every query; infinity where there is no cell."""
        queries = np.ascontiguousarray(queries, dtype=np.float64)
        if not len(self.cells) or not len(queries):
            none = np.full(len(queries), -1)
            return np.full(len(queries), np.inf), none, queries.copy()
        squared, cell, point = self.tree.squared_distance(self.points, self.cells, queries)
        return np.sqrt(squared), cell, point


def to_polydata(points, cells, lines=False):
    """A vtkPolyData with double coordinates; cells are triangles, or segments if lines is set."""
    polydata = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=True))
    polydata.SetPoints(vtk_points)
    if len(cells):
        rows = np.column_stack([np.full(len(cells), cells.shape[1]), cells]).astype(np.int64)
        array = vtkCellArray()
        array.ImportLegacyFormat(numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
        (polydata.SetLines if lines else polydata.SetPolys)(array)
    return polydata


def from_polydata(polydata):
    """The Mesh of the triangles of a vtkPolyData (other polygons and strips are triangulated)."""
    triangulate = vtkTriangleFilter()
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    triangulate.SetInputData(polydata)
    triangulate.Update()
    polydata = triangulate.GetOutput()
    if not polydata.GetNumberOfPolys():
        return Mesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64))
    points = vtk_to_numpy(polydata.GetPoints().GetData()).astype(np.float64)
    tris = vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return Mesh(points, tris.astype(np.int64))


def read_mesh(path):
    """The Mesh in a file; its format follows from the suffix."""
    reader = READERS[Path(path).suffix.lower()]()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = from_polydata(reader.GetOutput())
    if not len(mesh.tris):
        raise ValueError(f"{path}: no triangles")
    return mesh


def write_polydata(path, polydata, header="arris accuracy"):
    """Writes a legacy binary .vtk: doubles stay doubles, and no appended XML is involved."""
    writer = vtkPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetFileTypeToBinary()
    writer.SetHeader(header)
    writer.SetInputData(polydata)
    if not writer.Write():
        raise OSError(f"{path}: cannot be written")


def write_mesh(path, mesh, header="arris accuracy"):
    """Writes a Mesh as legacy binary .vtk."""
    write_polydata(path, to_polydata(mesh.points, mesh.tris), header)
