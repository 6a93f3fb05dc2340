# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""A client of a pvserver gives the same as ParaView by itself.

    client.py pvserver
"""

import re
import subprocess
import sys

import arris
import session
from paraview import simple
from session import extremes, fetch, same, select, used

session.load()  # on the client, before there is a server

# Port 0: the system finds a free one, and the server says which.
server = subprocess.Popen([sys.argv[1], "--server-port=0"], stdout=subprocess.PIPE, text=True)
try:
    port = None
    while port is None:
        said = server.stdout.readline()
        assert said, "pvserver ended"
        port = re.search(r"Accepting connection\(s\): .*:(\d+)", said)
    simple.Connect("localhost", int(port[1]))
    simple.LoadPlugin(session.PLUGIN, remote=True)

    contour = session.contour()
    ussod = simple.USSOD(Input=contour)
    plain = arris.vtkUSSODFilter()
    plain.SetInputData(fetch(contour))
    plain.Update()
    edge = plain.GetUsedWindow() / plain.GetUsedWindowRatio()
    assert abs(ussod.Window - 0.75 * edge) < 1e-6 * edge  # the length came from the server
    plain.SetWindow(ussod.Window)
    plain.Update()
    same(fetch(ussod), plain.GetOutput(), "USSOD")

    sharp, _ = extremes(ussod)
    ussod.SharpPoints = select(sharp)
    ussod.UpdatePipeline()
    assert used(ussod)[2] != ussod.SharpAngle  # chosen by the picked point

    recovery = simple.SharpEdgeReconstruction(Input=contour)
    plain = arris.vtkSharpEdgeReconstruction()
    plain.SetInputData(fetch(contour))
    plain.Update()
    same(fetch(recovery), plain.GetOutput(), "Sharp Edge Reconstruction")
    simple.Disconnect()
finally:
    server.kill()
    server.wait()
print("the server's numbers are the same")
