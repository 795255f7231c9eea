// A child process that writes transactions until it is killed with kill -9.
//
//   const std::int64_t last = write_and_kill(seed, [&](Announce announce) {
//     …open the file…
//     for (std::int64_t number = 1;; ++number) { …BEGIN … COMMIT…; announce(number); }
//   });                                       // `last` was announced before the end
#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {

/// Reports to the parent process that the COMMIT of this transaction has returned.
class Announce {
 public:
  explicit Announce(int end) : end_(end) {}

  void operator()(std::int64_t number) const {
    if (write(end_, &number, sizeof number) != sizeof number) _exit(1);
  }

 private:
  int end_;
};

/// Runs a writer for some transactions and milliseconds, kills it, and returns the last announced number.
template <class Write>
std::int64_t write_and_kill(std::uint64_t seed, const Write& write_until_killed) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  const pid_t writer = fork();
  if (writer == 0) {
    close(ends[0]);
    write_until_killed(Announce(ends[1]));
    _exit(1);
  }
  close(ends[1]);
  std::int64_t last = 0;
  Random random(seed);
  const auto some = 1 + random.below(6);  // transactions, and then some time into the next one
  for (std::uint64_t i = 0; i < some && read(ends[0], &last, sizeof last) == sizeof last; ++i) {
  }
  usleep(static_cast<useconds_t>(random.below(20'000)));
  kill(writer, SIGKILL);
  while (read(ends[0], &last, sizeof last) == sizeof last) {
  }
  close(ends[0]);
  int status = 0;
  EXPECT_EQ(waitpid(writer, &status, 0), writer);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the writer ended before the kill";
  return last;
}

}  // namespace foresee::testing
