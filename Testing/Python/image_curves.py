# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The feature curves of the real part."""

import scenes
from pictures import compare

compare(scenes.curves(), "curves.png")
