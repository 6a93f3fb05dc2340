# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""State files, .pvsm and .py: what they restore gives the same points from the same properties."""

import session
from paraview import simple, smstate
from session import extremes, fetch, read, select, used, values

session.load()


def find(kind):
    return next(proxy for proxy in simple.GetSources().values()
                if proxy.GetXMLName() == kind)


def snapshot():
    """The settings and results of the two filters."""
    paper, preview = find("SharpEdgeReconstruction"), find("SharpEdgePreview")
    for proxy in (paper, preview):
        proxy.UpdatePipeline()
    names = ("Method", "SharpAngle", "Window", "WindowRatio", "WindowSearch")
    return ([read(paper, name) for name in names], used(paper), read(preview, "TubeRadius"),
            values(fetch(paper).GetPoints().GetData()),
            values(fetch(preview, 1).GetPoints().GetData()))


contour = session.contour()
sharp, _ = extremes(simple.USSOD(Input=contour))
simple.SharpEdgeReconstruction(
    Input=contour, Method="Paper", SharpAngle=35.0, WindowRatio=1.25, WindowSearch="Spatial",
    SharpPoints=select(sharp))
simple.SharpEdgePreview(Input=contour, SharpAngle=50.0, TubeRadius=0.2)
expected = snapshot()
assert expected[1][2] != 35.0  # the picked points have chosen

simple.SaveState("arris.pvsm")
with open("arris_state.py", "w", encoding="utf-8") as file:
    file.write(smstate.get_state())

simple.ResetSession()
session.load()
simple.LoadState("arris.pvsm")
assert snapshot() == expected, ".pvsm"

simple.ResetSession()
session.load()
with open("arris_state.py", encoding="utf-8") as file:
    exec(compile(file.read(), "arris_state.py", "exec"), {})
assert snapshot() == expected, ".py"
print("both states restore the filters")
