// Hulls of real ships against their boxes.
#include "hulls/modes.h"
#include "hulls/query_costs.h"
#include "hulls/ships.h"
#include "shape/outline/wkt.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

constexpr const char* hull_columns = "id, t, x, y, vx, vy, shape, heading, r";

/// Discs and points as boxes of their radius.
void load(Database& db, const std::string& file) {
  register_foresee(db);
  db.run("ATTACH '" + file + "' AS ais");
  db.run(std::string("CREATE VIRTUAL TABLE hulls USING moving_objects(") + hull_columns + ")");
  db.run("CREATE VIRTUAL TABLE boxes USING moving_objects(id, t, x, y, vx, vy, hx, hy)");
  db.run(std::string("INSERT INTO hulls SELECT ") + hull_columns + " FROM ais.ais_hulls");
  Statement read(db, std::string("SELECT ") + hull_columns + " FROM hulls");
  Statement insert(db, "INSERT INTO boxes VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
  while (read.step()) {
    insert.bind(1, read.integer(0));
    for (int i = 1; i < 6; ++i) insert.bind(1 + i, read.number(i));
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(read.handle(), 6));
    const double r = read.number(8);
    const auto half = text ? half_extents_of(read_outline(text), read.number(7)) : std::array{r, r};
    insert.bind(7, half[0]), insert.bind(8, half[1]);
    insert.step();
  }
}

}  // namespace

void measure_real_hulls(const std::string& file, bool quick) {
  Database db(":memory:");
  load(db, file);
  for (const std::string within : {"0", "50"}) {
    const auto join = [&](const char* table) {
      return std::string("predictive_join(600, '") + table + "', " + within + ", NULL, 1641168600)";
    };
    for (const auto& [name, what] : {std::pair("count", "count(*)"),
                                     {"t", "count(*), sum(t)"},
                                     {"t, t_end", "count(*), sum(t), sum(t_end)"}}) {
      const std::string select = std::string("SELECT ") + what + " FROM ";
      TimedQuery hulls(db, select + join("hulls")), boxes(db, select + join("boxes"));
      query_in_turns({&hulls, &boxes}, quick ? 25 : 101, step_through);
      std::printf(
          "real hulls, within %-3s %-9s %7.3f ms, %lld pairs   boxes %7.3f ms, %lld pairs: %.2f times (mark: "
          "3)\n",
          within.c_str(), name, median(hulls.seconds) * 1e3, static_cast<long long>(hulls.rows),
          median(boxes.seconds) * 1e3, static_cast<long long>(boxes.rows),
          median(hulls.seconds) / median(boxes.seconds));
    }
    Statement explain(db, "SELECT n_before, n_after FROM predictive_explain(600, 'hulls', " + within +
                              ", NULL, 1641168600) WHERE stage = 'refinement'");
    while (explain.step())
      std::printf("  refinement removes %.1f %% of %.0f pairs of boxes\n",
                  100 * (1 - explain.number(1) / explain.number(0)), explain.number(0));
  }
}

}  // namespace foresee::bench
