// Stored id map: blocks and the rows of version 0.1 give the same answers, also mixed, and damage is
// reported.
#include "storage/rows/id_map_rows.h"

#include <map>
#include <random>

#include "storage/database.h"

namespace foresee {
namespace {

using Leaves = std::map<std::int64_t, std::int64_t>;

class StoredMap : public ::testing::Test {
 protected:
  StoredMap() { make_store(db); }

  void write(const Leaves& changes) {
    std::vector<IdHashMap::Entry> entries;
    for (const auto& [id, leaf] : changes) entries.push_back({id, leaf});
    rows.write(entries);
  }
  Leaves all() {
    Leaves all;
    rows.read([&](std::int64_t id, std::int64_t leaf) { all[id] = leaf; });
    return all;
  }
  void expect_all(const Leaves& leaves) {
    EXPECT_EQ(all(), leaves);
    EXPECT_EQ(rows.count_ids(), static_cast<std::int64_t>(leaves.size()));
    EXPECT_EQ(rows.is_empty(), leaves.empty());
    EXPECT_EQ(rows.read_largest_id(), leaves.empty() ? std::nullopt : std::optional(leaves.rbegin()->first));
  }
  std::string stored() {
    return db.text(
        "SELECT group_concat(id || ' ' || CASE typeof(leaf) WHEN 'blob' THEN hex(leaf) ELSE leaf END,"
        " '; ') FROM (SELECT * FROM ships_map ORDER BY id)");
  }

  Database db;
  MapRows rows{shadow_tables(db, {"main", "ships"}, ships())};
};

TEST_F(StoredMap, SixtyFourIdsAreOneRow) {
  Leaves leaves;
  for (std::int64_t id = -64; id < 128; ++id) leaves[id] = id + 1000;
  write(leaves);
  expect_all(leaves);
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_map"), 3);
  EXPECT_EQ(rows.find_leaf(-64), 936);
  EXPECT_EQ(rows.find_leaf(127), 1127);
  EXPECT_EQ(rows.find_leaf(128), std::nullopt);
  EXPECT_EQ(rows.find_leaf(-65), std::nullopt);
  EXPECT_EQ(rows.find(70).leaf_of(64), 1064) << "the whole block at once";
}

TEST_F(StoredMap, ABlockWithoutIdsIsNoRow) {
  write({{7, 1}, {8, 1}});
  write({{7, 0}});
  EXPECT_EQ(stored(), "0 010801");
  write({{8, 0}, {9, 0}, {1000, 0}});
  expect_all({});
}

TEST_F(StoredMap, RowsOfVersionZeroOneAreConvertedWhereTheyChange) {
  db.run("INSERT INTO ships_map VALUES(3, 10), (5, 11), (64, 12), (70, 13), (200, 14)");
  expect_all({{3, 10}, {5, 11}, {64, 12}, {70, 13}, {200, 14}});
  for (const auto& [id, leaf] : all()) EXPECT_EQ(rows.find_leaf(id), leaf);
  EXPECT_EQ(rows.find_leaf(4), std::nullopt);
  EXPECT_EQ(rows.find_leaf(65), std::nullopt);
  write({{5, 0}, {6, 15}, {64, 16}});
  EXPECT_EQ(stored(), "0 0103060A0F; 64 010006100D; 200 14");
  expect_all({{3, 10}, {6, 15}, {64, 16}, {70, 13}, {200, 14}});
}

/// Batches of any size, with rows of version 0.1 among the blocks, are the ids in order.
TEST_F(StoredMap, IdsAreReadInOrder) {
  db.run("INSERT INTO ships_map VALUES(-70, 1), (3, 10), (5, 11), (64, 12), (70, 13), (200, 14)");
  write({{4, 1}, {5, 2}, {500, 3}, {501, 3}, {9000, 4}});
  std::vector<std::int64_t> ids;
  for (const auto& [id, leaf] : all()) ids.push_back(id);
  for (const std::int64_t first : {-1000, -70, -69, 4, 64, 65, 501, 9001})
    for (const std::int64_t last : {-1000, -71, 3, 4, 70, 199, 9000, 10000})
      for (const std::int64_t count : {1, 2, 3, 100})
        for (const IdOrder order : {IdOrder::ascending, IdOrder::descending}) {
          std::vector<std::int64_t> found, expected;
          for (IdRange rest{first, last}; !rest.is_empty();) rest = rows.read_ids(rest, order, count, found);
          for (const std::int64_t id : ids)
            if (IdRange{first, last}.has(id)) expected.push_back(id);
          if (order == IdOrder::descending) std::reverse(expected.begin(), expected.end());
          ASSERT_EQ(found, expected) << first << " to " << last << " by " << count;
        }
  EXPECT_EQ(rows.read_extent()->first, -70);
  EXPECT_EQ(rows.read_extent()->last, 9000);
}

TEST_F(StoredMap, HasWhatWasWrittenLast) {
  std::mt19937_64 random(7);
  Leaves leaves;
  for (int round = 0; round < 60; ++round) {
    std::uniform_int_distribution<std::int64_t> id(round % 2 ? -200 : -5'000'000, 300), leaf(0, 70'000);
    Leaves changes;
    for (int i = 0; i < 40; ++i) changes[id(random)] = leaf(random);
    write(changes);
    for (const auto& [changed, where] : changes)
      where == 0 ? static_cast<void>(leaves.erase(changed)) : static_cast<void>(leaves[changed] = where);
    for (const auto& [known, where] : leaves) ASSERT_EQ(rows.find_leaf(known), where);
  }
  expect_all(leaves);
  rows.erase_all();
  expect_all({});
}

TEST_F(StoredMap, DamageIsReported) {
  for (const auto& [row, words] : std::initializer_list<std::pair<std::string, std::string>>{
           {"5, x'010507'", "row 5: a block starts at a multiple of 64"},
           {"0, x'0105'", "row 0: its size fits no number of ids"},
           {"0, 'x'", "row 0: a leaf's number is a positive integer"},
           {"0, NULL", "row 0: a leaf's number is a positive integer"},
           {"0, 0", "row 0: a leaf's number is a positive integer"},
           {"0, -3", "row 0: a leaf's number is a positive integer"}}) {
    db.run("INSERT INTO ships_map VALUES(" + row + ")");
    expect_store_error(SQLITE_CORRUPT_VTAB, "ships: ships_map is damaged: " + words, [&] { all(); });
    expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { rows.find(5); });
    expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { write({{6, 1}}); });
    expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { rows.count_ids(); });
    db.run("DELETE FROM ships_map");
  }
  db.run("INSERT INTO ships_map VALUES(0, x'0105060101'), (5, 2)");
  expect_store_error(SQLITE_CORRUPT_VTAB, "row 5: an id is in two rows", [&] { all(); });
  expect_store_error(SQLITE_CORRUPT_VTAB, "row 5: an id is in two rows", [&] { write({{9, 1}}); });
}

}  // namespace
}  // namespace foresee
