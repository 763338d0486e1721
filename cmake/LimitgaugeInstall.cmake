# What `cmake --install` brings to a system, as two components. Runtime: the program with its texts
# (LimitgaugeTexts), the schemas of its results, and the documents, laid out as in the source tree so
# that their links hold, but for those to sources. Development: libraries, headers and the package
# for find_package (LimitgaugeExport). Building the program builds all of it.
install(TARGETS limitgauge RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${CMAKE_SOURCE_DIR}/reports/result.schema.json
    ${CMAKE_SOURCE_DIR}/reports/study/study.schema.json
    ${CMAKE_SOURCE_DIR}/reports/probe/probe.schema.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/limitgauge)
# The pages, and what they name for trying out.
file(GLOB pages RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/*.md)
foreach(room IN ITEMS model engine simulator verifier witness study history reports app fixtures)
  file(GLOB_RECURSE more RELATIVE ${CMAKE_SOURCE_DIR} CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${room}/*.md)
  list(APPEND pages ${more})
endforeach()
foreach(file IN ITEMS ${pages} LICENSE reports/result.schema.json reports/study/study.schema.json
    reports/probe/probe.schema.json)
  cmake_path(GET file PARENT_PATH folder)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR}
  PATTERN "tables.py" EXCLUDE PATTERN "*.csv" EXCLUDE PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY fixtures/jobs fixtures/cages fixtures/findings fixtures/foreign fixtures/studies
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/fixtures PATTERN "bad" EXCLUDE)
# Of the libraries in the pages' scripts.
install(FILES ${CMAKE_BINARY_DIR}/web/third-party.txt DESTINATION ${CMAKE_INSTALL_DOCDIR}
  RENAME THIRD-PARTY.txt)

limitgauge_install_libraries(engine simulator verifier)
