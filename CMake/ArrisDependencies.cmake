# VTK (a distribution's, or the one inside ParaView for the plugin) and Eigen.

# Always with components: without them VTK asks for everything it was built with (Qt, GDAL ...).
set(vtk_components CommonCore CommonDataModel CommonExecutionModel FiltersCore)
if (ARRIS_BUILD_PYTHON)
  list(APPEND vtk_components Python WrappingPythonCore WrappingTools)
endif ()
if (ARRIS_BUILD_TOOLS)
  list(APPEND vtk_components
    FiltersGeneral FiltersSources IOGeometry IOImage IOLegacy IOPLY IOXML RenderingCore
    RenderingOpenGL2 RenderingAnnotation)
endif ()

if (ARRIS_BUILD_PLUGIN)
  find_package(ParaView REQUIRED
    COMPONENTS RemotingCore RemotingServerManager ProcessXML WrapClientServer VTKExtensionsCore)
  find_package(VTK REQUIRED PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH
    COMPONENTS ${vtk_components})
else ()
  find_package(VTK 9.1 REQUIRED COMPONENTS ${vtk_components})
endif ()
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
