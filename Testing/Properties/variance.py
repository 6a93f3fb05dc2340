#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Promise 5, motion by motion: how many vertices of random meshes are elsewhere after each alone.

properties.py moves, scales and renumbers a mesh at once; this tells what of it a result depends on.
"""

import argparse
from collections import Counter

import numpy as np
import promises
import properties
from solids import points_of, polydata, random_rotation, triangles_of


def motions(rng, points, triangles):
    """{name: (mesh, where a point of the mesh goes, the new number of each vertex)}."""
    same = np.arange(len(points))
    rotation = random_rotation(rng)
    offset = rng.uniform(-10.0, 10.0, 3)
    mirror = np.array([-1.0, 1.0, 1.0])
    place = rng.permutation(len(points))
    renumbered = np.empty_like(points)
    renumbered[place] = points
    cells = rng.permutation(len(triangles))
    first = rng.integers(0, 3, len(triangles))
    corners = np.take_along_axis(triangles, (np.arange(3) + first[:, None]) % 3, axis=1)

    def moved(motion):
        return polydata(motion(points), triangles), motion, same

    def as_it_is(p):
        return p

    return {
        "rotation": moved(lambda p: p @ rotation.T),
        "translation": moved(lambda p: p + offset),
        "scale": moved(lambda p: 3.0 * p),
        "reflection": (
            polydata(mirror * points, triangles[:, ::-1].copy()),
            lambda p: mirror * p,
            same,
        ),
        "points": (polydata(renumbered, place[triangles]), as_it_is, place),
        "cells": (polydata(points, triangles[cells]), as_it_is, same),
        "corners": (polydata(points, corners), as_it_is, same),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0, help="number of the first mesh")
    parser.add_argument("--count", type=int, default=30, help="how many meshes")
    parser.add_argument("--method", default="robust", choices=promises.METHODS)
    options = parser.parse_args()
    vertices = 0
    elsewhere = Counter()
    meshes = Counter()
    for number in range(options.first, options.first + options.count):
        mesh = promises.in_double(properties.random_mesh(number)[1])
        points, triangles = points_of(mesh), triangles_of(mesh)
        here = points_of(promises.recover(mesh, options.method))
        vertices += len(points)
        for name, (there, motion, place) in motions(
            np.random.default_rng(number), points, triangles
        ).items():
            found = points_of(promises.recover(there, options.method))[place]
            rounding = promises.ROUNDING * promises.mean_edge_length(there)
            apart = np.linalg.norm(motion(here) - found, axis=1) > rounding
            elsewhere[name] += int(apart.sum())
            meshes[name] += bool(apart.any())
    print(f"{options.count} meshes, {vertices} vertices, {options.method}: elsewhere are, after")
    for name in elsewhere:
        share = 100.0 * elsewhere[name] / vertices
        print(f"{name:12}{share:6.1f} % of the vertices, on {meshes[name]} meshes")


if __name__ == "__main__":
    main()
