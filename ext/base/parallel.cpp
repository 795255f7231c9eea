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

}  // namespace

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
