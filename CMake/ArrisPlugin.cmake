# The ParaView plugin, from the module that ArrisBuild has built. It goes where ParaView looks:
# lib/paraview-VERSION/plugins.

# With Qt's development files the menu has icons; with its tools, too, ParaView's help has pages.
find_package(Qt5 QUIET COMPONENTS Core)
set(ARRIS_PLUGIN_RESOURCES)
set(arris_help OFF)
if (PARAVIEW_USE_QT AND Qt5_FOUND)
  set(ARRIS_PLUGIN_RESOURCES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/Arris.qrc")
  find_package(Qt5 QUIET COMPONENTS Help)
  find_program(ARRIS_XMLPATTERNS NAMES xmlpatterns-qt5 xmlpatterns HINTS /usr/lib/qt5/bin)
  mark_as_advanced(ARRIS_XMLPATTERNS)
  if (Qt5_FOUND AND ARRIS_XMLPATTERNS)
    set(arris_help ON)
  endif ()
endif ()
option(ARRIS_PLUGIN_HELP
  "Build the plugin's pages for ParaView's help (needs Qt's help and xmlpatterns tools)"
  ${arris_help})

paraview_plugin_scan(
  PLUGIN_FILES      "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS  arris_plugins
  REQUIRES_MODULES  arris_plugin_modules
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS              ${arris_plugins}
  AUTOLOAD             ${arris_plugins}
  PLUGINS_FILE_NAME    arris.plugins.xml
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  INSTALL_HEADERS      OFF)
