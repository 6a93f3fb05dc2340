# `cmake -S SOURCE -B BINARY && cmake --build BINARY`, and what must be there afterwards. To be quick,
# it builds the library and the Python package only, and not even these where the surrounding build
# (with GENERATOR) has built the same with the same generator.

cmake_minimum_required(VERSION 3.18...3.25)
unset(ENV{CMAKE_GENERATOR})
unset(ENV{CMAKE_BUILD_TYPE})

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}")
load_cache("${BINARY}" READ_WITH_PREFIX cached_
  CMAKE_BUILD_TYPE CMAKE_GENERATOR ARRIS_BUILD_PYTHON ARRIS_BUILD_TOOLS ARRIS_BUILD_TESTING)
if (NOT cached_CMAKE_BUILD_TYPE STREQUAL "Release")
  message(FATAL_ERROR "Without a build type this is '${cached_CMAKE_BUILD_TYPE}', not Release")
endif ()
foreach (part IN ITEMS PYTHON TOOLS TESTING)
  if (NOT cached_ARRIS_BUILD_${part})
    message(FATAL_ERROR "Without options ARRIS_BUILD_${part} is off")
  endif ()
endforeach ()
if (cached_CMAKE_GENERATOR STREQUAL GENERATOR)
  message("The surrounding build is by ${GENERATOR} too; configured only.")
  return ()
endif ()

include(ProcessorCount)
ProcessorCount(processors)
run("${CMAKE_COMMAND}" --build "${BINARY}" --parallel "${processors}"
  --target Filters ArrisFiltersPython)
run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${BINARY}/lib/python3/dist-packages"
  /usr/bin/python3 -B -c "from arris import vtkSharpEdgeReconstruction")
