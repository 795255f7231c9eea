// Objects that may meet no other: joins do not read them, and every other query does.
#include <gtest/gtest.h>

#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

constexpr const char* may_meet = "(one.category & two.mask) <> 0 AND (two.category & one.mask) <> 0";

/// A file with `ships`, some of which meet no other, and what its joins must give. Each query has a new connection.
class HalfInert {
 public:
  /// `inert`: an SQL condition on columns of ships.
  explicit HalfInert(const std::string& inert) {
    Database db(file_.path());
    RandomScene scene = random_scene(
        {.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball}, .count = 3000, .seed = 21});
    how_ = " AND h = " + std::to_string(scene.h) + " AND now = 0 AND within = 1";
    build_table(db, "plain", scene);
    const std::string columns = "id, x, y, vx, vy, r";
    db.exec("CREATE TABLE kinds AS SELECT id, iif(" + inert + ", 1, 2) AS category, iif(" + inert +
            ", 0, 2) AS mask FROM plain");
    for (const char* table : {"ships", "buoys"})
      db.exec(std::string("CREATE VIRTUAL TABLE ") + table + " USING moving_objects(" + columns +
              ", category, mask); INSERT INTO " + table + " SELECT " + columns +
              ", category, mask FROM plain JOIN kinds USING (id)" +
              (table == std::string("buoys") ? " WHERE id % 3 = 0" : ""));
    db.exec("CREATE VIRTUAL TABLE plain_buoys USING moving_objects(" + columns +
            "); INSERT INTO plain_buoys SELECT " + columns + " FROM plain WHERE id % 3 = 0");
  }

  const std::string& how() const { return how_; }
  std::string path() const { return file_.path(); }

  std::string join(Database& db, const std::string& more) const {
    return db.rows("SELECT a, b, t FROM predictive_join WHERE tbl = 'ships'" + how_ + more +
                   " ORDER BY a, b");
  }
  std::string filtered(Database& db, const std::string& more) const {
    return db.rows("SELECT a, b, t FROM predictive_join, kinds AS one, kinds AS two WHERE tbl = 'plain'" +
                   how_ + more + " AND one.id = a AND two.id = b AND " + may_meet + " ORDER BY a, b");
  }

 private:
  TemporaryFile file_;
  std::string how_;
};

// Mixed in all leaves; in subtrees of their own, which are not read; and none.
constexpr const char* inert_ships[] = {"id % 2", "x < (SELECT max(x) * 0.7 FROM plain)", "0"};

TEST(InertObjects, AreNotReadAndChangeNoRow) {
  for (const char* inert : inert_ships) {
    SCOPED_TRACE(inert);
    const HalfInert file(inert);
    std::string within, with_buoys, itself;
    {
      Database db(file.path());
      within = file.filtered(db, ""), itself = file.filtered(db, " AND other = 'plain'");
      with_buoys = file.filtered(db, " AND other = 'plain_buoys'");
    }
    ASSERT_GT(within.size(), 1000u);
    for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
      SCOPED_TRACE(method);
      const std::string by = std::string(" AND method = '") + method + "'";
      for (int order = 0; order < 3; ++order) {  // each is the first query of a connection once
        Database db(file.path());
        for (int i = 0; i < 3; ++i) {
          const int query = (order + i) % 3;
          const char* other = query == 0 ? "" : query == 1 ? " AND other = 'ships'" : " AND other = 'buoys'";
          EXPECT_EQ(file.join(db, by + other), query == 0 ? within : query == 1 ? itself : with_buoys);
        }
      }
    }
  }
}

TEST(InertObjects, AreThereForEveryOtherQuery) {
  for (const char* inert : inert_ships) {
    SCOPED_TRACE(inert);
    const HalfInert file(inert);
    Database db(file.path());
    const auto expect_all = [&] {
      EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_position WHERE tbl = 'ships' AND at = 0"), "3000");
      EXPECT_EQ(db.rows("SELECT n_before FROM predictive_explain WHERE tbl = 'ships'" + file.how() +
                        " AND stage = 'kinds'"),
                std::to_string(3000 * 2999 / 2));
      EXPECT_EQ(
          db.rows("SELECT count(*) FROM predictive_window WHERE tbl = 'ships' AND h = 0 AND now = 0 AND "
                  "method = 'scan'"),
          "3000");
      // A table without kinds has category 1, which no mask of ships has.
      EXPECT_EQ(file.join(db, " AND other = 'plain'"), "");
    };
    const std::string within = file.filtered(db, "");
    for (const char* method : {" AND method = 'tree'", "", " AND method = 'tree'"}) {
      db.exec("UPDATE ships SET r = r WHERE id = 1");  // another version of the contents
      EXPECT_EQ(file.join(db, method), within);
      expect_all();
      EXPECT_EQ(file.join(db, method), within);
    }
  }
}

TEST(InertObjects, FollowTheChangesOfATransaction) {
  for (const char* inert : inert_ships) {
    SCOPED_TRACE(inert);
    const HalfInert file(inert);
    Database db(file.path());
    db.exec("BEGIN");
    for (const char* change :
         {"UPDATE % SET category = 2, mask = 2 WHERE id % 5 = 0", "DELETE FROM % WHERE id % 7 = 0",
          "UPDATE % SET category = 1, mask = 0", "UPDATE % SET mask = 1 WHERE id = 9 OR id % 11 = 0"}) {
      SCOPED_TRACE(change);
      for (const char* table : {"ships", "kinds"})
        db.exec(std::string(change).replace(std::string(change).find('%'), 1, table));
      const std::string expected = file.filtered(db, "");
      EXPECT_EQ(file.join(db, ""), expected);
      EXPECT_EQ(file.join(db, " AND method = 'tree'"), expected);
    }
    db.exec("COMMIT");
    EXPECT_EQ(file.join(db, ""), file.filtered(db, ""));
  }
}

}  // namespace
}  // namespace foresee::testing
