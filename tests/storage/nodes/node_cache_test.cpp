// Node cache alone, with so little memory that it writes and evicts all the time.
#include "storage/nodes/node_cache.h"

#include "storage/database.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {
namespace {

class NodeCacheTest : public ::testing::Test, MemoryHolder {
 protected:
  NodeCacheTest()
      : format((db.run("BEGIN IMMEDIATE"), create_shadow_tables(db, name, ships()))),
        rows(shadow_tables(db, name, ships()), ships()),
        budget({.memory = 2 * format.node_size, .waiting = 4 * format.node_size}),
        share(budget, *this),
        cache(format, name, share, journal) {
    cache.connect(rows.tree());
    journal.begin();
  }

  void write_out() override {}
  void drop_nodes(bool all) override { cache.drop_nodes(all); }
  static Node leaf(std::int64_t id) { return {.keys = {id}, .values = ship(static_cast<double>(id))}; }
  NodeNumber add(std::int64_t id) {
    const NodeNumber number = cache.allocate();
    cache.put(number, leaf(id));
    return number;
  }

  Database db;
  QualifiedName name{"main", "ships"};
  NodeFormat format;
  ShadowRows rows;
  MemoryBudget budget;
  MemoryShare share;
  Journal journal;
  NodeCache cache;
  NeverInterrupt never;
};

TEST_F(NodeCacheTest, ACancelledChangeThatHadWrittenKeepsTheStateOfASavepoint) {
  const NodeNumber number = add(1);
  const Journal::Mark savepoint = journal.set_mark();
  db.run("SAVEPOINT s");
  const Journal::Mark change = journal.set_mark();
  cache.put(number, leaf(2));
  for (int id = 10; id < 30; ++id) add(id);
  ASSERT_TRUE(journal.is_abandoned(change));
  journal.rewind(change);
  journal.forget(change);
  db.run("ROLLBACK TO s");
  journal.rewind(savepoint);
  EXPECT_EQ(cache.read(number)->keys, std::vector<std::int64_t>{1});
  journal.forget(savepoint);
  cache.write(never);
  db.run("COMMIT");
  journal.end(Journal::Ended::committed);
  cache.forget_all();
  EXPECT_EQ(cache.read(number)->keys, std::vector<std::int64_t>{1});
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), 1);
}

TEST_F(NodeCacheTest, ACancelledChangeIsAsItWasAlsoIfTheLeafChangedLater) {
  for (const bool is_stored : {false, true})
    for (const bool leaf_changes : {false, true}) {
      const NodeNumber number = add(1);
      if (is_stored) cache.write(never);
      const std::vector<double> before = cache.read(number)->values;
      const Journal::Mark change = journal.set_mark();
      cache.modify(number).values[1] = 77;
      EXPECT_EQ(cache.read(number)->values[1], 77);
      EXPECT_TRUE(cache.dirty_node(number));
      if (leaf_changes) cache.modify(number).values[2] = 88;
      journal.rewind(change);
      journal.forget(change);
      EXPECT_EQ(cache.read(number)->values, before);
      EXPECT_EQ(cache.dirty_node(number).has_value(), !is_stored);
    }
  const NodeNumber number = add(1);
  const Journal::Mark savepoint = journal.set_mark(), change = journal.set_mark();
  cache.modify(number).values[1] = 77;
  journal.forget(change);
  journal.rewind(savepoint);
  EXPECT_EQ(cache.read(number)->values, ship(1));
  db.run("ROLLBACK");
}

TEST_F(NodeCacheTest, ListsDirtyNodesInOrder) {
  const NodeNumber first = add(1), second = add(2), third = add(3), none = third + 1;
  EXPECT_EQ(cache.next_dirty(0, none), first);
  EXPECT_EQ(cache.next_dirty(first, none), second);
  EXPECT_EQ(cache.next_dirty(first, second), 0);
  EXPECT_EQ(cache.next_dirty(second, third), 0);
  EXPECT_EQ(cache.next_dirty(third, 1'000'000'000'000), 0);
  cache.write(never);
  EXPECT_EQ(cache.next_dirty(0, none), 0);
  const Journal::Mark change = journal.set_mark();
  cache.free(second);
  EXPECT_EQ(cache.next_dirty(0, none), second);
  journal.rewind(change);
  EXPECT_EQ(cache.next_dirty(0, none), 0);
  db.run("ROLLBACK");
}

}  // namespace
}  // namespace foresee
