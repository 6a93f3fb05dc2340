# What a user may choose, and how everything is compiled.

option(ARRIS_BUILD_PYTHON "Wrap the filters for Python" ON)
option(ARRIS_BUILD_TOOLS "Build the arris program" ON)
option(ARRIS_BUILD_TESTING "Build the tests" ON)
option(ARRIS_BUILD_BENCHMARKS "Build the programs that time the filters (needs Google Benchmark)" OFF)
option(ARRIS_BUILD_PLUGIN "Build for ParaView's VTK, with the ParaView plugin" OFF)
option(ARRIS_BUILD_FUZZERS "Build the fuzzers of Testing/Fuzz (clang only)" OFF)
option(ARRIS_WARNINGS_AS_ERRORS "Stop at any compiler warning" OFF)
set(ARRIS_SANITIZE "" CACHE STRING
  "Sanitizers to build with, for example address;undefined or thread")
set(ARRIS_PYTHON_DIRECTORY "lib/python3/dist-packages" CACHE STRING
  "Where the Python package goes, below the build and the install folder")
mark_as_advanced(ARRIS_PYTHON_DIRECTORY)

set(BUILD_SHARED_LIBS ON) # Python can import nothing else
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON) # for clang-tidy and editors
if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
endif ()

include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

set(ARRIS_COMPILE_OPTIONS -Wall -Wextra -Wshadow)
if (ARRIS_WARNINGS_AS_ERRORS)
  list(APPEND ARRIS_COMPILE_OPTIONS -Werror)
endif ()

if (ARRIS_SANITIZE)
  list(JOIN ARRIS_SANITIZE "," arris_sanitizers)
  add_compile_options(
    "-fsanitize=${arris_sanitizers}" -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options("-fsanitize=${arris_sanitizers}")
endif ()

if (ARRIS_BUILD_FUZZERS)
  # Counts which branches an input has reached; what numbers are compared with is left out, as that
  # takes half of the time.
  add_compile_options(-fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
endif ()
