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
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

#include "base/error.h"

namespace foresee {

/// The interrupt that a helper thread polls in place of the connection's.
class HelperInterrupt : public Interrupt {
 public:
  void check() override {
    if (stopped()) throw Interrupted();
  }
  void stop() { stop_.store(true, std::memory_order_relaxed); }
  bool stopped() const { return stop_.load(std::memory_order_relaxed); }

 private:
  std::atomic<bool> stop_ = false;
};

/// The interrupt of helpers whose reader pauses about a millisecond at a time, between two checks of its own.
///
/// The pause ends by the system clock: a wait by the steady clock needs glibc 2.30. If that clock is set back
/// meanwhile, the next check of a helper ends the pause.
class WakingInterrupt final : public HelperInterrupt {
 public:
  explicit WakingInterrupt(std::condition_variable& changed) : changed_(changed) {}

  void check() override;
  /// Waits until `changed` is notified, a millisecond has passed, or a helper finds that it has.
  void pause(std::unique_lock<std::mutex>& lock);
  /// The same, until a given time of the system clock.
  void pause_until(std::unique_lock<std::mutex>& lock, std::chrono::system_clock::time_point end);

 private:
  static constexpr std::int64_t no_pause = 0;

  std::condition_variable& changed_;
  std::atomic<std::int64_t> paused_since_ = no_pause;  // ticks of the steady clock
};

using PartOfWork = std::function<void(std::size_t part, std::size_t parts, Interrupt& interrupt)>;

/// Without helpers the work is one part, on the calling thread.
void run_together(std::size_t helpers, Interrupt& interrupt, const PartOfWork& work);

}  // namespace foresee
