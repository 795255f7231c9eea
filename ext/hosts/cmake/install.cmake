# What `cmake --install` brings to a machine: the module, two archives, headers, and what CMake and pkg-config ask for.
#
#   LIBDIR/foresee.so                       the module: `.load`
#   LIBDIR/libforesee.a, include/foresee.h  for programs that carry their own SQLite
#   LIBDIR/libforesee_core.a, include/foresee/   the join without SQLite
#   LIBDIR/cmake/foresee/, LIBDIR/pkgconfig/, MANDIR/man3/foresee.3
#   DATADIR/foresee/rust/, DATADIR/foresee/go/   packages in source form over libforesee.a
#
# Nothing that is installed names the prefix: a folder that was moved works where it is. A build with sanitizers has no
# module and installs nothing.
if(NOT TARGET foresee)
  return()
endif()
include(CMakePackageConfigHelpers)

# Debian's place for libraries, whatever the prefix: `.load foresee` is found there beneath /usr, and one build folder
# serves every prefix.
if(CMAKE_LIBRARY_ARCHITECTURE AND EXISTS /etc/debian_version)
  set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Libraries beneath the prefix")
endif()
include(GNUInstallDirs)
set(package_files ${CMAKE_INSTALL_LIBDIR}/cmake/foresee)
set(hosts ${CMAKE_CURRENT_SOURCE_DIR}/ext/hosts)
set(made ${CMAKE_CURRENT_BINARY_DIR}/hosts)

# One export a component: who wants the module is not asked for a thread library.
function(install_component name target)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT foresee_${name}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${ARGN}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${ARGN})
  install(EXPORT foresee_${name} NAMESPACE foresee:: FILE foresee-${name}.cmake DESTINATION ${package_files} COMPONENT dev)
endfunction()
install_component(module foresee module)
install_component(static foresee_archive dev)
install_component(core foresee_core dev)

configure_package_config_file(${hosts}/cmake/foreseeConfig.cmake.in ${made}/foreseeConfig.cmake
  INSTALL_DESTINATION ${package_files} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${made}/foreseeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${made}/foreseeConfig.cmake ${made}/foreseeConfigVersion.cmake DESTINATION ${package_files} COMPONENT dev)

# pkg-config: the prefix follows from where the file lies.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" prefix_from_pc ${prefix_from_pc})
foreach(name foresee foresee-core)
  configure_file(${hosts}/cmake/${name}.pc.in ${made}/${name}.pc @ONLY)
  install(FILES ${made}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endforeach()

configure_file(${hosts}/man/foresee.3.in ${made}/foresee.3 @ONLY)
install(FILES ${made}/foresee.3 DESTINATION ${CMAKE_INSTALL_MANDIR}/man3 COMPONENT module)
install(FILES ext/sqlite/foresee.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(DIRECTORY ${hosts}/rust ${hosts}/go DESTINATION ${CMAKE_INSTALL_DATADIR}/foresee COMPONENT dev
  PATTERN target EXCLUDE PATTERN Cargo.lock EXCLUDE)

# The core's headers are found when they are installed: no list to keep.
install(CODE "set(ext \"${CMAKE_CURRENT_SOURCE_DIR}/ext\")
  set(headers_to \"${CMAKE_INSTALL_INCLUDEDIR}/foresee\")" COMPONENT dev)
install(SCRIPT ${hosts}/cmake/install_headers.cmake COMPONENT dev)

install(CODE "set(libdir \"${CMAKE_INSTALL_LIBDIR}\")" COMPONENT module)
install(SCRIPT ${hosts}/cmake/say_how_to_load.cmake COMPONENT module)
include(${hosts}/cmake/debian.cmake)
