# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The skeleton of the sharp region by role."""

import scenes
from pictures import compare

compare(scenes.roles(), "roles.png")
