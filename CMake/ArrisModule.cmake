# The module itself, as vtk_module_build asks for it.

find_package(Eigen3 3.3 REQUIRED NO_MODULE)

set(classes
  Filters/vtkSharpEdgeExtractor
  Filters/vtkSharpEdgeReconstruction
  Filters/vtkSharpThinningFilter
  Filters/vtkSharpeningFilter
  Filters/vtkUSSODFilter)

set(sources
  Filters/Core/ConnectedWindow.cxx
  Filters/Core/Curves.cxx
  Filters/Core/FeatureEdges.cxx
  Filters/Core/Geometry.cxx
  Filters/Core/Mesh.cxx
  Filters/Core/NormalSpread.cxx
  Filters/Core/Predictor.cxx
  Filters/Core/Sharpening.cxx
  Filters/Core/Skeleton.cxx
  Filters/Core/SpatialWindow.cxx
  Filters/Core/Surfaces.cxx
  Filters/Core/Thinning.cxx
  Filters/Core/Ussod.cxx
  Filters/Support/Arrays.cxx
  Filters/Support/PaperMethod.cxx
  Filters/Support/Polylines.cxx
  Filters/Support/Surface.cxx)

vtk_module_add_module(Arris::Filters
  CLASSES ${classes}
  SOURCES ${sources})
vtk_module_include(Arris::Filters
  PUBLIC
    "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/Filters>")
vtk_module_link(Arris::Filters
  PRIVATE
    Eigen3::Eigen)
vtk_module_set_properties(Arris::Filters
  CXX_STANDARD 17
  CXX_STANDARD_REQUIRED ON)
if (ARRIS_COMPILE_OPTIONS)
  vtk_module_compile_options(Arris::Filters
    PRIVATE
      ${ARRIS_COMPILE_OPTIONS})
endif ()
