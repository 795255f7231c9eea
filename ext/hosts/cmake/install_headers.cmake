# Installs the headers that users of the core include, and all that these include. Run by `cmake --install`.
#
# Requires: `ext`, the folder of the rooms; `headers_to`, where they go, beneath the prefix.
cmake_policy(VERSION 3.21)
set(wanted
  query/join/join.h query/join/explain.h query/window/window.h query/nearest/nearest.h query/position/positions.h
  query/position/tracks.h query/sweep/sweep.h query/avoid/avoid.h query/memory_table.h query/watch/pair_update.h
  query/watch/pair_contacts.h query/watch/memory_watch.h base/float_environment.h index/memory_pages.h
  index/tpr_tree/tpr_tree.h shape/outline/wkt.h shape/mesh/mesh_text.h)
set(found)
while(wanted)
  list(POP_FRONT wanted header)
  if(header IN_LIST found)
    continue()
  endif()
  list(APPEND found ${header})
  file(STRINGS ${ext}/${header} lines REGEX "^#include \"")
  foreach(line ${lines})
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" header "${line}")
    list(APPEND wanted ${header})
  endforeach()
endwhile()

foreach(header ${found})
  get_filename_component(folder ${header} DIRECTORY)
  file(INSTALL ${ext}/${header} DESTINATION "${CMAKE_INSTALL_PREFIX}/${headers_to}/${folder}")
endforeach()
