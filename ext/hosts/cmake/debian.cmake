# Two Debian packages: `cpack -G DEB` in the build folder, which ext/hosts/pack.sh runs.
#
#   libsqlite3-mod-foresee   the module where `.load foresee` finds it from any folder, and the man page
#   libforesee-dev           archives, headers, what CMake and pkg-config ask for
set(FORESEE_CONTACT "the foresee authors <foresee@localhost>" CACHE STRING "Who answers for a package, as \"name <address>\"")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL module dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_CONTACT ${FORESEE_CONTACT})
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
# Folders are readable by all, whatever the umask of who packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_MODULE_PACKAGE_NAME libsqlite3-mod-foresee)
set(CPACK_DEBIAN_MODULE_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_MODULE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_MODULE_PACKAGE_RECOMMENDS sqlite3)
set(CPACK_DEBIAN_MODULE_DESCRIPTION "SQLite extension: when will moving objects meet?
foresee stores moving objects in a virtual table of SQLite and answers in
SQL what will happen: which pairs will touch within a horizon, when, and how
near the others come; what will enter a window; what will come nearest to a
point.
.
Once it is installed, the shell's command .load foresee loads it.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libforesee-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libsqlite3-mod-foresee (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libsqlite3-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "predictive spatial joins: archives and headers
For programs that link SQLite themselves (libforesee.a, foresee.h) and for
those that have no SQLite (libforesee_core.a, C++20).
.
CMake's find_package(foresee) and pkg-config find both.")

# What Debian wants of every package: its history, its licence, and man pages compressed, without a time in them.
find_program(GZIP_PROGRAM gzip)
foreach(part module dev)
  string(TOUPPER ${part} PART)
  set(documents ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${PART}_PACKAGE_NAME})
  install(CODE "set(source \"${CMAKE_CURRENT_SOURCE_DIR}\")
    set(made \"${made}\")
    set(contact \"${FORESEE_CONTACT}\")
    set(gzip \"${GZIP_PROGRAM}\")
    set(documents \"${documents}\")
    set(man \"${CMAKE_INSTALL_MANDIR}/man3/foresee.3\")
    set(release \"${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}\")" COMPONENT ${part})
  install(SCRIPT ${hosts}/cmake/debian_documents.cmake COMPONENT ${part})
endforeach()
include(CPack)
