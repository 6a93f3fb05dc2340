#!/usr/bin/env python3
"""Make the bracket: a bearing bracket with known sharp edges, and its sampled volume.

Writes, all in one coordinate system (millimetres):

    bracket.step        the B-rep
    bracket.ply         the B-rep, finely triangulated: the truth surface
    bracket-edges.vtp   the sharp edges of the B-rep as polylines: the truth edges
    bracket.mha         signed distance to the truth, positive inside, 1 mm cells
    bracket-small.mha   the same on 3 mm cells, for quick tests

The part lies slightly turned on the grid, as it would on the table of a scanner.
"""

import argparse
import math
import re
from collections import defaultdict
from pathlib import Path

import cadquery as cq
import numpy as np
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE
from OCP.TopExp import TopExp
from OCP.TopTools import TopTools_IndexedDataMapOfShapeListOfShape
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkIOImage import vtkMetaImageWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

FILLET_RADIUS = 12.0  # mm; the one fillet
TURN = (4.0, 2.5, 7.0)  # degrees about x, then y, then z
# Grid lines miss the part's bounds by these fractions of a cell.
GRID_SHIFT = (math.sqrt(2) % 1, math.sqrt(3) % 1, math.sqrt(5) % 1)
STEPS_PER_MM = 2048  # rounding of the stored distances
BAND_CELLS = 4  # distances are clamped to this many cells


def make_part():
    """The bracket, in drawing position: x across, y along the bearing axis, z up.

    Walls, gaps and distances between edges are 12 mm or more, holes 20 mm, so that half the samples
    still show each of them.
    """
    yz = cq.Workplane("YZ")
    xz = cq.Workplane("XZ")  # looks along -y: extrude(-d) goes to y = d
    axis = (0, 68)  # the bearing axis in x and z

    # Base and wall with the fillet between them, cut to shape as seen along the axis.
    r = FILLET_RADIUS
    part = (
        yz.moveTo(0, 0).lineTo(90, 0).lineTo(90, 14).lineTo(16 + r, 14)
        .radiusArc((16, 14 + r), r).lineTo(16, 120).lineTo(0, 120).close()
        .extrude(60, both=True)
    )
    shoulders = xz.center(0, 27).rect(108, 54)
    part = part.intersect(shoulders.extrude(-100).union(xz.center(*axis).circle(42).extrude(-100)))

    # Bearing housing in front of the wall, and the rib below.
    part = part.union(xz.center(*axis).circle(30).extrude(-64))
    rib = [(10, 10), (71, 10), (71, 14), (35, 50), (10, 50)]
    part = part.union(yz.polyline(rib).close().extrude(7, both=True))

    # Bore, and the lubricator's port on top of the housing, 20 degrees off the vertical.
    tilt = math.radians(20)
    port = cq.Workplane(
        cq.Plane(origin=(axis[0], 40, axis[1]), xDir=(0, 1, 0), normal=(math.sin(tilt), 0, math.cos(tilt)))
    )
    part = part.cut(xz.workplane(offset=10).center(*axis).circle(17).extrude(-90))
    part = part.cut(port.circle(10).extrude(40))

    # Mounting: a hole and a slot through the base.
    xy = cq.Workplane("XY")
    part = part.cut(xy.center(-32, 56).circle(10).extrude(20))
    part = part.cut(xy.center(32, 56).slot2D(40, 20, 90).extrude(20))

    part = part.clean().val()
    return part.Solids()[0] if part.ShapeType() != "Solid" else part


