# Builds for another machine by zig, which brings Clang, libc++ and the C libraries of its targets:
#
#   bash ext/hosts/release/fetch_roots.sh zig include
#   cmake --preset linux-arm64-gnu && cmake --build --preset linux-arm64-gnu
include(${CMAKE_CURRENT_LIST_DIR}/targets.cmake)

set(CMAKE_C_COMPILER ${foresee_roots}/zig/bin/cc)
set(CMAKE_CXX_COMPILER ${foresee_roots}/zig/bin/c++)
set(CMAKE_AR ${foresee_roots}/zig/bin/ar CACHE FILEPATH "")
set(CMAKE_RANLIB ${foresee_roots}/zig/bin/ranlib CACHE FILEPATH "")

# Boost 1.74 uses std::unary_function, which libc++ leaves out. Without debug information and symbols the module is linked
# once and never changed: a signature that the linker writes for macOS stays right.
set(flags "-target ${target_triple} -g0 ${foresee_path_flags}")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags} -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-s")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "-s")
if(target_npm_libc STREQUAL glibc)
  set(FORESEE_MODULE_SOURCES ${foresee_source}/ext/hosts/release/finalize.c)
endif()
