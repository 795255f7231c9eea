// How long does a command compute without looking for an interrupt? In processor time of its own thread, so
// that a busy machine does not matter.
#include <ctime>

#include "storage/database.h"

namespace foresee {
namespace {

class LongestPause final : public Interrupt {
 public:
  void check() override {
    const double now = milliseconds();
    longest_ = std::max(longest_, now - last_);
    last_ = milliseconds();
  }
  /// Up to now, the end of what was run.
  double longest() {
    check();
    return longest_;
  }

 private:
  static double milliseconds() {
    std::timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  double last_ = milliseconds(), longest_ = 0;
};

TEST(LongCommands, LookForAnInterruptWhileTheySort) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  constexpr std::int64_t objects = 200'000, scattered = 7919 * 3, prime = 1'000'003;
  for (std::int64_t i = 1; i <= objects; ++i)
    store->insert(i * scattered % prime, ship(static_cast<double>(i)), {});
  commit(db, *store);
  constexpr double most = 20;  // a check that sorts without a look takes 40, one that looks 5 at most
  LongestPause checked;
  EXPECT_EQ(store->check(checked), std::vector<std::string>{});
  EXPECT_LT(checked.longest(), most);
  begin(db, *store);
  LongestPause packed;
  store->rebuild(packed);
  EXPECT_LT(packed.longest(), most);
  commit(db, *store);
}

}  // namespace
}  // namespace foresee
