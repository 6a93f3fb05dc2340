# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Arris: gives triangle meshes back the sharp edges that sampling took from them.

    from arris import vtkSharpEdgeReconstruction
"""

# VTK's own classes must be known before those that derive from them.
import vtkmodules.vtkCommonExecutionModel  # noqa: F401

from .ArrisFilters import *  # noqa: F401,F403
