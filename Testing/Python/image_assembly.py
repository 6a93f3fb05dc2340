# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The patches of an assembly of three materials, those inside among them."""

import scenes
from pictures import compare

compare(scenes.assembly(), "assembly.png")
