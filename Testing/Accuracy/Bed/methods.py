"""How an input is recovered: nothing, the arris program, any other command, or with the truth."""

import subprocess
import tempfile
import time
from pathlib import Path

import oracle
from meshes import read_mesh, write_mesh

BUILT_IN = ("input", "oracle", "paper", "robust")
TIMEOUT = 600  # seconds


class Failed(Exception):
    """A method gave no mesh; the message says why."""


def commands(arris, extra):
    """Command templates by name; `extra` is a list of 'name=command {in} {out}'."""
    templates = {name: [str(arris), "sharpen", "{in}", "-o", "{out}", "--method", name, "--quiet"]
                 for name in ("paper", "robust")}
    for definition in extra:
        name, equals, command = definition.partition("=")
        if not equals or "{in}" not in command or "{out}" not in command:
            raise ValueError(f"{definition}: expected name=command with {{in}} and {{out}} in it")
        templates[name] = command
    return templates


def recovered(method, templates, truth, mesh, cell):
    """The output mesh of a method and the seconds it took."""
    start = time.perf_counter()
    if method == "input":
        return mesh, 0.0
    if method == "oracle":
        return oracle.snap(truth, mesh, cell), time.perf_counter() - start
    if method not in templates:
        raise ValueError(f"{method}: not one of {', '.join([*BUILT_IN, *templates])}")
    return _by_command(templates[method], mesh)


def run(command, shell=False):
    """Runs a command that has to do its work."""
    try:
        done = subprocess.run(command, shell=shell, capture_output=True, text=True,
                              timeout=TIMEOUT)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Failed(str(error)) from error
    if done.returncode != 0:
        raise Failed(f"exit status {done.returncode}: {done.stderr.strip()[-300:]}")


def timed(command, shell=False):
    """Runs a command that has to do its work; the seconds it took."""
    start = time.perf_counter()
    run(command, shell)
    return time.perf_counter() - start


def _by_command(template, mesh):
    """Runs a command on files of doubles. A string goes to the shell, a list does not."""
    with tempfile.TemporaryDirectory() as folder:
        files = {"{in}": str(Path(folder) / "in.vtk"), "{out}": str(Path(folder) / "out.vtk")}
        write_mesh(files["{in}"], mesh)
        shell = isinstance(template, str)
        command = _filled(template, files) if shell else [_filled(w, files) for w in template]
        seconds = timed(command, shell)
        if not Path(files["{out}"]).exists():
            raise Failed("no output file")
        return read_mesh(files["{out}"]), seconds


def _filled(text, files):
    for key, value in files.items():
        text = text.replace(key, value)
    return text
