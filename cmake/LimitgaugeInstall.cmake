# What `cmake --install` brings to a system, as two components. Runtime: the program with its texts
# (LimitgaugeTexts), the schemas of its results, and the documents, laid out as in the source tree so
# that their links hold. Development: libraries, headers and the package for find_package
# (LimitgaugeExport). Building the program builds all of it.
install(TARGETS limitgauge RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${CMAKE_SOURCE_DIR}/reports/result.schema.json
    ${CMAKE_SOURCE_DIR}/reports/study/study.schema.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/limitgauge)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Of the libraries in the pages' scripts.
install(FILES ${CMAKE_BINARY_DIR}/web/third-party.txt DESTINATION ${CMAKE_INSTALL_DOCDIR}
  RENAME THIRD-PARTY.txt)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.jpg" PATTERN "*.svg")
install(FILES verifier/CERTIFICATE.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/verifier)

limitgauge_install_libraries(engine simulator verifier)
