# Builds the DLL for Windows by Debian's MinGW-w64, in its variant with POSIX threads, which std::jthread needs:
#
#   bash ext/hosts/release/fetch_roots.sh include
#   cmake --preset win32-x64 && cmake --build --preset win32-x64
include(${CMAKE_CURRENT_LIST_DIR}/targets.cmake)

set(CMAKE_C_COMPILER ${target_triple}-gcc-posix)
set(CMAKE_CXX_COMPILER ${target_triple}-g++-posix)
set(CMAKE_C_FLAGS_INIT "${foresee_path_flags}")
set(CMAKE_CXX_FLAGS_INIT "${foresee_path_flags}")
# A file holds no time, so that the same sources give the same bytes.
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-s -Wl,--no-insert-timestamp")
