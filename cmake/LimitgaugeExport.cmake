# The libraries for programs of others: find_package(Limitgauge), see docs/cpp.md.

# limitgauge_link_files(OUT item...): the files that linking the items comes down to. Imported
# targets and interface libraries are followed; what is headers only leaves nothing.
function(limitgauge_link_files out)
  set(todo ${ARGN})
  set(seen)
  set(files)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  while(todo)
    list(POP_FRONT todo item)
    if(item MATCHES "^\\$<LINK_ONLY:(.*)>$")
      set(item ${CMAKE_MATCH_1})
    endif()
    if(item IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${item})
    if(NOT TARGET "${item}")
      list(APPEND files ${item})
      continue()
    endif()
    get_target_property(kind ${item} TYPE)
    if(NOT kind STREQUAL "INTERFACE_LIBRARY")
      get_target_property(file ${item} LOCATION_${type})
      list(APPEND files ${file})
    endif()
    get_target_property(more ${item} INTERFACE_LINK_LIBRARIES)
    if(more)
      list(APPEND todo ${more})
    endif()
  endwhile()
  list(REMOVE_DUPLICATES files)
  set(${out} ${files} PARENT_SCOPE)
endfunction()

# limitgauge_seal(TARGET): a static library hands what it links privately on to whoever links it. In
# the build tree these are targets; where it is installed, the files that they stand for, so that
# nobody has to find packages whose headers they never see. Called when the folder is read to its
# end, where the targets that it found can still be seen.
function(limitgauge_seal target)
  get_target_property(links ${target} INTERFACE_LINK_LIBRARIES)
  set(sealed)
  set(all_files)
  foreach(link IN LISTS links)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" item "${link}")
    set(house FALSE)
    if(TARGET "${item}")
      get_target_property(house ${item} LIMITGAUGE_FOLDERS)
    endif()
    if(house)
      list(APPEND sealed "${link}")
      continue()
    endif()
    limitgauge_link_files(files ${item})
    list(APPEND all_files ${files})
    list(APPEND sealed "$<BUILD_INTERFACE:${link}>")
    foreach(file IN LISTS files)
      list(APPEND sealed "$<INSTALL_INTERFACE:${file}>")
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES
    INTERFACE_LINK_LIBRARIES "${sealed}" LIMITGAUGE_LINK_FILES "${all_files}")
endfunction()

# limitgauge_install_libraries(name...): these libraries of the house, and those that they link.
function(limitgauge_install_libraries)
  set(todo ${ARGN})
  set(names)
  while(todo)
    list(POP_FRONT todo name)
    if(name IN_LIST names)
      continue()
    endif()
    list(APPEND names ${name})
    get_target_property(links limitgauge_${name} INTERFACE_LINK_LIBRARIES)
    string(REGEX MATCHALL "limitgauge::[a-z_]+" links "${links}")
    list(TRANSFORM links REPLACE "limitgauge::" "")
    list(APPEND todo ${links})
  endwhile()

  set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Limitgauge)
  set(link_files)
  foreach(name IN LISTS names)
    set_target_properties(limitgauge_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS limitgauge_${name} EXPORT LimitgaugeTargets
      ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Development)
    get_target_property(folders limitgauge_${name} LIMITGAUGE_FOLDERS)
    foreach(folder IN LISTS folders)
      if(IS_DIRECTORY ${LIMITGAUGE_ROOT}/${folder})
        install(DIRECTORY ${LIMITGAUGE_ROOT}/${folder}/
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/limitgauge/${folder} COMPONENT Development
          FILES_MATCHING PATTERN "*.h")
      else()
        cmake_path(GET folder PARENT_PATH parent)
        install(FILES ${LIMITGAUGE_ROOT}/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/limitgauge/${parent} COMPONENT Development)
      endif()
    endforeach()
    get_target_property(files limitgauge_${name} LIMITGAUGE_LINK_FILES)
    list(APPEND link_files ${files})
  endforeach()
  list(REMOVE_DUPLICATES link_files)
  set(LIMITGAUGE_LINK_FILES ${link_files} PARENT_SCOPE)

  install(EXPORT LimitgaugeTargets NAMESPACE limitgauge:: DESTINATION ${package_dir}
    COMPONENT Development)
  include(CMakePackageConfigHelpers)
  configure_package_config_file(${LIMITGAUGE_ROOT}/cmake/LimitgaugeConfig.cmake.in
    ${CMAKE_BINARY_DIR}/package/LimitgaugeConfig.cmake INSTALL_DESTINATION ${package_dir}
    NO_SET_AND_CHECK_MACRO)
  # Before version 1.0 any minor version may change what a program of others calls.
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/LimitgaugeConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/package/LimitgaugeConfig.cmake
      ${CMAKE_BINARY_DIR}/package/LimitgaugeConfigVersion.cmake
    DESTINATION ${package_dir} COMPONENT Development)
endfunction()
