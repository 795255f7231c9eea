// What every room throws, and how a long computation is stopped from outside.
//
// Exceptions stay inside: the callbacks of ext/sqlite catch all of them at the C boundary.
#pragma once

#include <stdexcept>

namespace foresee {

/// A wrong question or wrong data; what() is shown to the person who asked, as it is.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Somebody asked for the computation to stop (sqlite3_interrupt).
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Asked every few thousand steps of any loop that may be long.
class Interrupt {
 public:
  virtual ~Interrupt() = default;
  /// Throws Interrupted if the computation is to stop. Costs well below a microsecond.
  virtual void check() = 0;
};

/// For callers that never stop early: tests, benchmarks, embedders.
class NeverInterrupt final : public Interrupt {
 public:
  void check() override {}
};

}  // namespace foresee
