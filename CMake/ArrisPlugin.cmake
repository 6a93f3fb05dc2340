# The ParaView plugin, from the module that ArrisBuild has built. It goes where ParaView looks:
# lib/paraview-VERSION/plugins.

option(ARRIS_PLUGIN_HELP
  "Build the plugin's pages for ParaView's help (needs Qt's help and xmlpatterns tools)" OFF)

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
