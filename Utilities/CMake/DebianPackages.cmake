# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Debian packages by `cmake --workflow --preset packages`: one for each part of the installation.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME seismichorizons)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "SeismicHorizons contributors")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "seismic horizons to clean triangle meshes")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development python doc)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF) # they are named below, with their versions
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_SOURCE_DIR}/Utilities/CMake/PackageTools.cmake")
# Where dpkg-shlibdeps finds the library of our own that the others stand on.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

set(soversion "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(library "libvtkseismichorizons${soversion}")
set(same_library "${library} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# seismichorizons_package(COMPONENT NAME DESCRIPTION): what users see of a package.
macro (seismichorizons_package component name description)
  string(TOUPPER "${component}" upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${name}" COMPONENT "${component}" RENAME copyright)
endmacro ()

seismichorizons_package(runtime "${library}"
  "Readers, filters and writers that turn picks and voxels of seismic horizons into clean triangle meshes.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_GENERATE_SHLIBS ON)

seismichorizons_package(development libvtkseismichorizons-dev
  "C++ headers of the VTK module SeismicHorizons::SeismicHorizons, and its description for CMake.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${same_library}, paraview-dev")

seismichorizons_package(python python3-seismichorizons
  "The command horizon-mesh, and the Python package seismichorizons that it stands on.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
install(FILES Python/NOTICES.txt DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/python3-seismichorizons" COMPONENT python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_library}, python3-numpy, python3-paraview")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${PROJECT_SOURCE_DIR}/Utilities/Packaging/python/postinst"
  "${PROJECT_SOURCE_DIR}/Utilities/Packaging/python/prerm")

seismichorizons_package(doc seismichorizons-doc
  "Pages, pictures and a sample of SeismicHorizons: readers, stages, writers, tutorials, formats and messages.")
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)

if (SEISMICHORIZONS_PARAVIEW_PLUGIN)
  list(APPEND CPACK_COMPONENTS_ALL paraview_plugins)
  seismichorizons_package(paraview_plugins seismichorizons
    "Menu, toolbar and file formats for ParaView, in its window, in pvpython, pvbatch and pvserver. Loaded by itself.")
  set(CPACK_DEBIAN_PARAVIEW_PLUGINS_PACKAGE_DEPENDS "${same_library}, paraview")
  set(CPACK_DEBIAN_PARAVIEW_PLUGINS_PACKAGE_RECOMMENDS "python3-seismichorizons (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
  # ParaView loads what a file beside its programs lists. The list is shared with other plugins, so lines are added
  # and removed when packages are.
  set(plugin_list "/usr/bin/paraview.conf")
  set(plugin_file "/usr/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/seismichorizons.plugins.xml")
  foreach (script IN ITEMS postinst prerm)
    configure_file(Utilities/Packaging/plugin/${script}.in "${CMAKE_BINARY_DIR}/Packaging/${script}" @ONLY
      FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endforeach ()
  set(CPACK_DEBIAN_PARAVIEW_PLUGINS_PACKAGE_CONTROL_EXTRA
    "${CMAKE_BINARY_DIR}/Packaging/postinst" "${CMAKE_BINARY_DIR}/Packaging/prerm")
endif ()

include(CPack)
