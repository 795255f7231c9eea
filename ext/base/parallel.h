// Several threads at one piece of work, none of which may call SQLite.
//
//   run_together(helpers, interrupt, [&](std::size_t part, std::size_t parts, Interrupt& interrupt) {
//     for (i = part * count / parts; i < (part + 1) * count / parts; ++i) { …; interrupt.check(); }
//   });
//
// The calling thread takes part 0 and asks `interrupt`; the helpers are stopped when it throws, or when any
// of them does. The first exception is thrown again here, when all have ended. Where the system has no more
// threads the caller does their parts too. Cost: some 20 microseconds a helper.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

#include "base/error.h"

namespace foresee {

/// What a helper asks in place of the connection.
class HelperInterrupt final : public Interrupt {
 public:
  void check() override {
    if (stopped()) throw Interrupted();
  }
  void stop() { stop_.store(true, std::memory_order_relaxed); }
  bool stopped() const { return stop_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> stop_ = false;
};

using PartOfWork = std::function<void(std::size_t part, std::size_t parts, Interrupt& interrupt)>;

/// Without helpers: one part, on this thread.
void run_together(std::size_t helpers, Interrupt& interrupt, const PartOfWork& work);

}  // namespace foresee
