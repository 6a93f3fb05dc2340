# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Imports the installed Python package and runs it; its library must be the installed one too.

    installed_python.py PREFIX
"""

import pathlib
import sys

import arris
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource

prefix = pathlib.Path(sys.argv[1]).resolve()
assert prefix in pathlib.Path(arris.__file__).resolve().parents, arris.__file__

mapped = {line.split()[-1] for line in open("/proc/self/maps") if "libArrisFilters" in line}
assert mapped, "the filters' library is not loaded"
for library in mapped:
    assert prefix in pathlib.Path(library).resolve().parents, library

classes = {name for name in dir(arris) if name.startswith("vtk") and name != "vtkmodules"}
expected = {"vtkAssemblyAlgorithm", "vtkSharpEdgeExtractor", "vtkSharpEdgePreview", "vtkSharpEdgeReconstruction",
            "vtkSharpRegionAlgorithm", "vtkSharpThinningFilter", "vtkSharpeningFilter",
            "vtkUSSODFilter"}
assert classes == expected, classes ^ expected

cube = vtkPlatonicSolidSource()
cube.SetSolidTypeToCube()
ussod = arris.vtkUSSODFilter()
ussod.SetInputConnection(cube.GetOutputPort())
ussod.Update()
region = ussod.GetOutput().GetPointData().GetArray("SharpRegion")
assert [region.GetValue(i) for i in range(region.GetNumberOfTuples())] == [1] * 8
print("imported from", pathlib.Path(arris.__file__).parent)
