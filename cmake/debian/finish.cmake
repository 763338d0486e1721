# Run by CPack between installing into its own folder and making the packages of it: what Debian
# wants otherwise than `cmake --install` does for any system.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()

# Reproducible: the time that SOURCE_DATE_EPOCH states, or that of now.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)

function(compress file)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Every package says whose it is and what changed.
function(describe root package)
  set(doc ${root}/usr/share/doc/${package})
  configure_file(${CPACK_LIMITGAUGE_DEBIAN}/copyright ${doc}/copyright COPYONLY)
  file(WRITE ${doc}/changelog.Debian
    "limitgauge (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Built from the source tree; its CHANGELOG.md says what changed.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
  compress(${doc}/changelog.Debian)
  file(CHMOD ${doc}/changelog.Debian.gz ${doc}/copyright
    PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endfunction()

set(program ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/Runtime)
if(EXISTS ${program})
  describe(${program} limitgauge)
  compress(${program}/usr/share/man/man1/limitgauge.1)
  # The copyright says it.
  file(REMOVE ${program}/usr/share/doc/limitgauge/LICENSE)
  # Where Debian's zsh looks.
  file(MAKE_DIRECTORY ${program}/usr/share/zsh/vendor-completions)
  file(RENAME ${program}/usr/share/zsh/site-functions/_limitgauge
    ${program}/usr/share/zsh/vendor-completions/_limitgauge)
  file(REMOVE_RECURSE ${program}/usr/share/zsh/site-functions)
endif()
if(EXISTS ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/Development)
  describe(${CPACK_TEMPORARY_INSTALL_DIRECTORY}/Development liblimitgauge-dev)
endif()
