# The module itself, as vtk_module_build asks for it.

find_package(Eigen3 3.3 REQUIRED NO_MODULE)

set(classes
  Filters/vtkAssemblyAlgorithm
  Filters/vtkSharpEdgeExtractor
  Filters/vtkSharpEdgePreview
  Filters/vtkSharpEdgeReconstruction
  Filters/vtkSharpRegionAlgorithm
  Filters/vtkSharpThinningFilter
  Filters/vtkSharpeningFilter
  Filters/vtkUSSODFilter)

set(sources
  Filters/Core/ConnectedWindow.cxx
  Filters/Core/Curves.cxx
  Filters/Core/EdgeGraph.cxx
  Filters/Core/EdgeLengths.cxx
  Filters/Core/Flagged.cxx
  Filters/Core/FreeBoundary.cxx
  Filters/Core/Geometry.cxx
  Filters/Core/Intersections.cxx
  Filters/Core/Kinks.cxx
  Filters/Core/Mesh.cxx
  Filters/Core/NormalSpread.cxx
  Filters/Core/Picks.cxx
  Filters/Core/Predictor.cxx
  Filters/Core/RegionOutline.cxx
  Filters/Core/Sharpening.cxx
  Filters/Core/Skeleton.cxx
  Filters/Core/SpatialWindow.cxx
  Filters/Core/Thinning.cxx
  Filters/Core/TriangleCrossing.cxx
  Filters/Core/Ussod.cxx
  Filters/Core/Assembly/Assembly.cxx
  Filters/Core/Assembly/CoincidentPoints.cxx
  Filters/Core/Assembly/Fans.cxx
  Filters/Core/Assembly/Orientation.cxx
  Filters/Core/Assembly/PatchesApart.cxx
  Filters/Core/Assembly/Welding.cxx
  Filters/Core/Features/CurveProperties.cxx
  Filters/Core/Features/FeatureCorners.cxx
  Filters/Core/Features/FeatureEdges.cxx
  Filters/Core/Features/FeatureExtraction.cxx
  Filters/Core/Features/FeatureSelection.cxx
  Filters/Core/Features/FoldAlong.cxx
  Filters/Core/Features/Folds.cxx
  Filters/Core/Features/Gaps.cxx
  Filters/Core/Features/Hysteresis.cxx
  Filters/Core/Features/NearCorners.cxx
  Filters/Core/Features/Noise.cxx
  Filters/Core/Features/Resampling.cxx
  Filters/Core/Features/Slivers.cxx
  Filters/Core/Features/Surfaces.cxx
  Filters/Core/Features/Tails.cxx
  Filters/Core/Features/Tips.cxx
  Filters/Core/Fits/FaceFit.cxx
  Filters/Core/Fits/FirstGuess.cxx
  Filters/Core/Fits/LeastSquares.cxx
  Filters/Core/Fits/Primitive.cxx
  Filters/Core/Fits/Refine.cxx
  Filters/Core/Robust/Account.cxx
  Filters/Core/Robust/Apexes.cxx
  Filters/Core/Robust/Clusters.cxx
  Filters/Core/Robust/ConeTip.cxx
  Filters/Core/Robust/Creases.cxx
  Filters/Core/Robust/DamageFinder.cxx
  Filters/Core/Robust/Denoised.cxx
  Filters/Core/Robust/Ears.cxx
  Filters/Core/Robust/EdgeFlips.cxx
  Filters/Core/Robust/Faces.cxx
  Filters/Core/Robust/FanWorth.cxx
  Filters/Core/Robust/FarFromRidge.cxx
  Filters/Core/Robust/FineBends.cxx
  Filters/Core/Robust/GiveBack.cxx
  Filters/Core/Robust/Junctions.cxx
  Filters/Core/Robust/Labels.cxx
  Filters/Core/Robust/Labelling.cxx
  Filters/Core/Robust/LocalSolid.cxx
  Filters/Core/Robust/MeetingEdges.cxx
  Filters/Core/Robust/MeetSheets.cxx
  Filters/Core/Robust/Mender.cxx
  Filters/Core/Robust/Mending.cxx
  Filters/Core/Robust/Neighbourhoods.cxx
  Filters/Core/Robust/OtherOrders.cxx
  Filters/Core/Robust/Overturned.cxx
  Filters/Core/Robust/OwnFrame.cxx
  Filters/Core/Robust/OwnMesh.cxx
  Filters/Core/Robust/OwnOrder.cxx
  Filters/Core/Robust/Patches.cxx
  Filters/Core/Robust/Placement.cxx
  Filters/Core/Robust/Region.cxx
  Filters/Core/Robust/Retreat.cxx
  Filters/Core/Robust/Ridge.cxx
  Filters/Core/Robust/RightAlready.cxx
  Filters/Core/Robust/Robust.cxx
  Filters/Core/Robust/Roughness.cxx
  Filters/Core/Robust/Settled.cxx
  Filters/Core/Robust/Sheet.cxx
  Filters/Core/Robust/Sides.cxx
  Filters/Core/Robust/Straighten.cxx
  Filters/Core/Robust/ThinFaces.cxx
  Filters/Core/Robust/Turn.cxx
  Filters/Core/Robust/Unblurred.cxx
  Filters/Core/Robust/Unexplained.cxx
  Filters/Core/Robust/Untangle.cxx
  Filters/Support/Arrays.cxx
  Filters/Support/AssembledSurface.cxx
  Filters/Support/Blocks.cxx
  Filters/Support/Classification.cxx
  Filters/Support/FaceTable.cxx
  Filters/Support/FeatureOutputs.cxx
  Filters/Support/PaperMethod.cxx
  Filters/Support/PatchIds.cxx
  Filters/Support/PickedPoints.cxx
  Filters/Support/PointMerging.cxx
  Filters/Support/Polylines.cxx
  Filters/Support/PreviewMarks.cxx
  Filters/Support/ReplaceTriangles.cxx
  Filters/Support/RobustMethod.cxx
  Filters/Support/Selections.cxx
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
# Contraction of a*b + c to one rounding differs between compilers and processors; without it the
# same input gives the same bytes on all of them.
vtk_module_compile_options(Arris::Filters
  PRIVATE
    -ffp-contract=off
    ${ARRIS_COMPILE_OPTIONS})

# With the headers of Eigen and VTK read once for all, the library compiles in two thirds of the time.
# scripts/lint compiles without, so that each source still includes what it uses.
get_target_property(filters Arris::Filters ALIASED_TARGET)
target_precompile_headers(${filters} PRIVATE
  <algorithm> <cmath> <functional> <limits> <map> <memory> <numeric> <queue> <set> <string> <vector>
  <Eigen/Dense>
  <vtkCellArray.h> <vtkPointData.h> <vtkPolyData.h> <vtkPolyDataAlgorithm.h> <vtkSMPTools.h>)
