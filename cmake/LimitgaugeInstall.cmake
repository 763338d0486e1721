# What `cmake --install` brings to a system: the program, its manual page and completions, which the
# program writes itself from the options that it parses, the schema of its results, and the
# documents, laid out as in the source tree so that their links hold.
include(GNUInstallDirs)

set(texts)
foreach(text IN ITEMS
    man:man/man1/limitgauge.1
    bash:bash-completion/completions/limitgauge
    zsh:zsh/site-functions/_limitgauge
    fish:fish/vendor_completions.d/limitgauge.fish)
  string(REPLACE ":" ";" text ${text})
  list(GET text 0 kind)
  list(GET text 1 path)
  set(file ${CMAKE_BINARY_DIR}/share/${path})
  get_filename_component(folder ${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(OUTPUT ${file}
    COMMAND limitgauge --generate ${kind} > ${file}
    DEPENDS limitgauge VERBATIM)
  list(APPEND texts ${file})
  get_filename_component(subfolder ${path} DIRECTORY)
  if(kind STREQUAL man)
    install(FILES ${file} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  else()
    install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${subfolder})
  endif()
endforeach()
add_custom_target(limitgauge_texts ALL DEPENDS ${texts})

install(TARGETS limitgauge RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${CMAKE_SOURCE_DIR}/reports/result.schema.json
    ${CMAKE_SOURCE_DIR}/reports/study/study.schema.json
  DESTINATION ${CMAKE_INSTALL_DATADIR}/limitgauge)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.jpg" PATTERN "*.svg")
install(FILES verifier/CERTIFICATE.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/verifier)
