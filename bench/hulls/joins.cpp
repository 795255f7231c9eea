// Joins of hulls, boxes and discs: counted, with times, joined to their table, and for one ship each.
#include "hulls/modes.h"
#include "hulls/query_costs.h"
#include "hulls/ships.h"

namespace foresee::bench {
namespace {

void compare(ShipTables& tables, const std::string& what, const std::string& sql, int repetitions,
             auto&& run) {
  TimedQuery hulls(tables.hulls.db(), sql), boxes(tables.boxes.db(), sql), discs(tables.discs.db(), sql);
  query_in_turns({&hulls, &boxes, &discs}, repetitions, run);
  const double cost = median(hulls.seconds);
  std::printf("%-28s hulls %8.1f ms", what.c_str(), cost * 1e3);
  for (const auto& [name, other] : {std::pair("boxes", &boxes), {"discs", &discs}})
    std::printf("   %s %8.1f ms, hulls take %.2f times as long", name, median(other->seconds) * 1e3,
                cost / median(other->seconds));
  std::printf("\n  rows: hulls %lld, boxes %lld, discs %lld\n", static_cast<long long>(hulls.rows),
              static_cast<long long>(boxes.rows), static_cast<long long>(discs.rows));
  std::fflush(stdout);
}

/// The input of the refinement and the pairs that it removes.
void print_refinement(Database& hulls, const std::string& inputs) {
  Statement explain(hulls, "SELECT n_before, n_after, seconds, detail FROM predictive_explain(" + inputs +
                               ") WHERE stage = 'refinement'");
  while (explain.step())
    std::printf("  refinement removes %.1f %% of %.0f pairs of boxes, %.0f ns per pair; %s\n",
                100 * (1 - explain.number(1) / explain.number(0)), explain.number(0),
                explain.number(2) * 1e9 / explain.number(0),
                reinterpret_cast<const char*>(sqlite3_column_text(explain.handle(), 3)));
}

}  // namespace

void measure_hull_joins(bool quick) {
  const Ships ships;
  ShipTables tables(ships);
  const int repetitions = quick ? 3 : 11;
  for (const std::string within : {"0", "50"}) {
    const std::string inputs = "600, 'ships', " + within, join = "predictive_join(" + inputs + ")";
    const std::string name = ", within " + within;
    compare(tables, "join, count" + name, "SELECT count(*) FROM " + join, repetitions, step_through);
    compare(tables, "join, t" + name, "SELECT count(*), sum(t) FROM " + join, repetitions, step_through);
    compare(tables, "join, t, t_end" + name, "SELECT count(*), sum(t), sum(t_end) FROM " + join, repetitions,
            step_through);
    compare(tables, "joined to both rows" + name,
            "SELECT count(*), sum(j.t), sum(j.t_end), sum(s.x), sum(u.x) FROM " + join +
                " j JOIN ships s ON s.id = j.a JOIN ships u ON u.id = j.b",
            repetitions, step_through);
    compare(tables, "a = ?, 1000 ships" + name, "SELECT count(*), sum(t) FROM " + join + " WHERE a = ?1",
            repetitions, [](TimedQuery& question) {
              for (std::int64_t id = 50; id <= 100000; id += 100) {
                question.statement.bind(1, id);
                step_through(question);
              }
            });
    print_refinement(tables.hulls.db(), inputs);
  }
}

}  // namespace foresee::bench
