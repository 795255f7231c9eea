#include "base/parallel.h"

#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/float_environment.h"

namespace foresee {
namespace {

/// The first exception of several threads.
class Failure {
 public:
  void keep_current() noexcept {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
  void throw_if_any() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
};

constexpr std::chrono::milliseconds usual_pause{1};
constexpr std::int64_t long_pause = std::chrono::nanoseconds(10 * usual_pause).count();

std::int64_t steady_ticks() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void WakingInterrupt::check() {
  HelperInterrupt::check();
  const std::int64_t since = paused_since_.load(std::memory_order_relaxed);
  if (since != no_pause && steady_ticks() - since > long_pause) changed_.notify_all();
}

void WakingInterrupt::pause(std::unique_lock<std::mutex>& lock) {
  pause_until(lock, std::chrono::system_clock::now() + usual_pause);
}

void WakingInterrupt::pause_until(std::unique_lock<std::mutex>& lock,
                                  std::chrono::system_clock::time_point end) {
  paused_since_.store(steady_ticks(), std::memory_order_relaxed);
  changed_.wait_until(lock, end);
  paused_since_.store(no_pause, std::memory_order_relaxed);
}

void run_together(std::size_t helpers, Interrupt& interrupt, const PartOfWork& work) {
  if (helpers == 0) return work(0, 1, interrupt);
  const std::size_t parts = helpers + 1;
  HelperInterrupt stop;
  Failure failure;
  const auto guarded = [&](std::size_t part, Interrupt& polled) noexcept {
    try {
      const FloatEnvironment environment;
      work(part, parts, polled);
    } catch (...) {
      failure.keep_current();
      stop.stop();
    }
  };
  {
    std::vector<std::jthread> threads;
    threads.reserve(helpers);
    std::size_t started = 1;
    try {
      for (; started < parts; ++started) threads.emplace_back(guarded, started, std::ref(stop));
    } catch (const std::system_error&) {
      // The system has no more threads: this thread does the remaining parts.
    }
    guarded(0, interrupt);
    for (; started < parts; ++started) guarded(started, interrupt);
  }
  failure.throw_if_any();
}

}  // namespace foresee
