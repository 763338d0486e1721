# `cpack -G DEB`: limitgauge (the program and its documents) and liblimitgauge-dev (libraries and
# headers). docs/install.md says how.
set(CPACK_PACKAGE_NAME limitgauge)
set(CPACK_PACKAGE_VENDOR Limitgauge)
set(CPACK_PACKAGE_CONTACT "Limitgauge maintainers <limitgauge@packages.invalid>"
  CACHE STRING "Whom packages name as their maintainer")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "go / no-go gauge for milling toolpaths")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_RESOURCE_FILE_README ${CMAKE_SOURCE_DIR}/README.md)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL Runtime Development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Limitgauge cuts a part in simulation, measures what was cut against the exact
Catmull-Clark limit surface of the design, and says go or no-go, stage by
stage, before a real cutter moves. Every figure carries a proven bound.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "Static libraries and headers of Limitgauge, and its package for CMake's
find_package: certify toolpaths from C++.")

set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_LIMITGAUGE_DEBIAN ${CMAKE_SOURCE_DIR}/cmake/debian)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME limitgauge)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
# By dpkg-shlibdeps: what the program is linked with.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS paraview)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblimitgauge-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# A static library names the files that a program which links it needs: their packages.
find_program(DPKG_QUERY dpkg-query)
mark_as_advanced(DPKG_QUERY)
set(needed)
if(DPKG_QUERY)
  foreach(file IN LISTS LIMITGAUGE_LINK_FILES)
    if(NOT IS_ABSOLUTE ${file})
      continue()  # m and the like, which come with every compiler
    endif()
    execute_process(COMMAND ${DPKG_QUERY} --search ${file}
      OUTPUT_VARIABLE owner ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT owner MATCHES "^([a-z0-9.+-]+)")
      message(STATUS "No Debian package has ${file}: liblimitgauge-dev will not ask for it")
      continue()
    endif()
    list(APPEND needed ${CMAKE_MATCH_1})
  endforeach()
  list(REMOVE_DUPLICATES needed)
  list(SORT needed)
  list(JOIN needed ", " needed)
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${needed}")

include(CPack)
