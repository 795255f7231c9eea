// Corrupted blobs: every byte of every stored blob is changed once (with sanitizers, every third byte). The
// result is a clear error or the right rows, never a crash, a hang or a wrong row.
#include <vector>

#include "sanitized.h"
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* questions[] = {
    "SELECT * FROM ships ORDER BY id",
    "SELECT id, x FROM ships WHERE id = 17",
    "SELECT a, b, t FROM predictive_join(20, 'ships') ORDER BY a, b",
    "SELECT * FROM predictive_position(10, 'ships') ORDER BY id",
    "SELECT * FROM predictive_sweep(10, 'ships') WHERE x1 >= 0 ORDER BY id",
    "SELECT a, b FROM predictive_join(10, 'ships', 0, NULL, 0, NULL, NULL, NULL, -1, 9) ORDER BY a, b",
};

std::vector<std::string> answers(Database& db) {
  std::vector<std::string> all;
  for (const char* question : questions) all.push_back(db.rows(question));
  return all;
}

/// A tree of several levels in pages of the smallest size.
void build_small(Database& db) {
  db.exec(
      "PRAGMA page_size = 512;"
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 40)"
      "INSERT INTO ships SELECT i, i % 5, i * 37 % 100, i * 53 % 90, i % 7 - 3, i % 5 - 2, 0.5 FROM n");
}

TEST(HostileBytes, EachChangedByteOfEachNodeIsAnErrorOrTheRightRows) {
  TemporaryFile file;
  std::vector<std::string> right;
  std::vector<std::pair<std::int64_t, int>> nodes;  // number, size
  {
    Database db(file.path());
    build_small(db);
    right = answers(db);
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(db.handle(), "SELECT nodeno, length(data) FROM ships_node", -1, &statement, nullptr);
    while (sqlite3_step(statement) == SQLITE_ROW)
      nodes.emplace_back(sqlite3_column_int64(statement, 0), sqlite3_column_int(statement, 1));
    sqlite3_finalize(statement);
  }
  ASSERT_GT(nodes.size(), 4u);
  constexpr int step = sanitized ? 3 : 1;
  Random random(4);
  int noticed = 0;
  for (const auto& [number, size] : nodes) {
    for (int at = static_cast<int>(number % step); at < size && !HasFailure(); at += step) {
      Database db(file.path());  // in a transaction without COMMIT: the file does not change
      sqlite3_exec(db.handle(), "PRAGMA synchronous = OFF; BEGIN", nullptr, nullptr, nullptr);
      sqlite3_blob* blob = nullptr;
      ASSERT_EQ(sqlite3_blob_open(db.handle(), "main", "ships_node", "data", number, 1, &blob), SQLITE_OK);
      unsigned char byte;
      sqlite3_blob_read(blob, &byte, 1, at);
      byte ^= static_cast<unsigned char>(1 + random.below(255));
      sqlite3_blob_write(blob, &byte, 1, at);
      sqlite3_blob_close(blob);
      const std::vector<std::string> found = answers(db);
      for (std::size_t i = 0; i < right.size(); ++i) {
        if (found[i] == right[i]) continue;
        EXPECT_NE(found[i].find("node " + std::to_string(number)), std::string::npos) << found[i];
        ++noticed;
      }
    }
  }
  EXPECT_GT(noticed, 1000 / step);
}

}  // namespace
}  // namespace foresee::testing
