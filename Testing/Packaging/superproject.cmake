# Configures the superproject in SOURCE with OPTIONS, builds it in BINARY on all cores
# (ctest --build-and-test takes one), and runs its program.

cmake_minimum_required(VERSION 3.18...3.25)

include("${CMAKE_CURRENT_LIST_DIR}/run.cmake")
include(ProcessorCount)
ProcessorCount(processors)

run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}" -G "${GENERATOR}" ${OPTIONS})
run("${CMAKE_COMMAND}" --build "${BINARY}" --parallel "${processors}")
run("${BINARY}/superproject")
