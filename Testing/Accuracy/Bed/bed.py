#!/usr/bin/env python3
"""Recovers solids whose truth is known by several methods and prints how well. See the README."""

import argparse
import csv
import math
import sys
from multiprocessing import get_context
from pathlib import Path

import cache
import cases
import methods
import sampling
import sheet
from score import NEAR, score

ROOT = Path(__file__).resolve().parents[3]
NEAR_OF = {"segmentation": 0.5, "smoothed": 0.5}  # cells, where the sampling itself is off by more than NEAR
COLUMNS = {  # figure -> heading and format
    "recall": ("recall %", "{:.1f}"), "precision": ("precision %", "{:.1f}"),
    "corners": ("corners %", "{:.1f}"), "false_length": ("false, cells", "{:.1f}"),
    "e_mean": ("E_mean %", "{:.4f}"), "e_max": ("E_max %", "{:.3f}"),
    "normal_rms": ("normals °", "{:.2f}"), "flips": ("flips", "{:.1f}"),
    "slivers": ("slivers", "{:.1f}"), "crossings": ("crossings", "{:.1f}"),
    "far_moved": ("far moved %", "{:.2f}"), "seconds": ("seconds", "{:.2f}"),
}


def main():
    """The command line."""
    options = _options()
    options.templates = methods.commands(options.arris, options.method_command)
    tasks = [(solid, name, options) for solid in options.solids for name in options.samplings]
    rows, pictures = [], []
    with get_context("spawn").Pool(options.jobs) as pool:
        for more_rows, more_pictures in pool.imap(_measured, tasks):
            rows += more_rows
            pictures += more_pictures
            print(f"\r{len(rows)} of {len(tasks) * len(options.methods)}", end="", file=sys.stderr)
    print(file=sys.stderr)
    text = tables(rows, options)
    print(text)
    if options.csv:
        _write_csv(options.csv, rows)
    if options.markdown:
        Path(options.markdown).write_text(text + "\n", encoding="utf-8")
    if options.sheet:
        sheet.write_sheet(options.sheet, sheet.before_after(pictures), columns=6)
    failures = [row for row in rows if row["failed"]]
    for row in failures:
        print(f"{row['solid']} {row['sampling']} {row['method']}: {row['failed']}", file=sys.stderr)
    return 1 if failures else 0


def _options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--solids", nargs="+", default=["designed"], metavar="NAME",
                        help="designed, random, heldout, all (designed and random), or names")
    parser.add_argument("--samplings", default="contour64",
                        help=f"with commas between: {', '.join(sampling.KINDS)}, each followed by "
                        "32, 64, 128 or 256 (default: %(default)s)")
    parser.add_argument("--methods", default="input,paper,robust",
                        help="with commas between: input (unchanged), oracle (snapped with the "
                        "truth), paper, robust, or names given by --method-command")
    parser.add_argument("--method-command", action="append", default=[], metavar="NAME=COMMAND",
                        help="a shell command with {in} and {out} in it, run as a method")
    parser.add_argument("--arris", type=Path, default=ROOT / "build/bin/arris",
                        help="the program (default: %(default)s)")
    parser.add_argument("--cache", type=Path, default=cache.default_folder(),
                        help="where sampled meshes are kept (default: %(default)s)")
    parser.add_argument("--csv", help="writes every figure of every mesh")
    parser.add_argument("--markdown", help="writes what is printed")
    parser.add_argument("--sheet", help="writes a PNG of before and after; needs a display")
    parser.add_argument("--jobs", type=int, default=2, help="default: %(default)s")
    options = parser.parse_args()
    options.samplings, options.methods = options.samplings.split(","), options.methods.split(",")
    try:
        options.solids = cases.names_of(options.solids)
        for name in options.samplings:
            sampling.parse(name)
        known = {*methods.BUILT_IN, *methods.commands(options.arris, options.method_command)}
        for name in options.methods:
            if name not in known:
                raise ValueError(f"{name}: a method is one of {', '.join(sorted(known))}")
    except ValueError as error:
        parser.error(str(error))
    return options


def _measured(task):
    """The rows of one solid and sampling, a row for each method, and meshes to be drawn."""
    solid, name, options = task
    truth, before = cases.truth_of(solid), cases.input_mesh(options.cache, solid, name)
    cell, near = sampling.cell_size(name), NEAR_OF.get(sampling.parse(name)[0], NEAR)
    rows, pictures = [], []
    for method in options.methods:
        row = {"solid": solid, "sampling": name, "method": method, "failed": ""}
        try:
            after, row["seconds"] = methods.recovered(method, options.templates, truth, before,
                                                      cell)
            row.update(score(truth, before, after, cell, near))
            if options.sheet and method != "input":
                pictures.append((f"{solid} {name} {method}", before, after))
        except (methods.Failed, ValueError) as error:
            row["failed"] = str(error)
        rows.append(row)
    return rows, pictures


def tables(rows, options):
    """Markdown: for each sampling the means of each method, then every solid."""
    parts = []
    for name in options.samplings:
        heading = f"| {name} | " + " | ".join(h for h, _ in COLUMNS.values()) + " |"
        rule = "|---" * (len(COLUMNS) + 1) + "|"
        lines = [heading, rule]
        chosen = [row for row in rows if row["sampling"] == name]
        for method in options.methods:
            mine = [row for row in chosen if row["method"] == method]
            done = sum(not row["failed"] for row in mine)
            means = {key: _mean([row[key] for row in mine if key in row]) for key in COLUMNS}
            lines.append(_line(f"**{method}**, mean of {done} of {len(mine)}", means))
        for row in chosen:
            lines.append(_line(f"{row['solid']} {row['method']}", row))
        parts.append("\n".join(lines))
    return "\n\n".join(parts)


def _line(title, figures):
    """One row of a table; what is missing or not defined is a dash."""
    cells = [form.format(figures[key]) if not math.isnan(figures.get(key, math.nan)) else "–"
             for key, (_, form) in COLUMNS.items()]
    return f"| {title} | " + " | ".join(cells) + " |"


def _mean(values):
    """The mean of what is defined."""
    values = [v for v in values if not math.isnan(v)]
    return sum(values) / len(values) if values else math.nan


def _write_csv(path, rows):
    """All figures, unrounded."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, ["solid", "sampling", "method", *COLUMNS, "failed"])
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    sys.exit(main())
