# Checks what an installation in PREFIX consists of: exactly the public headers, a package that
# names no folder of the build, and nothing that belongs to the build alone.

cmake_minimum_required(VERSION 3.18...3.25)

function (expect_files folder)
  file(GLOB found RELATIVE "${PREFIX}/${folder}" LIST_DIRECTORIES ON "${PREFIX}/${folder}/*")
  list(SORT found)
  set(expected ${ARGN})
  list(SORT expected)
  if (NOT found STREQUAL expected)
    message(SEND_ERROR "${folder} holds\n  ${found}\ninstead of\n  ${expected}")
  endif ()
endfunction ()

expect_files("include/arris"
  ArrisFiltersModule.h vtkAssemblyAlgorithm.h vtkSharpEdgeExtractor.h vtkSharpEdgePreview.h vtkSharpEdgeReconstruction.h
  vtkSharpRegionAlgorithm.h vtkSharpThinningFilter.h vtkSharpeningFilter.h vtkUSSODFilter.h)
expect_files("include" arris)
if (PROGRAM)
  expect_files("bin" arris)
  expect_files("share/arris" bracket-edges.vtp bracket.mha bracket.ply)
endif ()
if (PYTHON)
  expect_files("${PYTHON_DIRECTORY}/arris" ArrisFilters.so __init__.py)
endif ()

file(GLOB_RECURSE texts "${PREFIX}/*.cmake" "${PREFIX}/*.txt" "${PREFIX}/*.h" "${PREFIX}/*.py")
foreach (text IN LISTS texts)
  file(READ "${text}" content)
  foreach (folder IN ITEMS "${SOURCE}" "${BUILD}" "${PREFIX}")
    string(REGEX REPLACE "([][+.*()^$?|\\\\])" "\\\\\\1" pattern "${folder}")
    if (content MATCHES "(^|[^A-Za-z0-9_.})>-])${pattern}/") # as an absolute path
      message(SEND_ERROR "${text} names ${folder}")
    endif ()
  endforeach ()
endforeach ()

file(GLOB_RECURSE libraries "${PREFIX}/*.so" "${PREFIX}/bin/*")
foreach (library IN LISTS libraries)
  file(STRINGS "${library}" strings REGEX "${BUILD}/") # a run-time path into the build
  if (strings)
    message(SEND_ERROR "${library} names the build: ${strings}")
  endif ()
endforeach ()
