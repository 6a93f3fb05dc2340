# VTK (a distribution's, or the one inside ParaView for the plugin) and Eigen.

# What the filters' library itself needs; also asked for by the installed package.
set(arris_vtk_components CommonCore CommonDataModel CommonExecutionModel FiltersCore
  FiltersSources)

# Always with components: without them VTK asks for everything it was built with (Qt, GDAL ...).
set(vtk_components ${arris_vtk_components})
if (ARRIS_BUILD_PYTHON)
  list(APPEND vtk_components Python WrappingPythonCore WrappingTools)
  # The interpreter that VTK itself was wrapped for: Debian's, not one earlier on the PATH.
  if (NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that VTK was built for")
  endif ()
endif ()
if (ARRIS_BUILD_TOOLS)
  list(APPEND vtk_components
    IOGeometry IOImage IOLegacy IOPLY IOXML RenderingCore RenderingFreeType RenderingOpenGL2)
endif ()

if (ARRIS_BUILD_PLUGIN)
  enable_language(C) # ParaView's VTK links to MPI's C library, which CMake finds in C only
  find_package(ParaView 5.11 REQUIRED
    COMPONENTS RemotingCore RemotingServerManager RemotingViews ProcessXML WrapClientServer VTKExtensionsCore)
  find_package(VTK REQUIRED PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH
    COMPONENTS ${vtk_components})
else ()
  find_package(VTK 9.1 REQUIRED COMPONENTS ${vtk_components})
endif ()
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
