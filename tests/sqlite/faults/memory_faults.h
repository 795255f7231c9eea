// Injects allocation failures into SQLite and foresee: one allocation fails, or all from one on.
//
//   struct MyFaults : MemoryFaults {};       // SQLite allocates through the counter while a fixture lives
//   faults = {.armed = true, .for_good = true, .left = 7, .fired = false};
//   sqlite3_exec(…);
//   const bool fired = faults.fired;
//   faults = {};
#pragma once

#include <cstddef>

#include "sqlite/database.h"

namespace foresee::testing {

/// Counts down the allocations of the statement under test; at 0 they fail.
struct Faults {
  bool armed = false;
  bool for_good = false;
  long left = 0;
  bool fired = false;

  bool fails() {
    if (!armed || left-- > 0) return false;
    fired = true;
    if (!for_good) armed = false;
    return true;
  }
};

extern Faults faults;
extern std::size_t bytes_requested;         ///< by foresee's own code, in total, failures too
extern std::size_t bytes_held, bytes_peak;  ///< not yet freed; the peak, which a test resets

/// A fixture during which no database outlives a test.
struct MemoryFaults : ::testing::Test {
  MemoryFaults();
  ~MemoryFaults() override;
};

}  // namespace foresee::testing
