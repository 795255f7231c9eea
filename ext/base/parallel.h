// Runs one piece of work on several threads; none of them may call SQLite.
//
//   run_together(helpers, interrupt, [&](std::size_t part, std::size_t parts, Interrupt& interrupt) {
//     for (i = part * count / parts; i < (part + 1) * count / parts; ++i) { …; interrupt.check(); }
//   });
//
// The calling thread does part 0 and polls `interrupt`. An exception in any part stops the helper threads;
// the first exception is rethrown here after all threads have ended. If the system has no more threads, the
// caller does the remaining parts too. Cost: some 20 microseconds per helper.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

#include "base/error.h"

namespace foresee {

/// The interrupt that a helper thread polls in place of the connection's.
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

/// Without helpers the work is one part, on the calling thread.
void run_together(std::size_t helpers, Interrupt& interrupt, const PartOfWork& work);

}  // namespace foresee
