#include "memory_faults.h"

#include <cstdlib>
#include <new>

namespace foresee::testing {

Faults faults;
std::size_t bytes_asked = 0;

namespace {

sqlite3_mem_methods ordinary;

void* faulty_malloc(int size) {
  return faults.fails() ? nullptr : ordinary.xMalloc(size);
}
void* faulty_realloc(void* memory, int size) {
  return faults.fails() ? nullptr : ordinary.xRealloc(memory, size);
}

}  // namespace

MemoryFaults::MemoryFaults() {
  sqlite3_shutdown();
  sqlite3_config(SQLITE_CONFIG_GETMALLOC, &ordinary);
  sqlite3_mem_methods faulty = ordinary;
  faulty.xMalloc = faulty_malloc;
  faulty.xRealloc = faulty_realloc;
  sqlite3_config(SQLITE_CONFIG_MALLOC, &faulty);
  sqlite3_initialize();
}

MemoryFaults::~MemoryFaults() {
  sqlite3_shutdown();
  sqlite3_config(SQLITE_CONFIG_MALLOC, &ordinary);
  sqlite3_initialize();
}

}  // namespace foresee::testing

// GCC takes free() of what our own operator new has given for a mismatch.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wunknown-warning-option"
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) {
  foresee::testing::bytes_asked += size;
  if (!foresee::testing::faults.fails())
    if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return foresee::testing::faults.fails() ? nullptr : std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
#pragma GCC diagnostic pop
