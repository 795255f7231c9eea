// Plans in a store under random changes, savepoints and rollbacks: read back bit for bit, in every way of reading.
#include "storage/plan_cases.h"

namespace foresee {
namespace {

TEST(StorePlans, ReadBackAfterCommitAndReopening) {
  Database db;
  auto store = make_store(db, fleet());
  testing::Random random(1);
  Robots robots;
  begin(db, *store);
  for (std::int64_t id = 1; id <= 100; ++id) {
    Robot& robot = robots[id];
    robot.record = robot_record(static_cast<double>(id));
    if (id % 4 != 0) robot.plan = random_stored_plan(random);
    store->insert(id, robot.record, {}, {}, robot.plan ? &*robot.plan : nullptr);
  }
  expect_robots(*store, robots, "before the commit");
  commit(db, *store);
  expect_robots(*store, robots, "after it");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  store = nullptr;
  db.run("VACUUM");
  store = Store::open(db, "main", "ships", fleet());
  expect_robots(*store, robots, "opened again");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

/// A store with what it should hold, under random changes.
class RandomLives {
 public:
  explicit RandomLives(std::uint64_t seed) : random_(seed), store_(make_store(db_, fleet())) {}

  void run(int steps) {
    begin_all();
    for (int step = 0; step < steps && !::testing::Test::HasFailure(); ++step) {
      change();
      if (random_.below(8) == 0) transact(step);
      if (random_.below(16) == 0) expect_robots(*store_, now_, "step " + std::to_string(step));
    }
    commit(db_, *store_);
    expect_robots(*store_, now_, "at the end");
    EXPECT_EQ(faults(*store_), std::vector<std::string>{});
  }
  std::size_t robots() const { return now_.size(); }

 private:
  void begin_all() {
    begin(db_, *store_);
    before_ = now_;
    marks_.clear();
  }

  void transact(int step) {
    switch (random_.below(6)) {
      case 0:
        commit(db_, *store_);
        expect_robots(*store_, now_, "committed at step " + std::to_string(step));
        EXPECT_EQ(faults(*store_), std::vector<std::string>{});
        return begin_all();
      case 1:
        roll_back(db_, *store_);
        now_ = before_;
        return begin_all();
      case 2:
        return store_->sync();
      case 3:
        if (marks_.empty()) break;
        now_ = marks_.back();
        return roll_back_to(db_, *store_, static_cast<int>(marks_.size()) - 1);
      default:
        break;
    }
    open_savepoint(db_, *store_, static_cast<int>(marks_.size()));
    marks_.push_back(now_);
  }

  std::int64_t any_id() { return 1 + static_cast<std::int64_t>(random_.below(40)); }

  void change() {
    const std::int64_t id = any_id();
    const auto found = now_.find(id);
    if (found == now_.end()) return insert(id);
    Robot robot = found->second;
    std::vector<double> record = stored_record(*store_, id);
    ASSERT_FALSE(record.empty());
    std::int64_t new_id = id;
    const Plan* plan = nullptr;
    switch (random_.below(7)) {
      case 0:
        store_->erase(id);
        now_.erase(id);
        return;
      case 1:
        record[static_cast<std::size_t>(fleet_at.r)] = random_.in(0, 5);
        break;
      case 2:
        until_of(record) = random_.below(2) ? no_end : record[0] + random_.in(0, 300);
        break;
      case 3:
        new_id = any_id();
        break;
      case 4:
        record[static_cast<std::size_t>(fleet_at.plan)] = record[static_cast<std::size_t>(fleet_at.chunks)] =
            0;
        robot.plan.reset();
        break;
      default:
        robot.plan = random_stored_plan(random_);
        until_of(record) = no_end;
        plan = &*robot.plan;
    }
    store_->update(id, new_id, record, {}, plan);
    robot.record = stored_record(*store_, new_id);
    now_.erase(id);
    now_[new_id] = std::move(robot);
  }

  void insert(std::int64_t id) {
    Robot robot{robot_record(random_.in(-9, 9), random_.in(0, 5))};
    if (random_.below(3) != 0) robot.plan = random_stored_plan(random_);
    store_->insert(id, robot.record, {}, {}, robot.plan ? &*robot.plan : nullptr);
    now_[id] = std::move(robot);
  }

  Database db_;
  testing::Random random_;
  std::shared_ptr<Store> store_;
  Robots now_, before_;
  std::vector<Robots> marks_;
};

TEST(StorePlans, RandomLivesAgreeWithAModel) {
  std::size_t robots = 0;
  for (std::uint64_t seed = 1; seed <= 20 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomLives lives(seed);
    lives.run(200);
    robots += lives.robots();
  }
  EXPECT_GT(robots, 200u);
}

}  // namespace
}  // namespace foresee
