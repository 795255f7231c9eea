#include "memory_faults.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace foresee::testing {

Faults faults;
std::size_t bytes_requested = 0, bytes_held = 0, bytes_peak = 0;

namespace {

sqlite3_mem_methods ordinary;

void* faulty_malloc(int size) {
  return faults.fails() ? nullptr : ordinary.xMalloc(size);
}
void* faulty_realloc(void* memory, int size) {
  return faults.fails() ? nullptr : ordinary.xRealloc(memory, size);
}

void* counted(void* memory) {
  bytes_held += malloc_usable_size(memory);
  bytes_peak = std::max(bytes_peak, bytes_held);
  return memory;
}

}  // namespace

void* allocate(std::size_t size) {
  bytes_requested += size;
  return faults.fails() ? nullptr : counted(std::malloc(size == 0 ? 1 : size));
}

void release(void* memory) {
  bytes_held -= malloc_usable_size(memory);
  std::free(memory);
}

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

// GCC warns of a mismatch when free() releases memory of our own operator new.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpragmas"
#pragma GCC diagnostic ignored "-Wunknown-warning-option"
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) {
  if (void* memory = foresee::testing::allocate(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return foresee::testing::allocate(size);
}
void operator delete(void* memory) noexcept {
  foresee::testing::release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  foresee::testing::release(memory);
}
#pragma GCC diagnostic pop
