# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""What `arris edges --picture` draws: coloured curves, corners and the tip."""

import scenes
from pictures import compare

compare(scenes.edges_command(), "edges-command.png")
