# Prints the command that loads the module from where `cmake --install` has put it. Requires: `libdir`.
#
# Beneath /usr the dynamic linker looks by itself; elsewhere it wants the path. Packages are made without a word.
if(NOT DEFINED ENV{DESTDIR} AND NOT CMAKE_INSTALL_PREFIX MATCHES "/_CPack_Packages/")
  set(module "${CMAKE_INSTALL_PREFIX}/${libdir}/foresee")
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set(module foresee)
  endif()
  message(STATUS "In the sqlite3 shell: .load ${module}")
endif()
