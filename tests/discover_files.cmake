# cmake -DEXECUTABLE=... -DSPEC=... -DNAME=... -DLABEL=... -DLONG=... -DOUT=... -P discover_files.cmake
#
# Writes to OUT, for CTest to include, a test of each source file of a Catch2 executable that has cases of SPEC:
# "NAME: LABEL tests of FILE"; those of LONG files are to begin before others. Run when the executable is linked,
# so that no list of them can be out of date.
cmake_policy(VERSION 3.25)
execute_process(COMMAND ${EXECUTABLE} --filenames-as-tags --list-tests "${SPEC}" OUTPUT_VARIABLE cases)
string(REGEX MATCHALL "\\[#[^]]+\\]" files "${cases}")
if(NOT files)
  message(FATAL_ERROR "${EXECUTABLE} has no cases of ${SPEC}")
endif()
# No list of CMake's could hold brackets as they are.
string(REGEX REPLACE "[][#]" "" files "${files}")
list(REMOVE_DUPLICATES files)
list(SORT files)
set(text)
foreach(file ${files})
  set(name "[==[${NAME}: ${LABEL} tests of ${file}]==]")
  set(cost 0)
  if(file IN_LIST LONG)
    set(cost 10)
  endif()
  string(APPEND text "add_test(${name} [==[${EXECUTABLE}]==] --filenames-as-tags [==[[#${file}]${SPEC}]==])\n"
    "set_tests_properties(${name} PROPERTIES LABELS ${LABEL} TIMEOUT 1200 COST ${cost})\n")
endforeach()
file(WRITE ${OUT} "${text}")
