# What the tests need, and how they are registered.

option(ARRIS_TEST_IMAGES "Compare pictures with baselines (needs xvfb-run)" ON)

find_package(GTest 1.10 REQUIRED)
include(GoogleTest)

# One test program from all sources of a folder, and one ctest entry for each of its tests, found
# when ctest runs, so that a program that cannot start fails its tests and not the build.
function (arris_add_test_program name label)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "TIMEOUT" "SOURCES;LIBRARIES;PRECOMPILED")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE
    Arris::Filters Eigen3::Eigen ${arg_LIBRARIES} GTest::GTest GTest::Main)
  # Little optimized and with their headers read once, tests compile in half the time.
  target_compile_options(${name} PRIVATE ${ARRIS_COMPILE_OPTIONS} -O1)
  target_precompile_headers(${name} PRIVATE <gtest/gtest.h> <Eigen/Geometry> ${arg_PRECOMPILED})
  gtest_discover_tests(${name}
    TEST_PREFIX "${label}."
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${label}" TIMEOUT "${arg_TIMEOUT}")
endfunction ()

# Python loads a sanitized module only when the sanitizer's run time is there before it. The
# interpreter itself leaks, so leaks are not looked for.
set(arris_python_environment
  "PYTHONPATH=${CMAKE_BINARY_DIR}/${ARRIS_PYTHON_DIRECTORY}"
  "PYTHONDONTWRITEBYTECODE=1")
foreach (pair IN ITEMS "address;libasan.so" "thread;libtsan.so")
  list(GET pair 0 sanitizer)
  list(GET pair 1 runtime)
  if (sanitizer IN_LIST ARRIS_SANITIZE)
    execute_process(
      COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=${runtime}"
      OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
    list(APPEND arris_python_environment "LD_PRELOAD=${runtime}" "ASAN_OPTIONS=detect_leaks=0")
  endif ()
endforeach ()

# A Python script as a test; further arguments are the command in front of the interpreter.
function (arris_add_python_test label script)
  get_filename_component(name "${script}" NAME_WE)
  add_test(NAME "${label}.${name}"
    COMMAND ${ARGN} "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${script}")
  set_tests_properties("${label}.${name}" PROPERTIES
    LABELS "${label}"
    TIMEOUT 120
    ENVIRONMENT "${arris_python_environment}")
endfunction ()
