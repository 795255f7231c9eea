// Two trees of one table under one journal: every rollback restores both, and neither sees the other.
#include "storage/tree/tree_store.h"

#include <map>
#include <random>

#include "storage/database.h"
#include "storage/rows/shadow_rows.h"

namespace foresee {
namespace {

using Model = std::map<std::int64_t, double>;

class TwoTrees : public ::testing::Test {
 protected:
  TwoTrees()
      : format((db.run("BEGIN IMMEDIATE"), create_shadow_tables(db, name, ships()))),
        others(db, name, others_and_meta()),
        rows(shadow_tables(db, name, ships()), ships()),
        other_rows((create_others(), others), rows.meta(), "chunk"),
        first(db, format, name, 60, journal, memory, [] {}),
        second(db, format, name, 60, journal, memory, [] {}) {
    first.connect(rows.tree());
    second.connect(other_rows);
    db.run("COMMIT");
  }
  static std::vector<ShadowTable> others_and_meta() {
    std::vector<ShadowTable> tables = TreeRows::tables("chunk");
    tables.push_back(MetaRows::table());
    return tables;
  }
  void create_others() {
    ShadowTables(db, name, TreeRows::tables("chunk")).create();
    db.run("INSERT INTO ships_meta VALUES('chunk_root', 0)");
  }

  static void put(TreeStore& tree, std::int64_t id, double x) {
    if (!tree.update(id, ship(x))) tree.insert(id, ship(x));
  }
  void start() { db.run("BEGIN IMMEDIATE"), journal.begin(); }
  void write() {
    merge();
    first.write(never);
    second.write(never);
  }
  void commit() {
    write();
    db.run("COMMIT");
    journal.end(Journal::Ended::committed);
  }
  void roll_back() {
    db.run("ROLLBACK");
    journal.end(Journal::Ended::rolled_back);
  }
  template <class Body>
  void change(Body body) {
    const Journal::Mark mark = journal.set_mark();
    body();
    journal.forget(mark);
  }
  void merge() {
    change([&] {
      for (TreeStore* tree : {&first, &second})
        if (tree->must_merge(TreeStore::Reason::query)) tree->merge_pending(TreeStore::Reason::query, never);
    });
  }
  Model contents(TreeStore& tree) {
    Model all;
    merge();
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    collect_objects(tree.nodes(), ids, records, never);
    for (std::size_t i = 0; i < ids.size(); ++i) all[ids[i]] = records[i * 6 + 1];
    const TreeReport report = check_tree(tree.nodes(), never);
    EXPECT_EQ(report.problems, std::vector<std::string>{});
    EXPECT_EQ(report.objects, ids.size());
    return all;
  }

  Database db;
  QualifiedName name{"main", "ships"};
  NodeFormat format;
  ShadowTables others;
  ShadowRows rows;
  TreeRows other_rows;
  MemoryBudget memory;
  Journal journal;
  TreeStore first, second;
  NeverInterrupt never;
};

TEST_F(TwoTrees, StoreTheirObjectsApart) {
  start();
  change([&] {
    for (int id = 1; id <= 500; ++id) first.insert(id, ship(id));
    for (int id = 400; id <= 700; ++id) second.insert(id, ship(-id));
  });
  commit();
  EXPECT_GT(db.number("SELECT count(*) FROM ships_node"), 1);
  EXPECT_GT(db.number("SELECT count(*) FROM ships_chunknode"), 1);
  EXPECT_GT(db.number("SELECT value FROM ships_meta WHERE key = 'chunk_root'"), 0);
  EXPECT_EQ(rows.tree().map().count_ids(), 500);
  EXPECT_EQ(other_rows.map().count_ids(), 301);
  first.nodes().forget_all();
  second.nodes().forget_all();
  EXPECT_EQ(contents(first).at(450), 450);
  EXPECT_EQ(contents(second).at(450), -450);
  EXPECT_EQ(contents(second).size(), 301u);
}

TEST_F(TwoTrees, AreRestoredTogetherThroughRandomProgramsOfSavepoints) {
  std::mt19937 random(20261124);
  struct Both {
    Model first, second;
  } model;
  for (int round = 0; round < 25; ++round) {
    const Both committed = model;
    std::vector<std::pair<Journal::Mark, Both>> savepoints;
    const auto put = [&](TreeStore& tree, Model& its, std::int64_t id) {
      const double x = static_cast<double>(random() % 1000);
      TwoTrees::put(tree, id, x);
      its[id] = x;
    };
    start();
    for (int step = 0; step < 150; ++step) {
      const auto id = static_cast<std::int64_t>(random() % 400);
      switch (random() % 12) {
        case 0:
          db.run("SAVEPOINT s" + std::to_string(savepoints.size()));
          savepoints.push_back({journal.set_mark(), model});
          break;
        case 1:
          if (savepoints.empty()) break;
          savepoints.resize(random() % savepoints.size() + 1);
          db.run("ROLLBACK TO s" + std::to_string(savepoints.size() - 1));
          journal.rewind(savepoints.back().first);
          model = savepoints.back().second;
          break;
        case 2:
          if (savepoints.empty() || random() % 2) break;
          savepoints.resize(random() % savepoints.size());
          db.run("RELEASE s" + std::to_string(savepoints.size()));
          journal.forget(1 + savepoints.size());
          break;
        case 3:
          if (random() % 4 == 0) write();
          break;
        case 4: {  // a change that fails half-way, in either tree
          const Both before = model;
          const Journal::Mark mark = journal.set_mark();
          put(first, model.first, id);
          put(second, model.second, id);
          if (random() % 2) first.merge_pending(TreeStore::Reason::query, never);
          journal.rewind(mark);
          journal.forget(mark);
          model = before;
          break;
        }
        case 5:
          change([&] {
            for (int more = 0; more < 60; ++more)
              put(second, model.second, 1000 + static_cast<int>(random() % 900));
          });
          break;
        case 6:  // enough for erase_all() to take them leaf by leaf
          if (random() % 3 != 0) break;
          change([&] {
            for (int more = 0; more < 300; ++more) {
              const auto one = static_cast<std::int64_t>(random() % 400);
              EXPECT_EQ(first.erase(one), model.first.erase(one) > 0);
            }
          });
          break;
        case 7:
          change([&] {
            EXPECT_EQ(first.erase(id), model.first.erase(id) > 0);
            EXPECT_EQ(second.erase(id + 1), model.second.erase(id + 1) > 0);
          });
          break;
        case 8:
          if (random() % 4 == 0) {
            ASSERT_EQ(contents(first), model.first) << round << ", " << step;
            ASSERT_EQ(contents(second), model.second) << round << ", " << step;
          }
          break;
        default:
          change([&] {
            put(first, model.first, id);
            put(second, model.second, 2 * id);
          });
      }
    }
    if (random() % 3 == 0) {
      roll_back();
      model = committed;
    } else {
      commit();
    }
    ASSERT_EQ(contents(first), model.first) << round;
    ASSERT_EQ(contents(second), model.second) << round;
  }
  EXPECT_GT(model.first.size() + model.second.size(), 100u);
}

}  // namespace
}  // namespace foresee
