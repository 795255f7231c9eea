// Out-of-memory tests of watches: every allocation of SQLite and foresee in every step of a watch's life
// fails in turn, once or for good. The step fails with SQLITE_NOMEM and changes nothing, or does its work;
// repeated, it does its work.
#include "sqlite/faults/fault_steps.h"
#include "sqlite/faults/memory_faults.h"
#include "sqlite/watch/watch_steps.h"

namespace foresee::testing {
namespace {

struct WatchMemoryFaults : MemoryFaults, ::testing::WithParamInterface<WatchStep> {
  static constexpr int objects = 16;

  /// False if no allocation failed.
  bool take_step(const std::string& after, long n, bool for_good) {
    Database db;
    db.exec(objects_to_watch(objects) + GetParam().before);
    const std::string before = all_of_watch(db);
    faults = {.armed = true, .for_good = for_good, .left = n, .fired = false};
    const int rc = sqlite3_exec(db.handle(), GetParam().sql.c_str(), nullptr, nullptr, nullptr);
    const bool fired = faults.fired;
    faults = {};
    EXPECT_TRUE(rc == SQLITE_OK || (fired && rc == SQLITE_NOMEM)) << rc << " at allocation " << n;
    if (sqlite3_get_autocommit(db.handle()) == 0) db.exec("ROLLBACK");
    if (rc != SQLITE_OK) {
      EXPECT_EQ(all_of_watch(db), before) << "at allocation " << n;
      db.exec(GetParam().sql);
    }
    EXPECT_EQ(all_of_watch(db), after) << "at allocation " << n;
    expect_watches_are_sound(db);
    return fired;
  }
};

TEST_P(WatchMemoryFaults, LeaveTheStepUndoneOrDone) {
  std::string after;
  {
    Database db;
    db.exec(objects_to_watch(objects) + GetParam().before + GetParam().sql);
    after = all_of_watch(db);
  }
  long n = 0;
  while (take_step(after, n, n % 2 == 1) && !HasFailure()) {
    if (every_fault) take_step(after, n, n % 2 == 0);
    n = next_fault_of_many(n);
  }
  EXPECT_GT(n, 2) << "no allocation failed";
}

INSTANTIATE_TEST_SUITE_P(Steps, WatchMemoryFaults, ::testing::ValuesIn(watch_steps),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace foresee::testing
