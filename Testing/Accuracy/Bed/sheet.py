"""Pictures: flat-shaded meshes with their sharp edges drawn, alone or side by side on a sheet."""

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the titles)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws all else)
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkWindowToImageFilter)

from meshes import to_polydata
from score import sharp_edges

FACE, EDGE, CORNER, PAPER = (0.80, 0.83, 0.86), (0.75, 0.10, 0.10), (0.05, 0.20, 0.75), (1, 1, 1)
TILE = 300  # pixels


def tile(mesh, segments, corners, title):
    """One renderer: the mesh, its segments as red lines, corners as blue dots, and a title."""
    renderer = vtkRenderer()
    renderer.SetBackground(PAPER)
    faces = _actor(to_polydata(mesh.points, mesh.tris), FACE)
    faces.GetProperty().SetInterpolationToFlat()
    renderer.AddActor(faces)
    if len(segments):
        lines = _actor(to_polydata(mesh.points, segments, lines=True), EDGE)
        lines.GetProperty().SetLineWidth(1.6)
        lines.GetProperty().LightingOff()
        renderer.AddActor(lines)
    if len(corners):
        dots = vtkVertexGlyphFilter()
        dots.SetInputData(to_polydata(corners, []))
        dots.Update()
        points = _actor(dots.GetOutput(), CORNER)
        points.GetProperty().SetPointSize(6)
        renderer.AddActor(points)
    text = vtkTextActor()
    text.SetInput(title)
    text.GetTextProperty().SetColor(0, 0, 0)
    text.GetTextProperty().SetFontSize(12)
    text.SetPosition(6, 6)
    renderer.AddActor2D(text)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1.0, -1.6, 1.1)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.15)
    return renderer


def write_sheet(path, tiles, columns):
    """Lays out renderers in rows and writes them as one PNG. Needs a display, e.g. xvfb-run."""
    rows = -(-len(tiles) // columns)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(columns * TILE, rows * TILE)
    for k, renderer in enumerate(tiles):
        row, column = divmod(k, columns)
        renderer.SetViewport(column / columns, 1 - (row + 1) / rows,
                             (column + 1) / columns, 1 - row / rows)
        window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def before_after(pairs):
    """Tiles of (title, mesh before, mesh after), two each, with the sharp edges drawn."""
    tiles = []
    for title, before, after in pairs:
        for state, mesh in (("before", before), ("after", after)):
            tiles.append(tile(mesh, sharp_edges(mesh), [], f"{title}: {state}"))
    return tiles


def _actor(polydata, colour):
    """An actor of one colour; lines and dots are drawn in front of the faces they lie on."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(polydata)
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -4)
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-8)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    return actor
