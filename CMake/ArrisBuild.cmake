# Builds the module, and its Python package `arris`.

set(arris_cmake_directory "${CMAKE_INSTALL_LIBDIR}/cmake/arris")

set(arris_module_files "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module")
set(arris_requested_modules Arris::Filters)
if (ARRIS_BUILD_PLUGIN)
  list(APPEND arris_module_files "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/ServerManager/vtk.module")
  list(APPEND arris_requested_modules Arris::ServerManager)
endif ()
vtk_module_scan(
  MODULE_FILES        ${arris_module_files}
  REQUEST_MODULES     ${arris_requested_modules}
  PROVIDES_MODULES    arris_modules
  REQUIRES_MODULES    arris_required_modules
  HIDE_MODULES_FROM_CACHE ON
  WANT_BY_DEFAULT     ON
  ENABLE_TESTS        OFF)

# vtk_module_build adds the module's directory, which is this one again; two source directories
# cannot share a binary directory, so the module gets one below.
function (arris_build_module)
  set(CMAKE_BINARY_DIR "${PROJECT_BINARY_DIR}/module")
  vtk_module_build(
    MODULES             ${arris_modules}
    PACKAGE             Arris
    INSTALL_EXPORT      Arris
    INSTALL_HEADERS     ON
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/arris"
    CMAKE_DESTINATION   "${arris_cmake_directory}"
    ARCHIVE_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
    LIBRARY_NAME_SUFFIX ""
    VERSION             "${PROJECT_VERSION}"
    SOVERSION           "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
    BUILD_WITH_KITS     OFF)
endfunction ()
arris_build_module()

if (ARRIS_BUILD_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  vtk_module_wrap_python(
    MODULES             Arris::Filters
    TARGET              Arris::Python
    PYTHON_PACKAGE      arris
    MODULE_DESTINATION  "${ARRIS_PYTHON_DIRECTORY}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}" # from it the run-time path follows
    BUILD_STATIC        OFF
    INSTALL_HEADERS     OFF) # they hold a Python.h that would shadow CPython's

  set(arris_init "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Python/__init__.py")
  configure_file("${arris_init}" "${CMAKE_BINARY_DIR}/${ARRIS_PYTHON_DIRECTORY}/arris/__init__.py"
    COPYONLY)
  install(FILES "${arris_init}" DESTINATION "${ARRIS_PYTHON_DIRECTORY}/arris")
endif ()
