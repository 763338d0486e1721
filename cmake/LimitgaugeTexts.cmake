# limitgauge_texts(TARGET): what the program says of itself, written by the program whenever it is
# linked, from the options that it parses, and installed beside it: manual page and completions.
# Whoever builds the program alone has all that `cmake --install` needs.
function(limitgauge_texts program)
  set(share ${CMAKE_BINARY_DIR}/share)
  set(man ${share}/man/man1/limitgauge.1)
  set(bash ${share}/bash-completion/completions/limitgauge)
  set(zsh ${share}/zsh/site-functions/_limitgauge)
  set(fish ${share}/fish/vendor_completions.d/limitgauge.fish)
  set(commands)
  foreach(kind IN ITEMS man bash zsh fish)
    cmake_path(GET ${kind} PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    list(APPEND commands COMMAND ${program} --generate ${kind} > ${${kind}})
  endforeach()
  add_custom_command(TARGET ${program} POST_BUILD ${commands}
    BYPRODUCTS ${man} ${bash} ${zsh} ${fish} VERBATIM)

  install(FILES ${man} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  foreach(file IN ITEMS ${bash} ${zsh} ${fish})
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${share})
    install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
  endforeach()
endfunction()
