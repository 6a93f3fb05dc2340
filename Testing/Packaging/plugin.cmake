# Builds SOURCE for the ParaView in PARAVIEW, in BINARY, and runs the plugin's tests there.

cmake_minimum_required(VERSION 3.18...3.25)

file(GLOB config "${PARAVIEW}/usr/lib/*/cmake/paraview-*/paraview-config.cmake")
if (NOT config)
  message("SKIPPED: no ParaView in ${PARAVIEW}. scripts/paraview-prefix.sh puts it there.")
  return ()
endif ()
get_filename_component(paraview_directory "${config}" DIRECTORY)

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")

run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}" -G "${GENERATOR}"
  -DARRIS_BUILD_PLUGIN=ON -DARRIS_BUILD_TOOLS=OFF
  "-DARRIS_WARNINGS_AS_ERRORS=${WARNINGS_AS_ERRORS}"
  "-DParaView_DIR=${paraview_directory}")
include(ProcessorCount)
ProcessorCount(processors)
run("${CMAKE_COMMAND}" --build "${BINARY}" --parallel "${processors}")
execute_process(COMMAND "${CMAKE_CTEST_COMMAND}" --test-dir "${BINARY}" --output-on-failure
  --parallel "${processors}"
  --no-tests=error RESULT_VARIABLE status)
if (NOT status EQUAL 0)
  message(FATAL_ERROR "The plugin's tests failed")
endif ()
