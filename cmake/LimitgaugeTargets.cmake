get_filename_component(LIMITGAUGE_ROOT ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
include(GNUInstallDirs)
include(LimitgaugeExport)

# Warnings and sanitizers shared by every target of the project.
add_library(limitgauge_options INTERFACE)
target_compile_options(limitgauge_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # GCC 12 takes "text" + std::string for overlapping copies (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # GCC 13 and 14 take a reference into an argument for one into a temporary beside it (GCC bug 107532).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>
  # The same input gives the same bytes wherever it is built: no fused multiply-add.
  -ffp-contract=off
  # Nothing here asks errno or the flags of the floating-point unit what became of a root: the same bits, and a
  # square root or a floor is an instruction instead of a call or a branch round one.
  -fno-math-errno -fno-trapping-math)
if(LIMITGAUGE_WERROR)
  # A target may ask to be told only: -Wno-error of its own would come before this one.
  target_compile_options(limitgauge_options INTERFACE
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:LIMITGAUGE_WARNINGS_TOLD>>>:-Werror>
    # GCC 14 at -O3 says this of a vector made from a span and sorted, whose memory is the vector's own.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-error=free-nonheap-object>)
endif()
if(LIMITGAUGE_SANITIZE)
  target_compile_options(limitgauge_options INTERFACE
    # A target may ask for the address sanitizer alone.
    -fsanitize=address $<$<NOT:$<BOOL:$<TARGET_PROPERTY:LIMITGAUGE_ADDRESSES_ONLY>>>:-fsanitize=undefined>
    -fno-sanitize-recover=undefined -fno-omit-frame-pointer
    # What goes through a null pointer ends under the address sanitizer as well; asking at each access took a
    # quarter of the time to compile, and x86-64 reads from anywhere.
    -fno-sanitize=null,alignment
    # GCC sees uninitialised members in the library's own std::regex once it is instrumented.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(limitgauge_options INTERFACE -fsanitize=address,undefined)
endif()
if(LIMITGAUGE_FUZZ)
  # A number that does not fit the type that it becomes is undefined, too, but not in the group.
  set(fuzz_checks -fsanitize=address,undefined,float-cast-overflow)
  target_compile_options(limitgauge_options INTERFACE
    ${fuzz_checks} -fsanitize=fuzzer-no-link -fno-sanitize-recover=all -fno-omit-frame-pointer
    # As above; objects' sizes are the address sanitizer's to watch, and readers call nothing through a wrong type.
    # A quarter of the time to compile.
    -fno-sanitize=null,alignment,vptr,object-size)
  target_compile_definitions(limitgauge_options INTERFACE
    # libFuzzer's own word: bounds on what a text may expand to shrink by what sanitizers cost.
    FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)
  target_link_options(limitgauge_options INTERFACE ${fuzz_checks})
endif()

# limitgauge_unity(TARGET SOURCES file... [GROUPS count] [APART folder...])
#
# With LIMITGAUGE_UNITY the sources of one folder are compiled as one file, which reads the headers that they
# share once: names in their anonymous namespaces must differ within a folder. Files that lie nowhere in the
# source tree (texts made at build time) and those of folders named APART stay by themselves. With GROUPS the
# folders are put together to that many files: where each would read and make the same templates again (JSON
# above all), which takes twice the time. Names must differ within a group then.
function(limitgauge_unity target)
  cmake_parse_arguments(U "" "GROUPS" "SOURCES;APART" ${ARGN})
  if(NOT LIMITGAUGE_UNITY)
    return()
  endif()
  set(folders)
  foreach(source ${U_SOURCES})
    get_filename_component(folder ${source} DIRECTORY)
    list(APPEND folders "in ${folder}")
  endforeach()
  list(REMOVE_DUPLICATES folders)
  list(LENGTH folders count)
  foreach(source ${U_SOURCES})
    cmake_path(IS_ABSOLUTE source absolute)
    get_filename_component(folder ${source} DIRECTORY)
    if(NOT absolute AND NOT folder IN_LIST U_APART)
      string(MAKE_C_IDENTIFIER "in_${folder}" group)
      if(U_GROUPS)
        list(FIND folders "in ${folder}" place)
        math(EXPR number "${place} * ${U_GROUPS} / ${count}")
        set(group "part_${number}")
      endif()
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}")
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# limitgauge_library(NAME [LIGHT] FOLDERS dir... SOURCES file... PUBLIC target... PRIVATE lib...
#   [GROUPS count] [APART folder...])
#
# LIGHT libraries compute next to nothing by themselves: with sanitizers they are compiled for a quick build,
# in half the time.
# A library of one house. Its headers are reached through a view of the source tree that holds
# this library's folders (or single headers) and nothing else, so an include against the arrows does not compile.
function(limitgauge_library name)
  cmake_parse_arguments(LIB "LIGHT" "GROUPS" "FOLDERS;SOURCES;PUBLIC;PRIVATE;APART" ${ARGN})
  add_library(limitgauge_${name} STATIC ${LIB_SOURCES})
  if(LIB_LIGHT AND LIMITGAUGE_SANITIZE)
    target_compile_options(limitgauge_${name} PRIVATE -O0)
  endif()
  add_library(limitgauge::${name} ALIAS limitgauge_${name})
  set(view ${CMAKE_BINARY_DIR}/include/${name})
  foreach(folder ${LIB_FOLDERS})
    get_filename_component(parent ${view}/${folder} DIRECTORY)
    file(MAKE_DIRECTORY ${parent})
    file(CREATE_LINK ${LIMITGAUGE_ROOT}/${folder} ${view}/${folder} SYMBOLIC)
  endforeach()
  # Installed headers name each other as those of the source tree do, whose root is include/limitgauge.
  target_include_directories(limitgauge_${name} PUBLIC $<BUILD_INTERFACE:${view}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/limitgauge>)
  # What headers define inline is compiled by others as well, and must give the same bytes there.
  target_compile_options(limitgauge_${name} INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
  target_compile_features(limitgauge_${name} INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
  target_link_libraries(limitgauge_${name}
    PUBLIC ${LIB_PUBLIC} PRIVATE limitgauge_options ${LIB_PRIVATE})
  set_target_properties(limitgauge_${name} PROPERTIES LIMITGAUGE_FOLDERS "${LIB_FOLDERS}")
  cmake_language(EVAL CODE "cmake_language(DEFER CALL limitgauge_seal limitgauge_${name})")
  limitgauge_unity(limitgauge_${name} SOURCES ${LIB_SOURCES} GROUPS ${LIB_GROUPS} APART ${LIB_APART})
endfunction()
