// The exceptions of all modules, and the interface by which a caller interrupts a long computation.
//
// No exception crosses the C boundary: the callbacks of ext/sqlite catch all of them.
#pragma once

#include <stdexcept>

namespace foresee {

/// An invalid query or invalid data; the user reads what() unchanged.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The caller has cancelled the computation (sqlite3_interrupt).
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Every loop that may be long polls this every few thousand steps.
class Interrupt {
 public:
  virtual ~Interrupt() = default;
  /// Throws Interrupted if the computation must stop. Costs well below a microsecond.
  virtual void check() = 0;
};

/// For callers that never stop early: tests, benchmarks, embedders.
class NeverInterrupt final : public Interrupt {
 public:
  void check() override {}
};

}  // namespace foresee
