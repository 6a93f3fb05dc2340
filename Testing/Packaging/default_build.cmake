# `cmake -S SOURCE -B BINARY && cmake --build BINARY`, and what must be there afterwards. To be quick,
# it builds the library and the Python package only; the program and the tests are built with the
# same generator by whoever runs this.

cmake_minimum_required(VERSION 3.18...3.25)
unset(ENV{CMAKE_GENERATOR})
unset(ENV{CMAKE_BUILD_TYPE})

function (run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if (NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "'${command}' failed (${status})")
  endif ()
endfunction ()

run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${BINARY}")
include(ProcessorCount)
ProcessorCount(processors)
run("${CMAKE_COMMAND}" --build "${BINARY}" --parallel "${processors}"
  --target Filters ArrisFiltersPython)

file(STRINGS "${BINARY}/CMakeCache.txt" build_type REGEX "^CMAKE_BUILD_TYPE:STRING=Release$")
if (NOT build_type)
  message(FATAL_ERROR "A build without a build type is not a Release build")
endif ()
run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${BINARY}/lib/python3/dist-packages"
  /usr/bin/python3 -B -c "from arris import vtkSharpEdgeReconstruction")
