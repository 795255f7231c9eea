// Floating-point environment of the host: another rounding mode or flush-to-zero changes no row.
#include <bit>
#include <cfenv>
#include <functional>
#include <vector>

#include "sqlite/scene_table.h"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace foresee::testing {
namespace {

/// The bits of all rows, with the host's settings while the statement is prepared and stepped.
std::vector<std::uint64_t> bits_of(Database& db, const std::string& sql, const std::function<void()>& host) {
  std::vector<std::uint64_t> bits;
  std::fenv_t before;
  std::fegetenv(&before);
  host();
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement, nullptr);
  while (sqlite3_step(statement) == SQLITE_ROW)
    for (int i = 0; i < sqlite3_column_count(statement); ++i)
      bits.push_back(std::bit_cast<std::uint64_t>(sqlite3_column_double(statement, i)));
  sqlite3_finalize(statement);
  std::fesetenv(&before);
  return bits;
}

std::vector<std::uint64_t> answers(const std::function<void()>& host) {
  Database db;  // a new one each time, without a cached scene
  build_table(
      db, "drones",
      random_scene(
          {.layout = {.axes = 3, .law = Law::forced, .shape = Shape::ball, .has_t = true, .has_until = true},
           .kind = SceneKind::clustered,
           .count = 600,
           .seed = 5}));
  auto bits = bits_of(db, "SELECT * FROM predictive_join(3) WHERE method = 'grid' ORDER BY a, b", host);
  auto positions = bits_of(db, "SELECT * FROM predictive_position(0) ORDER BY id", host);
  const auto tracks = bits_of(db, "SELECT * FROM predictive_track(0, 1, 0.375) ORDER BY t, id", host);
  EXPECT_GT(tracks.size(), 3 * positions.size());
  positions.insert(positions.end(), tracks.begin(), tracks.end());
  EXPECT_GT(bits.size(), 9u * 100);
  EXPECT_GT(positions.size(), 7u * 100);
  bits.insert(bits.end(), positions.begin(), positions.end());
  return bits;
}

TEST(HostFloatEnvironment, ChangesNoAnswer) {
  const std::vector<std::uint64_t> usual = answers([] {});
  for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    EXPECT_EQ(answers([mode] { std::fesetround(mode); }), usual) << mode;
#ifdef __SSE2__
  EXPECT_EQ(answers([] { _mm_setcsr(_mm_getcsr() | 0x8040); }), usual) << "flush to zero";
#endif
}

TEST(HostFloatEnvironment, IsBackAfterAStatement) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE rockets USING moving_objects(id, x, vx, fx, m)");
  db.exec("INSERT INTO rockets VALUES (1, 0, 0, 1, 3), (2, 1, 0, -1, 3)");
  std::fesetround(FE_UPWARD);
  db.exec("INSERT INTO rockets VALUES (3, 5, 0, 1, 7)");
  bits_of(db, "SELECT * FROM predictive_join(30)", [] {});
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
}

}  // namespace
}  // namespace foresee::testing
