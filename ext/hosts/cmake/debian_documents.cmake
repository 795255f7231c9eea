# While a Debian package is made: changelog, copyright, and the man page compressed. Elsewhere it does nothing.
#
# Requires: source, made, contact, documents, man, release, gzip (debian.cmake sets them).
if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr" OR NOT "$ENV{DESTDIR}" MATCHES "/_CPack_Packages/")
  return()
endif()

# Debian's form of a changelog, of the version's date: that of the last commit.
execute_process(COMMAND git -C ${source} log -1 --format=%cD OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT date)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
endif()
file(WRITE ${made}/changelog "foresee (${release}) unstable; urgency=medium

  * See /usr/share/doc/libsqlite3-mod-foresee/changelog.gz.

 -- ${contact}  ${date}
")
set(to "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
file(MAKE_DIRECTORY ${to}/${documents})
foreach(compressed IN ITEMS "${source}/CHANGELOG.md changelog.gz" "${made}/changelog changelog.Debian.gz")
  separate_arguments(compressed)
  list(GET compressed 0 from)
  list(GET compressed 1 name)
  execute_process(COMMAND ${gzip} -9nc ${from} OUTPUT_FILE ${to}/${documents}/${name} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

file(READ ${source}/LICENSE licence)
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REGEX REPLACE "\n" "\n " licence " ${licence}")
string(REGEX REPLACE " +$" "" licence "${licence}")
file(WRITE ${to}/${documents}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: foresee

Files: *
Copyright: 2026 the foresee authors
License: MIT
${licence}")

if(EXISTS ${to}/${man})
  execute_process(COMMAND ${gzip} -9nf ${to}/${man} COMMAND_ERROR_IS_FATAL ANY)
endif()
