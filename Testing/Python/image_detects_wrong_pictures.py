# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""The image tests would notice a wrong picture: here are some, and each must be told from its
baseline."""

import sys

import scenes
from pictures import difference

wrong = [
    ("assembly.png", scenes.assembly(recover=False), "the assembly as sampling left it"),
    ("bracket.png", scenes.bracket(recover=False), "the mesh as sampling left it"),
    ("roles.png", scenes.roles(array="SharpRegion"), "the region instead of its skeleton"),
    ("features.png", scenes.features(feature_angle=91.0), "without the cube's curves"),
    ("edges-command.png", scenes.edges_command("--feature-angle", "91"), "no curves of the cube"),
    ("curves.png", scenes.curves(feature_angle=120.0), "without most of its curves"),
]
passed = True
for baseline, window, what in wrong:
    same, off = difference(window, baseline)
    print(f"{baseline}, {what}: {off:.2f} off, {'NOT NOTICED' if same else 'noticed'}")
    passed = passed and not same

# And the right one is not, with the same means.
same, off = difference(scenes.bracket(), "bracket.png")
print(f"bracket.png, as it should be: {off:.2f} off, {'accepted' if same else 'REFUSED'}")
sys.exit(0 if passed and same else 1)
