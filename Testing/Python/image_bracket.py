# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The recovered L-bracket: every edge and corner straight and sharp."""

import scenes
from pictures import compare

compare(scenes.bracket(), "bracket.png")
