// Snapshot of the tree: it reads the same whatever happens to the table meanwhile.
#include <map>
#include <random>

#include "sanitized.h"
#include "storage/database.h"

namespace foresee {
namespace {

using Model = std::map<std::int64_t, double>;

/// Every id and x that the tree has.
Model walk(NodeSource& source) {
  Model all;
  const auto visit = [&](auto& self, NodeNumber number) -> void {
    const auto node = source.read(number);
    for (std::size_t slot = 0; slot < node->size(); ++slot) {
      if (node->is_leaf())
        all[node->keys[slot]] = node->values[slot * 6 + 1];
      else
        self(self, node->keys[slot]);
    }
  };
  if (source.find_root() != 0) visit(visit, source.find_root());
  return all;
}

Model now(Store& store) {
  const auto all = contents(store);
  return {all.begin(), all.end()};
}

class Snapshot : public ::testing::Test {
 protected:
  Snapshot() : store(make_store(db)) {
    begin(db, *store);
    for (int id = 1; id <= 1000; ++id) store->insert(id, ship(id), {});
    commit(db, *store);
  }
  void change_much() {
    for (int id = 1; id <= 1000; id += 3) store->erase(id);
    for (int id = 2; id <= 1000; id += 3) store->update(id, id, ship(-5 * id), {});
    for (int id = 2001; id <= 2500; ++id) store->insert(id, ship(id), {});
  }
  NeverInterrupt never;
  Database db;
  std::shared_ptr<Store> store;
};

TEST_F(Snapshot, SeesPendingObjectsAndOutlivesChangesAndCommit) {
  begin(db, *store);
  store->insert(5000, ship(7), {});
  const auto before = store->take_snapshot();
  const Model expected = now(*store);
  EXPECT_EQ(expected.size(), 1001u);
  EXPECT_EQ(walk(*before), expected);
  change_much();
  EXPECT_EQ(walk(*before), expected);
  commit(db, *store);
  EXPECT_EQ(walk(*before), expected);
  EXPECT_EQ(walk(*store->take_snapshot()), now(*store));
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  EXPECT_EQ(walk(*before), expected);
  begin(db, *store);
  for (const auto& [id, x] : now(*store)) store->erase(id);
  commit(db, *store);
  EXPECT_EQ(walk(*before), expected);
  EXPECT_EQ(walk(*store->take_snapshot()), Model{});
}

TEST_F(Snapshot, OutlivesARollback) {
  begin(db, *store);
  change_much();
  const auto inside = store->take_snapshot();
  const Model expected = now(*store);
  for (int id = 2001; id <= 2400; ++id) store->erase(id);
  roll_back(db, *store);
  EXPECT_EQ(walk(*inside), expected);
  EXPECT_EQ(now(*store).size(), 1000u);
  EXPECT_EQ(walk(*store->take_snapshot()), now(*store));
}

TEST_F(Snapshot, OutlivesARollbackToASavepoint) {
  begin(db, *store);
  change_much();
  open_savepoint(db, *store, 0);
  const Model outer = now(*store);
  store->erase(2001);
  const auto inside = store->take_snapshot();
  const Model expected = now(*store);
  for (int id = 2100; id < 2300; ++id) store->erase(id);
  store->sync();  // written, then rolled back by SQLite
  for (int id = 2300; id < 2400; ++id) store->erase(id);
  roll_back_to(db, *store, 0);
  EXPECT_EQ(walk(*inside), expected);
  EXPECT_EQ(now(*store), outer);
  EXPECT_EQ(walk(*store->take_snapshot()), outer);
  commit(db, *store);
  EXPECT_EQ(walk(*inside), expected);
  EXPECT_EQ(now(*store), outer);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Snapshot, NewestTIsReadOffTheRoot) {
  begin(db, *store);
  std::vector<double> late = ship(1);
  late[0] = 500;
  EXPECT_EQ(store->read_newest_t(), 100);
  store->insert(5000, late, {});
  EXPECT_EQ(store->read_newest_t(), 500);
  store->erase(5000);
  EXPECT_EQ(store->read_newest_t(), 100);
  store->update(3, 3, late, {});
  EXPECT_EQ(store->read_newest_t(), 500);
  commit(db, *store);
  EXPECT_EQ(store->read_newest_t(), 500);
  begin(db, *store);
  store->erase(3);
  EXPECT_EQ(store->read_newest_t(), 100);
  roll_back(db, *store);
  EXPECT_EQ(store->read_newest_t(), 500);
}

TEST_F(Snapshot, AgreesWithAModelThroughRandomProgramsOfSavepoints) {
  constexpr int rounds = testing::sanitized ? 15 : 40;
  std::mt19937_64 random(20241121);
  struct Held {
    std::shared_ptr<NodeSource> snapshot;
    Model expected;
  };
  for (int round = 0; round < rounds; ++round) {
    Model model = now(*store);
    const Model committed = model;
    std::vector<Model> savepoints;
    std::vector<Held> held;
    begin(db, *store);
    for (int step = 0; step < 300; ++step) {
      const auto id = static_cast<std::int64_t>(random() % 1500);
      const double x = static_cast<double>(random() % 1000);
      switch (random() % 16) {
        case 0:
          open_savepoint(db, *store, static_cast<int>(savepoints.size()));
          savepoints.push_back(model);
          break;
        case 1:
          if (savepoints.empty()) break;
          savepoints.resize(random() % savepoints.size() + 1);
          roll_back_to(db, *store, static_cast<int>(savepoints.size()) - 1);
          model = savepoints.back();
          break;
        case 2: {
          if (savepoints.empty()) break;
          const auto level = static_cast<int>(random() % savepoints.size());
          db.run("RELEASE s" + std::to_string(level));
          store->release(level);
          savepoints.resize(static_cast<std::size_t>(level));
          break;
        }
        case 3:
          held.push_back({store->take_snapshot(), model});
          break;
        case 4:
          if (!held.empty() && random() % 2) held.erase(held.begin());
          if (random() % 8 == 0) store->sync();  // as when the budget is exceeded
          break;
        case 5:
          if (random() % 20 == 0) store->rebuild(never);
          break;
        case 6:
          for (int more = 0; more < 40; ++more)
            if (!model.contains(3000 + more)) store->insert(3000 + more, ship(x), {}), model[3000 + more] = x;
          break;
        default:
          if (!model.contains(id)) {
            store->insert(id, ship(x), {});
          } else if (random() % 2) {
            store->update(id, id, ship(x), {});
          } else {
            store->erase(id);
            model.erase(id);
            break;
          }
          model[id] = x;
      }
    }
    ASSERT_EQ(now(*store), model) << round;
    if (random() % 3 == 0) {
      roll_back(db, *store);
      model = committed;
    } else {
      commit(db, *store);
    }
    for (Held& each : held) ASSERT_EQ(walk(*each.snapshot), each.expected) << round;
    ASSERT_EQ(now(*store), model) << round;
    ASSERT_EQ(faults(*store), std::vector<std::string>{}) << round;
  }
}

}  // namespace
}  // namespace foresee