def turn(part):
    for angle, direction in zip(TURN, ((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        part = part.rotate((0, 0, 0), direction, angle)
    return part


def tessellate(part, tolerance):
    """Closed triangle mesh; vertices on shared B-rep edges are merged."""
    vertices, triangles = part.tessellate(tolerance, 0.05)
    xyz, index = merge([v.toTuple() for v in vertices])
    triangles = index[np.array(triangles)]
    distinct = [len(set(t)) == 3 for t in triangles]
    return polydata(xyz, triangles[distinct], "polys")


def merge(xyz):
    """Distinct points (to a nanometre), and for each given point its index among them."""
    xyz = np.array(xyz)
    _, first, index = np.unique(xyz.round(6), axis=0, return_index=True, return_inverse=True)
    return xyz[first], index.reshape(-1)


def polydata(xyz, cells, kind):
    output, points, array = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(np.asarray(xyz, np.float32), deep=True))
    output.SetPoints(points)
    for cell in cells:
        array.InsertNextCell(len(cell), [int(i) for i in cell])
    output.SetPolys(array) if kind == "polys" else output.SetLines(array)
    return output


def sharp_edges(part, angle, step):
    """Polylines, from corner to corner or closed, along the edges whose two faces differ
    in normal by more than the angle.

    Seams (one face on both sides) and tangent edges (fillet, slot ends) fall out.
    """
    faces_of = TopTools_IndexedDataMapOfShapeListOfShape()
    TopExp.MapShapesAndAncestors_s(part.wrapped, TopAbs_EDGE, TopAbs_FACE, faces_of)
    curves = []
    for i in range(1, faces_of.Extent() + 1):
        edge = cq.Edge(faces_of.FindKey(i))
        faces = [cq.Face(f) for f in faces_of.FindFromIndex(i)]
        if len(faces) != 2 or faces[0].wrapped.IsSame(faces[1].wrapped):
            continue
        samples = edge.positions(np.linspace(0, 1, max(3, math.ceil(edge.Length() / step) + 1)))
        normals = [np.array([f.normalAt(p).toTuple() for p in samples]) for f in faces]
        degrees = np.degrees(np.arccos(np.clip((normals[0] * normals[1]).sum(axis=1), -1, 1)))
        if degrees.max() <= angle:
            continue
        xyz = np.array([p.toTuple() for p in samples])
        # A step along one normal and against the other leaves a convex edge's solid.
        middle = len(xyz) // 2
        probe = xyz[middle] + 0.1 * (normals[0][middle] - normals[1][middle])
        convex = not part.isInside(cq.Vector(*probe), 1e-6)
        curves.append((xyz, degrees.min(), degrees.max(), convex))
    while join_two(curves):
        pass

    points, index = merge(np.concatenate([c[0] for c in curves]))
    cells = np.split(index, np.cumsum([len(c[0]) for c in curves])[:-1])
    output = polydata(points, cells, "lines")
    for column, name, kind in (
        (1, "MinNormalAngle", np.float32),
        (2, "MaxNormalAngle", np.float32),
        (3, "Convex", np.uint8),
    ):
        array = numpy_to_vtk(np.array([c[column] for c in curves], kind), deep=True)
        array.SetName(name)
        output.GetCellData().AddArray(array)
    return output


def join_two(curves):
    """Join two curves that run smoothly into each other where no third one ends."""
    ends = defaultdict(list)
    for i, (xyz, *_) in enumerate(curves):
        for end in (xyz, xyz[::-1]):
            ends[tuple(end[0].round(5) + 0.0)].append((i, end))
    for found in ends.values():
        if len(found) != 2 or found[0][0] == found[1][0]:
            continue
        (i, a), (j, b) = found
        away = [(e[1] - e[0]) / np.linalg.norm(e[1] - e[0]) for e in (a, b)]
        if away[0] @ away[1] > -0.98 or curves[i][3] != curves[j][3]:
            continue
        low, high = min(curves[i][1], curves[j][1]), max(curves[i][2], curves[j][2])
        curves[i] = (np.concatenate([a[::-1], b[1:]]), low, high, curves[i][3])
        del curves[j]
        return True
    return False


def sample(truth, spacing, margin):
    """Distance on a grid, positive inside: clamped, and rounded to odd halves of a step (so never 0)."""
    bounds = np.array(truth.GetBounds()).reshape(3, 2)
    origin = bounds[:, 0] - (margin + np.array(GRID_SHIFT)) * spacing
    size = np.ceil((bounds[:, 1] - origin) / spacing).astype(int) + margin + 1
    axes = [origin[i] + spacing * np.arange(size[i]) for i in range(3)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    where = numpy_to_vtk(np.stack([x, y, z], axis=-1).reshape(-1, 3), deep=True)

    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(truth)
    values = numpy_to_vtk(np.zeros(size.prod()), deep=True)
    distance.FunctionValue(where, values)

    band = BAND_CELLS * spacing
    steps = np.floor(np.clip(-vtk_to_numpy(values), -band, band) * STEPS_PER_MM)
    scalars = numpy_to_vtk(((steps + 0.5) / STEPS_PER_MM).astype(np.float32), deep=True)
    scalars.SetName("SignedDistance")
    image = vtkImageData()
    image.SetDimensions(*map(int, size))
    image.SetOrigin(*origin)
    image.SetSpacing(spacing, spacing, spacing)
    image.GetPointData().SetScalars(scalars)
    return image


def write(writer, data, path):
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    writer.Write()
    print(f"{path.name}: {path.stat().st_size:,} bytes")


def write_step(part, path):
    cq.exporters.export(cq.Workplane(part), str(path))
    text = path.read_text()
    # No time stamp: the same part gives the same file.
    path.write_text(re.sub(r"'\d{4}-\d\d-\d\dT[\d:]+'", "'1970-01-01T00:00:00'", text))
    print(f"{path.name}: {path.stat().st_size:,} bytes")


def write_volume(image, path):
    writer = vtkMetaImageWriter()
    writer.SetCompression(True)
    write(writer, image, path)
    print("   ", image.GetDimensions(), "samples, origin", image.GetOrigin())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=Path(__file__).parent, help="folder to write to")
    parser.add_argument("--spacing", type=float, default=1.0, help="cell of bracket.mha, mm (1)")
    parser.add_argument("--small-spacing", type=float, default=3.0, help="cell of bracket-small.mha, mm (3)")
    parser.add_argument("--tolerance", type=float, default=0.004, help="chord tolerance of the truth, mm (0.004)")
    parser.add_argument("--angle", type=float, default=15.0, help="sharp above this angle, degrees (15)")
    parser.add_argument("--step", type=float, default=0.25, help="point distance along the edges, mm (0.25)")
    args = parser.parse_args()
    args.output.mkdir(parents=True, exist_ok=True)

    part = turn(make_part())
    truth = tessellate(part, args.tolerance)
    edges = sharp_edges(part, args.angle, args.step)
    print(f"valid {part.isValid()}, {len(part.Faces())} faces, volume {part.Volume():.1f} mm^3")
    print(f"{truth.GetNumberOfCells()} triangles, {edges.GetNumberOfCells()} sharp curves")

    write_step(part, args.output / "bracket.step")
    ply = vtkPLYWriter()
    ply.SetFileTypeToBinary()
    write(ply, truth, args.output / "bracket.ply")
    vtp = vtkXMLPolyDataWriter()
    vtp.SetDataModeToBinary()
    write(vtp, edges, args.output / "bracket-edges.vtp")
    write_volume(sample(truth, args.spacing, 3), args.output / "bracket.mha")
    write_volume(sample(truth, args.small_spacing, 2), args.output / "bracket-small.mha")


if __name__ == "__main__":
    main()
