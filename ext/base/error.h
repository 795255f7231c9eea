// The exceptions of all modules, the interface by which a caller interrupts a long computation, and the compiler
// options that foresee refuses.
//
//   struct Rows {
//     int next() {
//       return unbroken.run("the query", [&] { return ++row; });    // after one call that threw, each throws
//     }
//     UnbrokenCalls unbroken;
//     int row = 0;
//   };
//
// Every header of the core includes this one. No exception crosses the C boundary: the callbacks of ext/sqlite catch
// all of them.
#pragma once

#include <stdexcept>
#include <string>

#ifdef __FAST_MATH__
#error "foresee needs IEEE arithmetic: build without -ffast-math (and -Ofast)"
#endif
#if defined(_GLIBCXX_DEBUG) && !defined(FORESEE_GLIBCXX_DEBUG)
#error \
    "_GLIBCXX_DEBUG changes std::vector: leave it out, or build foresee too with it and FORESEE_GLIBCXX_DEBUG"
#endif

namespace foresee {

/// An invalid query or invalid data; the user reads what() unchanged.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
  /// Whether stored bytes contradict each other. Only then may a caller go on without what it reads: after other errors
  /// of a file, SQLite has rolled back the transaction.
  virtual bool is_damage() const noexcept { return false; }
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

/// The calls of an object that gives its rows piece by piece. A call that throws may lose rows, so each later one
/// throws Error. Cost: a nanosecond.
class UnbrokenCalls {
 public:
  /// Returns call(). `name`: of the object, for the message.
  template <class Call>
  auto run(const char* name, Call&& call) {
    if (failed_)
      throw Error(std::string(name) + " failed before: its rows would be incomplete; start it again");
    failed_ = true;
    auto result = call();
    failed_ = false;
    return result;
  }

 private:
  bool failed_ = false;  ///< or a call runs
};

}  // namespace foresee
