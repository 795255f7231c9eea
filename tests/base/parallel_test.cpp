#include "base/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace foresee {
namespace {

using std::chrono::steady_clock;
using std::chrono::system_clock;
using namespace std::chrono_literals;

class Pause : public ::testing::Test {
 protected:
  std::condition_variable changed_;
  std::mutex mutex_;
  WakingInterrupt interrupt_{changed_};
};

TEST_F(Pause, EndsByItself) {
  const auto start = steady_clock::now();
  std::unique_lock lock(mutex_);
  interrupt_.pause(lock);
  EXPECT_TRUE(lock.owns_lock());
  EXPECT_LT(steady_clock::now() - start, 10s);
}

// An end in an hour is what a pause has left if the system clock is set back by an hour.
TEST_F(Pause, IsEndedByTheNextCheckOfAHelperIfItBecomesLong) {
  const auto start = steady_clock::now();
  std::jthread helper([this](std::stop_token ended) {
    while (!ended.stop_requested()) interrupt_.check();
  });
  std::unique_lock lock(mutex_);
  interrupt_.pause_until(lock, system_clock::now() + 1h);
  EXPECT_LT(steady_clock::now() - start, 60s);
}

TEST_F(Pause, IsEndedByANotification) {
  const auto start = steady_clock::now();
  std::jthread helper([this](std::stop_token ended) {
    while (!ended.stop_requested()) changed_.notify_all();
  });
  std::unique_lock lock(mutex_);
  interrupt_.pause_until(lock, system_clock::now() + 1h);
  EXPECT_LT(steady_clock::now() - start, 60s);
}

TEST_F(Pause, LeavesTheInterruptAnInterrupt) {
  interrupt_.check();
  interrupt_.stop();
  EXPECT_TRUE(interrupt_.stopped());
  EXPECT_THROW(interrupt_.check(), Interrupted);
}

}  // namespace
}  // namespace foresee
