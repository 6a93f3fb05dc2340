# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The curves, corners and the tip of a cube, a cylinder and a cone."""

import scenes
from pictures import compare

compare(scenes.features(), "features.png")
