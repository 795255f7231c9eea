// Look-up of objects by id, as a statement does it: memory is used only while it is valid.
#include <filesystem>
#include <map>
#include <random>

#include "storage/database.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {
namespace {

/// The first coordinate of an object, or nothing.
std::optional<double> look(Store& store, std::int64_t id, StatementReadState& statement_state) {
  const std::span<const double> record = store.find(id, statement_state);
  return record.empty() ? std::nullopt : std::optional(record[1]);
}

/// The same by a statement of its own.
std::optional<double> look(Store& store, std::int64_t id) {
  StatementReadState statement_state;
  return look(store, id, statement_state);
}

class LookUp : public ::testing::Test {
 protected:
  static constexpr int objects = 300;  // six leaves and a root

  LookUp() {
    begin(db, *store);
    for (int id = 1; id <= objects; ++id) store->insert(id, ship(id), {});
    commit(db, *store);
    reopen();
  }

  /// Replaces the store by a new one, as of a new connection.
  void reopen() {
    store.reset();
    store = Store::open(db, "main", "ships", ships());
  }

  Database db;
  std::shared_ptr<Store> store = make_store(db);
};

TEST_F(LookUp, FindsWhatReadFinds) {
  StatementReadState statement_state;
  for (int twice = 0; twice < 2; ++twice)
    for (std::int64_t id = -1; id <= objects + 2; ++id) {
      const auto record = store->read(id);
      const auto found = store->find(id, statement_state);
      EXPECT_EQ(std::vector<double>(found.begin(), found.end()), record.value_or(std::vector<double>()));
    }
}

TEST_F(LookUp, ALeafInMemoryIsValidUnderTheSameStampOnly) {
  StatementReadState statement_state;
  for (std::int64_t id = 1; id <= objects; ++id) look(*store, id, statement_state);
  db.run("DELETE FROM ships_node; DELETE FROM ships_map");  // so only a read of the rows detects it
  EXPECT_EQ(look(*store, 7, statement_state), 7);
  EXPECT_EQ(look(*store, 8), 8);
  db.run("UPDATE ships_meta SET value = value + 1 WHERE key = 'stamp'");
  EXPECT_EQ(look(*store, 7, statement_state), 7) << "the statement is the same";
  EXPECT_EQ(look(*store, 7), std::nullopt);
}

// PRAGMA integrity_check reads without xBegin; what was read of the map before may be out of date.
TEST_F(LookUp, TheCheckReadsTheMapAgainAfterAnotherConnectionHasWritten) {
  const std::string path = (std::filesystem::path(FORESEE_BINARY_DIR) / "look_up_check.db").string();
  std::filesystem::remove(path);
  {
    Database one(path), two(path);
    const auto ours = make_store(one);
    begin(one, *ours);
    for (int id = 1; id <= objects; ++id) ours->insert(id, ship(id), {});
    commit(one, *ours);
    NodeCache& cache = ours->nodes();
    for (int id = 1; id <= objects; ++id) cache.find_leaf(id);
    const auto theirs = Store::open(two, "main", "ships", ships());
    begin(two, *theirs);
    for (int id = 1; id <= objects; id += 2) theirs->update(id, id, ship(objects - id), {});
    commit(two, *theirs);
    EXPECT_EQ(faults(*ours), std::vector<std::string>{});
  }
  std::filesystem::remove(path);
}

TEST_F(LookUp, AMissingStampIsReportedByTheSecondLookUpOfATable) {
  db.run("DELETE FROM ships_meta WHERE key = 'stamp'");
  EXPECT_EQ(look(*store, 7), 7) << "without the cache";
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships: the stamp is missing", [&] { look(*store, 7); });
}

TEST_F(LookUp, AStatementSeesTheChangesOfItsOwnConnectionAtOnce) {
  StatementReadState statement_state;
  for (std::int64_t id = 1; id <= objects; ++id) look(*store, id, statement_state);
  begin(db, *store);
  store->update(5, 5, ship(50), {});
  store->update(6, 1006, ship(60), {});
  store->erase(7);
  store->insert(2000, ship(70), {});
  const auto expect_new = [&] {
    EXPECT_EQ(look(*store, 5, statement_state), 50);
    EXPECT_EQ(look(*store, 6, statement_state), std::nullopt);
    EXPECT_EQ(look(*store, 1006, statement_state), 60);
    EXPECT_EQ(look(*store, 7, statement_state), std::nullopt);
    EXPECT_EQ(look(*store, 2000, statement_state), 70);
    EXPECT_EQ(look(*store, 8, statement_state), 8);
  };
  expect_new();
  store->take_snapshot();  // pending objects go into the tree
  expect_new();
  open_savepoint(db, *store, 0);
  store->update(5, 5, ship(51), {});
  NeverInterrupt never;
  store->rebuild(never);
  EXPECT_EQ(look(*store, 5, statement_state), 51);
  roll_back_to(db, *store, 0);
  expect_new();
  commit(db, *store);
  expect_new();
  begin(db, *store);
  store->update(5, 5, ship(52), {});
  store->erase(8);
  EXPECT_EQ(look(*store, 5, statement_state), 52);
  EXPECT_EQ(look(*store, 8, statement_state), std::nullopt);
  roll_back(db, *store);
  expect_new();
}

TEST_F(LookUp, DamageIsReportedAlikeWithAndWithoutTheCache) {
  write_map_as_version_0_1(db);
  const std::string node_of_9 = "nodeno = (SELECT leaf FROM ships_map WHERE id = 9)";
  const std::pair<std::string, const char*> damages[] = {
      {"UPDATE ships_node SET data = zeroblob(length(data)) WHERE " + node_of_9,
       " is damaged: its checksum does not match"},
      {"DELETE FROM ships_node WHERE " + node_of_9, " of object 9 is missing"},
      {"UPDATE ships_map SET leaf = 'x' WHERE id = 9", "row 9: a leaf's number is a positive integer"},
      {"UPDATE ships_map SET leaf = (SELECT max(leaf) + min(leaf) - ships_map.leaf FROM ships_map a)"
       " WHERE id = 9",
       " lacks object 9"},
      {"UPDATE ships_map SET leaf = (SELECT value FROM ships_meta WHERE key = 'root') WHERE id = 9",
       " lacks object 9"}};
  for (const auto& [damage, words] : damages)
    for (const bool is_first : {true, false}) {
      db.run("SAVEPOINT s; " + damage);
      reopen();
      if (!is_first) {
        look(*store, -1);
        look(*store, -1);
      }
      expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { look(*store, 9); });
      expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->read(9); });
      db.run("ROLLBACK TO s; RELEASE s");
    }
}

