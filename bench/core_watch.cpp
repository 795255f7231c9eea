// A watch in memory against a new scene and a join per tick: up to which share of changed objects it is cheaper.
//
//   build/release/bench/bench_core_watch [--quick]
//
// Each tick some units get another velocity. Both give the pairs that touch within the horizon; their numbers must be
// equal. Times are CPU time per tick.
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>
#include <string>

#include "measure.h"
#include "query/join/join.h"
#include "query/memory_table.h"
#include "query/watch/memory_watch.h"
#include "query/watch/pair_update.h"

namespace {

using namespace foresee;
using bench::cpu_seconds;

constexpr Layout layout{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};
constexpr double horizon = 2, side = 1000;

struct World {
  explicit World(std::size_t units) : rows(units * size) {
    for (std::size_t i = 0; i < units; ++i) {
      at(i)[1] = place(random), at(i)[2] = place(random), at(i)[5] = 1;
      turn(i, 0);
    }
  }
  double* at(std::size_t i) { return rows.data() + i * size; }
  /// Another velocity from `t` on.
  void turn(std::size_t i, double t) {
    double* const row = at(i);
    row[1] += row[3] * (t - row[0]), row[2] += row[4] * (t - row[0]);
    row[0] = t, row[3] = speed(random), row[4] = speed(random);
  }

  static constexpr std::size_t size = 6;
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> place{0, side}, speed{-5, 5};
  std::vector<double> rows;
};

std::size_t join_all(const World& world, double now, Interrupt& interrupt) {
  auto scene = std::make_shared<Scene>();
  scene->name = "units", scene->layout = layout, scene->rows = world.rows;
  for (std::size_t i = 0; i < world.rows.size() / World::size; ++i)
    scene->ids.push_back(static_cast<std::int64_t>(i));
  Join join({.a = scene, .now = now, .h = horizon, .wants = {.approach = false}}, interrupt);
  std::size_t pairs = 0;
  for (auto rows = join.next(); !rows.empty(); rows = join.next()) pairs += rows.size();
  return pairs;
}

/// False if the two differ.
bool compare(std::size_t units, double share, int ticks) {
  NeverInterrupt never;
  World world(units);
  const auto table = std::make_shared<MemoryTable>("units", layout, horizon);
  const auto put = [&](std::size_t i) {
    table->put(static_cast<std::int64_t>(i), std::span(world.at(i), World::size));
  };
  for (std::size_t i = 0; i < units; ++i) put(i);
  MemoryWatch watch;
  WatchState state{{.tbl = "units", .horizon = horizon, .manual = true}};
  double of_puts = 0, of_updates = 0, of_joins = 0;
  std::size_t puts = 0;
  for (int tick = 0; tick <= ticks; ++tick) {
    const double now = tick / 20.0;
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < units; ++i)
      if (static_cast<double>(world.random() % 1000000) < share * 1e6)
        changed.push_back(i), world.turn(i, now);
    const double start = cpu_seconds();
    for (const std::size_t i : changed) put(i);
    const double stored = cpu_seconds();
    state.requested_clock = now;
    PairUpdate update({table}, state, watch, {never});
    if (const auto after = update.run()) state = *after;
    table->commit();
    watch.take_log();
    const double updated = cpu_seconds();
    const std::size_t joined = join_all(world, now, never);
    const double end = cpu_seconds();
    std::size_t reported = 0;
    for (const auto& [ids, row] : watch.rows()) reported += row.is_reported();
    if (reported != joined) {
      std::printf("tick %d: %zu pairs of the watch, %zu of the join\n", tick, reported, joined);
      return false;
    }
    if (tick == 0) continue;  // the first one builds everything
    of_puts += stored - start, of_updates += updated - stored, of_joins += end - updated;
    puts += changed.size();
  }
  const double per_tick = 1e6 / ticks;
  std::printf("%7zu %7.2f %% %9.0f %9.0f %9.0f %12.2f\n", units, 100 * share, of_puts * per_tick,
              (of_puts + of_updates) * per_tick, of_joins * per_tick,
              puts ? 1e6 * of_puts / static_cast<double>(puts) : 0);
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  const bool quick = count > 1 && std::strcmp(arguments[1], "--quick") == 0;
  std::printf("microseconds of CPU time per tick\n%7s %9s %9s %9s %9s %12s\n", "units", "changed", "puts",
              "watch", "join", "us per put");
  for (const std::size_t units : {std::size_t{5000}, std::size_t{50000}})
    for (const double share : {0.001, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2})
      if (!compare(units, share, quick ? 20 : 200)) return 1;
}
