"""Where truths and sampled meshes are kept, so that the second run is quick."""

import hashlib
import os
from pathlib import Path

from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter

from meshes import read_mesh, to_polydata, write_mesh, write_polydata

VERSION = 2  # to be raised when sampling.py changes what it makes


def default_folder():
    """$ARRIS_ACCURACY_CACHE, or a folder of the user's; never inside the repository."""
    return Path(os.environ.get("ARRIS_ACCURACY_CACHE") or Path.home() / ".cache/arris-accuracy")


def key_of(truth):
    """What a cached file must carry in its header to belong to this truth."""
    digest = hashlib.sha256(truth.mesh.points.tobytes() + truth.mesh.tris.tobytes())
    return f"arris accuracy {VERSION} {digest.hexdigest()[:16]}"


def export_truth(folder, truth):
    """Writes truth.vtk, curves.vtk and corners.vtk for programs that are not of this folder."""
    key, marker = key_of(truth), folder / "truth.vtk"
    if _key_in(marker) == key:
        return
    folder.mkdir(parents=True, exist_ok=True)
    curves = to_polydata(truth.mesh.points, truth.segments, lines=True)
    write_polydata(folder / "curves.vtk", curves, key)
    corners = vtkVertexGlyphFilter()
    corners.SetInputData(to_polydata(truth.corners, []))
    corners.Update()
    write_polydata(folder / "corners.vtk", corners.GetOutput(), key)
    write_mesh(marker, truth.mesh, key)


def cached_mesh(path, key, make):
    """The mesh in the file if it carries the key; else makes it and writes it there."""
    if _key_in(path) == key:
        return read_mesh(path)
    mesh = make()
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(f"{path.stem}-{os.getpid()}{path.suffix}")
    write_mesh(unfinished, mesh, key)
    unfinished.replace(path)
    return mesh


def _key_in(path):
    """The second line of a legacy VTK file; None if there is no such file."""
    if not path.exists():
        return None
    with open(path, "rb") as file:
        file.readline()
        return file.readline().decode("ascii", "replace").strip()