TEST_F(LookUp, MoreObjectsThanMemoryHoldsAreFoundAllTheSame) {
  const QualifiedName name{"main", "many"};
  db.run("BEGIN IMMEDIATE");
  const NodeFormat format = create_shadow_tables(db, name, ships());
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, ships()), ships());
  const auto many = std::make_shared<Store>(db, name, ships(), format, std::move(rows), true,
                                            std::make_shared<MemoryBudget>(MemoryLimits{.memory = 4 * 4032}));
  for (int id = 1; id <= 2000; ++id) many->insert(id, ship(id), {});
  commit(db, *many);
  StatementReadState statement_state;
  for (std::int64_t id = 1; id <= 2000; ++id) {
    ASSERT_EQ(look(*many, id, statement_state), id);
    ASSERT_EQ(look(*many, id * 7919 % 2000 + 1, statement_state), id * 7919 % 2000 + 1);
  }
}

/// A store and a model undergo the same random changes; statements that started at any time look objects up.
TEST_F(LookUp, RandomChangesAgreeWithAMapAtAnyTime) {
  std::mt19937 random(8);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::map<std::int64_t, double> model, at_start, at_savepoint;
  for (int id = 1; id <= objects; ++id) model[id] = id;
  bool in_transaction = false, in_savepoint = false;
  std::vector<StatementReadState> statements(3);
  double mark = 1000;
  const auto change = [&](std::int64_t id) {
    const bool exists = model.contains(id);
    if (!exists) {
      store->insert(id, ship(++mark), {});
    } else if (below(3) > 0) {
      store->update(id, id, ship(++mark), {});
    } else {
      store->erase(id);
      model.erase(id);
      return;
    }
    model[id] = mark;
  };
  for (int step = 0; step < 20000; ++step) {
    switch (below(40)) {
      case 0:
        if (in_transaction) break;
        begin(db, *store);
        at_start = model;
        in_transaction = true;
        break;
      case 1:
        if (!in_transaction) break;
        commit(db, *store);
        in_transaction = in_savepoint = false;
        break;
      case 2:
        if (!in_transaction) break;
        roll_back(db, *store);
        model = at_start;
        in_transaction = in_savepoint = false;
        break;
      case 3:
        if (!in_transaction || in_savepoint) break;
        open_savepoint(db, *store, 0);
        at_savepoint = model;
        in_savepoint = true;
        break;
      case 4:
        if (in_savepoint) roll_back_to(db, *store, 0), model = at_savepoint;
        break;
      case 5:
        if (below(2) == 0) store->take_snapshot();
        break;
      case 6:
        statements[static_cast<std::size_t>(below(3))] = {};
        break;
      default:
        if (in_transaction && below(3) == 0) change(below(2 * objects));
    }
    const std::int64_t id = below(2 * objects);
    const auto known = model.find(id);
    const auto expected = known == model.end() ? std::nullopt : std::optional(known->second);
    ASSERT_EQ(look(*store, id, statements[static_cast<std::size_t>(below(3))]), expected) << step;
  }
}

}  // namespace
}  // namespace foresee
