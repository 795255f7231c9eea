// The join of plans without SQL, beside the same legs as rows: random way-points in native memory, one thread, warm.
//
//   bench_core_plans [--quick]
//
//   One mover per 100 m², legs of 10 s at 0.5 to 1.5 m/s, r = 1 m, seed 5:
//     10,000 movers of 100 legs, h = 900;  100,000 movers of 10 legs, h = 90;  100,000 of one leg, h = 10.
//   --quick: a tenth of the movers.
//
// "legs as rows" gives each leg an id of its own. Pairs of legs of one mover are rows too, and a pair of movers has a
// row for each pair of legs. For plans of one leg these are plain rows. Prints nanoseconds of processor time per leg
// alive, for starts alone and with ends: medians, and ratios within a repetition. Fails if the movers that meet, or
// their first times, differ.
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "base/float_environment.h"
#include "measure.h"
#include "program.h"
#include "query/join/join.h"

namespace foresee::bench {
namespace {

NeverInterrupt never;

struct World {
  const char* name;
  int movers, legs;
  double h;
};

constexpr Layout plans{
    .axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true, .has_until = true, .has_plan = true};

std::vector<std::vector<Leg>> random_plans(const World& world) {
  constexpr double duration = 10;
  const double side = std::sqrt(100.0 * world.movers);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<std::vector<Leg>> all;
  for (int mover = 0; mover < world.movers; ++mover) {
    std::array<double, 3> x{unit(random) * side, unit(random) * side, 0};
    double t = world.legs == 1 ? 0 : -unit(random) * duration;
    std::vector<Leg>& legs = all.emplace_back();
    for (int i = 0; i < world.legs; ++i, t += duration) {
      const double course = 2 * 3.141592653589793 * unit(random), speed = 0.5 + unit(random);
      Leg leg{
          .t = t, .until = t + duration, .x = x, .v = {speed * std::cos(course), speed * std::sin(course)}};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double end = x[axis] + leg.v[axis] * duration;
        if (end < 0 || end > side) leg.v[axis] = -leg.v[axis];
        x[axis] += leg.v[axis] * duration;
      }
      legs.push_back(leg);
    }
  }
  return all;
}

/// One object per mover, or per leg: the legs of mover m then have the ids m * 1000 + number.
std::shared_ptr<const Scene> scene_of(const std::vector<std::vector<Leg>>& movers, bool legs_are_rows) {
  auto scene = std::make_shared<Scene>();
  scene->name = "movers", scene->layout = plans, scene->layout.has_plan = !legs_are_rows;
  const Offsets at = record_offsets(scene->layout);
  std::vector<double> record(static_cast<std::size_t>(at.size));
  const auto set = [&](int place, double value) { record[static_cast<std::size_t>(place)] = value; };
  for (std::size_t mover = 0; mover < movers.size(); ++mover) {
    set(at.r, 1);
    if (!legs_are_rows) {
      set(at.until, no_end), set(at.plan, 1), set(at.chunks, 1);
      scene->add(static_cast<std::int64_t>(mover), record.data(), movers[mover]);
      continue;
    }
    for (std::size_t i = 0; i < movers[mover].size(); ++i) {
      const Leg& leg = movers[mover][i];
      set(at.t, leg.t), set(at.until, leg.until);
      for (int axis = 0; axis < 2; ++axis) {
        const auto j = static_cast<std::size_t>(axis);
        set(at.x + axis, leg.x[j]), set(at.v + axis, leg.v[j]);
      }
      scene->add(static_cast<std::int64_t>(mover * 1000 + i), record.data());
    }
  }
  return scene;
}

using Firsts = std::map<std::pair<std::int64_t, std::int64_t>, double>;

/// First times of pairs of movers.
struct Answer {
  double seconds = 0;
  std::size_t rows = 0;
  Firsts firsts = {};
};

Answer join(const std::shared_ptr<const Scene>& scene, double h, bool ends, bool keeps,
            const std::shared_ptr<GridSpace>& space) {
  const std::int64_t divisor = scene->layout.has_plan ? 1 : 1000;
  Answer answer;
  answer.seconds = seconds_of([&] {
    Join join({.a = scene, .h = h, .wants = {.ends = ends, .approach = false}, .space = space}, never);
    for (auto rows = join.next(); !rows.empty(); rows = join.next()) {
      answer.rows += rows.size();
      if (!keeps) continue;
      for (const JoinRow& row : rows) {
        const std::pair movers{row.a / divisor, row.b / divisor};
        if (movers.first == movers.second) continue;
        const auto [first, is_new] = answer.firsts.emplace(movers, row.contact.t);
        if (!is_new) first->second = std::min(first->second, row.contact.t);
      }
    }
  });
  return answer;
}

bool compare(const World& world, int repetitions) {
  const auto movers = random_plans(world);
  const auto rows = scene_of(movers, true), with_plans = scene_of(movers, false);
  std::size_t alive = 0;
  for (const auto& legs : movers)
    for (const Leg& leg : legs) alive += leg.t <= world.h && leg.until >= 0;
  const auto space = std::make_shared<GridSpace>();
  const Answer expected = join(rows, world.h, false, true, space);
  const Answer found = join(with_plans, world.h, false, true, space);
  if (found.firsts != expected.firsts) {
    std::printf("%s: %zu pairs of movers, %zu among legs as rows, or their times differ\n", world.name,
                found.firsts.size(), expected.firsts.size());
    return false;
  }
  std::printf("%s: %zu legs alive, %zu pairs of movers, %zu rows of legs\n", world.name, alive, found.rows,
              expected.rows);
  for (const bool ends : {false, true}) {
    std::vector<double> of_rows, of_plans, ratios;
    for (int i = 0; i < repetitions; ++i) {
      const double a = join(rows, world.h, ends, false, space).seconds;
      const double b = join(with_plans, world.h, ends, false, space).seconds;
      of_rows.push_back(a * 1e9 / static_cast<double>(alive)),
          of_plans.push_back(b * 1e9 / static_cast<double>(alive));
      ratios.push_back(b / a);
    }
    std::printf("  %-10s legs as rows %6.0f ns a leg, plans %6.0f ns: %.2f\n", ends ? "with ends" : "starts",
                median(of_rows), median(of_plans), median(ratios));
  }
  return true;
}

int main_of(const Options& options) {
  const FloatEnvironment environment;
  const bool quick = options.has("--quick");
  const int part = quick ? 10 : 1;
  const World worlds[] = {{"10^4 movers of 100 legs, h = 900", 10000 / part, 100, 900},
                          {"10^5 movers of 10 legs, h = 90", 100000 / part, 10, 90},
                          {"10^5 movers of one leg, h = 10", 100000 / part, 1, 10}};
  for (const World& world : worlds)
    if (!compare(world, quick ? 3 : 5)) return 1;
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
