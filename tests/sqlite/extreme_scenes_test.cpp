// Stiff and extreme scenes through SQL: every row and every bit of every time is compared.
#include "sqlite/extreme_scenes.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "sanitized.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

std::vector<std::vector<double>> numbers_of(Database& db, const std::string& query) {
  std::vector<std::vector<double>> rows;
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(db.handle(), query.c_str(), -1, &statement, nullptr), SQLITE_OK)
      << sqlite3_errmsg(db.handle());
  int rc;
  while ((rc = sqlite3_step(statement)) == SQLITE_ROW) {
    std::vector<double>& row = rows.emplace_back();
    for (int i = 0; i < sqlite3_column_count(statement); ++i)
      row.push_back(sqlite3_column_double(statement, i));
  }
  EXPECT_EQ(rc, SQLITE_DONE) << sqlite3_errmsg(db.handle());
  sqlite3_finalize(statement);
  return rows;
}

TEST(ExtremeScenes, HaveTheirExactAnswers) {
  // Sanitizers make exact arithmetic twenty times slower: they see fewer aircraft.
  for (const ExtremeScene& scene : extreme_scenes(sanitized ? 60 : 300)) {
    SCOPED_TRACE(scene.name);
    Database db;
    db.exec(scene.setup);
    const auto rows = numbers_of(db, scene.query);
    ASSERT_EQ(rows.size(), scene.expected.size());
    for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], scene.expected[i]) << "row " << i;
  }
}

/// Is `t` the double nearest to sqrt(1 / a)?
bool is_root_of_inverse(double t, double a) {
  using Exact = boost::multiprecision::cpp_rational;
  auto square_times_a = [&](double towards) {
    const Exact middle = (Exact(t) + Exact(std::nextafter(t, towards))) / 2;
    return middle * middle * Exact(a);
  };
  return square_times_a(0) < 1 && square_times_a(1) > 1;
}

TEST(ExtremeScenes, AnElectronCrossesHalfAMetreAtTheExactInstant) {
  Database db;
  constexpr double mass = 9.1093837015e-31, force = 1.602176634e-13;
  db.exec(
      "CREATE VIRTUAL TABLE particles USING moving_objects(id, x, vx, fx, m, r);"
      "INSERT INTO particles VALUES (1, 0, 0, 1.602176634e-13, 9.1093837015e-31, 0.25), (2, 1, 0, 0, 1, "
      "0.25)");
  const auto rows = numbers_of(db, "SELECT t FROM predictive_join(1, 'particles')");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_TRUE(is_root_of_inverse(rows[0][0], force / mass)) << rows[0][0];
}

}  // namespace
}  // namespace foresee::testing
