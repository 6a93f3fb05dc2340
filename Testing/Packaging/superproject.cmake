# Configures the superproject in SOURCE with the options after "--", builds it in BINARY on all cores
# (ctest --build-and-test takes one), and runs its program.

cmake_minimum_required(VERSION 3.18...3.25)

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
include(ProcessorCount)
ProcessorCount(processors)

set(options)
set(are_options OFF)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach (k RANGE ${last})
  if (are_options)
    list(APPEND options "${CMAKE_ARGV${k}}")
  elseif ("${CMAKE_ARGV${k}}" STREQUAL "--")
    set(are_options ON)
  endif ()
endforeach ()

run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}" -G "${GENERATOR}" ${options})
run("${CMAKE_COMMAND}" --build "${BINARY}" --parallel "${processors}")
run("${BINARY}/superproject")
