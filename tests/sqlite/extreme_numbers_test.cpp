// Numbers from the whole range of doubles, through SQL: every method gives for every query the rows that a
// scan of all objects gives.
#include "extreme_numbers.h"

#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

std::string literal(double number) {
  char text[40];
  sqlite3_snprintf(sizeof text, text, "%!.17g", number);
  return text;
}

/// A table of a random scene, and its queries by every method.
class RandomQueries {
 public:
  explicit RandomQueries(std::uint64_t seed)
      : scene_(extreme_scene(seed)), numbers_(seed), h_(literal(scene_.h)), now_(literal(scene_.now)) {
    db_.exec("PRAGMA page_size = 512");
    build_table(db_, "objects", scene_);
  }

  void expect_same_pairs() {
    const std::string queried = "SELECT * FROM predictive_join(" + h_ + ", 'objects', " +
                                literal(scene_.within) + ", NULL, " + now_ + ", METHOD)";
    for (const char* method : {"auto", "grid", "tree", "gpcd"}) {
      expect_same(queried + " ORDER BY a, b", method);
      expect_same(queried + " WHERE a = 2 OR b = 2 ORDER BY a, b", method);
    }
  }
  void expect_same_window() {
    std::string faces, speeds;
    for (int axis = 0; axis < 3; ++axis) {
      const double one = numbers_.length(), other = numbers_.length();
      const bool there = axis < scene_.layout.axes;
      faces += there ? ", " + literal(std::min(one, other)) + ", " + literal(std::max(one, other))
                     : ", NULL, NULL";
      speeds += there ? ", " + literal(numbers_.speed()) : ", NULL";
    }
    expect_same("SELECT * FROM predictive_window(" + h_ + ", 'objects'" + faces + ", " + now_ + speeds +
                    ", METHOD) ORDER BY id",
                "tree");
  }
  void expect_same_nearest() {
    std::string point, speeds;
    for (int axis = 0; axis < 3; ++axis) {
      const bool there = axis < scene_.layout.axes;
      point += there ? ", " + literal(numbers_.length()) : ", NULL";
      speeds += there ? ", " + literal(numbers_.speed()) : ", NULL";
    }
    const auto first_of = [&](const std::string& k, const std::string& method) {
      return db_.rows("SELECT * FROM predictive_nearest(" + h_ + ", 'objects', " + k + point + ", " + now_ +
                      speeds + ", '" + method + "') WHERE rank <= 2 ORDER BY rank");
    };
    const std::string all = first_of("1000", "scan");
    for (const char* method : {"tree", "scan"}) EXPECT_EQ(first_of("2", method), all) << method;
  }
  void expect_a_place_for_each_that_exists() {
    const std::string until = scene_.layout.has_until ? "coalesce(until, 9e999)" : "9e999",
                      t = scene_.layout.has_t ? "t" : "0";
    EXPECT_EQ(db_.rows("SELECT id FROM predictive_position(" + now_ +
                       ", 'objects') WHERE x IS NOT NULL ORDER BY id"),
              db_.rows("SELECT id FROM objects WHERE " + now_ + " BETWEEN " + t + " AND " + until +
                       " ORDER BY id"));
  }

 private:
  void expect_same(std::string question, const std::string& method) {
    const auto rows_by = [&](const std::string& name) {
      return db_.rows(std::string(question).replace(question.find("METHOD"), 6, "'" + name + "'"));
    };
    const std::string right = rows_by("scan");
    EXPECT_NE(right.substr(0, 6), "error:") << right;
    EXPECT_EQ(rows_by(method), right) << method << ": " << question;
  }

  Database db_;
  RandomScene scene_;
  ExtremeNumbers numbers_;
  std::string h_, now_;
};

TEST(ExtremeNumbers, EveryQueryGivesTheRowsOfAScan) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("scene " + std::to_string(seed));
    RandomQueries queried(seed);
    queried.expect_same_pairs();
    queried.expect_same_window();
    queried.expect_same_nearest();
    queried.expect_a_place_for_each_that_exists();
  }
}

TEST(ExtremeNumbers, TwoThatFlyApartFasterThanAnyDoubleTouchBefore) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE s USING moving_objects(id, t, x, vx, hx);"
      "INSERT INTO s VALUES(1, 1e-310, 1e200, -1e308, 0), (2, -1e-160, -1, 1e308, 1e200)");
  for (const char* method : {"auto", "grid", "tree", "scan", "gpcd"}) {
    const std::string call = "SELECT a, b FROM predictive_join(1e-300, 's', 0, NULL, 0, '";
    EXPECT_EQ(db.rows(call + method + "')"), "1|2") << method;
    EXPECT_EQ(db.rows(call + method + "') WHERE a = 1"), "1|2") << method;
  }
}

}  // namespace
}  // namespace foresee::testing
