# The package that find_package(Arris) finds. vtk_module_build installs the library, its headers and
# targets, Tools/ the program and its data.

include(CMakePackageConfigHelpers)
configure_package_config_file(CMake/ArrisConfig.cmake.in
  "${CMAKE_CURRENT_BINARY_DIR}/package/ArrisConfig.cmake"
  INSTALL_DESTINATION "${arris_cmake_directory}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/package/ArrisConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_CURRENT_BINARY_DIR}/package/ArrisConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/package/ArrisConfigVersion.cmake"
  DESTINATION "${arris_cmake_directory}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/arris" OPTIONAL)
