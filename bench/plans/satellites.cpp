// --satellites: conjunctions of circular orbits, as plans of accelerated legs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "measure.h"
#include "motion/plan/packed_legs.h"
#include "plans/modes.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

constexpr double pi = 3.141592653589793, leg_seconds_of_orbit = 60;

struct Orbit {
  double radius, inclination, node, phase;

  std::array<double, 3> position(double time) const {
    const double u = phase + std::sqrt(3.986004418e14 / (radius * radius * radius)) * time;
    const double c = std::cos(u), s = std::sin(u), ci = std::cos(inclination);
    return {radius * (std::cos(node) * c - std::sin(node) * s * ci),
            radius * (std::sin(node) * c + std::cos(node) * s * ci), radius * s * std::sin(inclination)};
  }
};

/// Low orbits between 500 and 600 km, at the inclinations of today's constellations.
std::vector<Orbit> make_orbits(int count) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const double inclinations[] = {43, 53, 70, 97.6};
  std::vector<Orbit> orbits;
  for (int i = 0; i < count; ++i)
    orbits.push_back({6378137 + 500e3 + 100e3 * unit(random), inclinations[i % 4] * pi / 180,
                      2 * pi * unit(random), 2 * pi * unit(random)});
  return orbits;
}

/// Quadratic legs through the positions at Chebyshev's three points of each minute.
Plan plan_of(const Orbit& orbit, int legs) {
  Plan plan{.kind = PlanKind::accelerated, .axes = 3};
  const double half = leg_seconds_of_orbit / 2, d = half * std::sqrt(3) / 2;
  for (int i = 0; i < legs; ++i) {
    const double t = leg_seconds_of_orbit * i;
    const auto before = orbit.position(t + half - d), middle = orbit.position(t + half),
               after = orbit.position(t + half + d);
    Leg leg{.t = t, .until = t + leg_seconds_of_orbit};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double v = (after[axis] - before[axis]) / (2 * d),
                   a = (after[axis] - 2 * middle[axis] + before[axis]) / (d * d);
      leg.x[axis] = middle[axis] - half * v + half * half / 2 * a, leg.v[axis] = v - half * a,
      leg.a[axis] = a;
    }
    plan.legs.push_back(leg);
  }
  return plan;
}

void load(Database& db, const std::vector<Orbit>& orbits, int legs) {
  db.run(
      "CREATE VIRTUAL TABLE satellites USING moving_objects(id, x, y, z, vx, vy, vz, ax, ay, az, plan, r)");
  Statement insert(db, "INSERT INTO satellites(id, plan, r) VALUES(?, ?, 15)");
  NeverInterrupt never;
  db.run("BEGIN");
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const std::vector<std::byte> blob = encode_plan(plan_of(orbits[i], legs), never);
    insert.bind(1, static_cast<std::int64_t>(i));
    sqlite3_bind_blob(insert.handle(), 2, blob.data(), static_cast<int>(blob.size()), SQLITE_TRANSIENT);
    insert.step();
  }
  db.run("COMMIT");
}

/// The rows of some satellites by every pair of legs.
void check_some(Database& db, const std::string& horizon) {
  for (const int id : {0, 7, 42}) {
    const std::string queried =
        " FROM predictive_join WHERE tbl = 'satellites' AND within = 2970 AND now = 0 AND h = " + horizon +
        " AND a = " + std::to_string(id);
    Statement differing(db, "SELECT count(*) FROM (SELECT b, t, t_end" + queried +
                                " EXCEPT SELECT b, t, t_end" + queried + " AND method = 'scan')");
    differing.step();
    if (differing.integer(0) != 0) throw Error("the plain answer has other pairs");
  }
}

}  // namespace

void measure_satellites(const Options& given) {
  Options options = given;
  const bool quick = options.has("--quick");
  const int count = quick ? 3000 : 30000;
  const double hours = std::stod(options.value("--hours").value_or("2"));
  const int legs = static_cast<int>(hours * 3600 / leg_seconds_of_orbit);
  const std::string horizon = std::to_string(hours * 3600);
  run_in_child([&] {
    Database db(":memory:");
    register_foresee(db);
    const std::vector<Orbit> orbits = make_orbits(count);
    const double loading = seconds_of([&] { load(db, orbits, legs); });
    Resident::forget_peak();
    const double before = Resident::now();
    Statement join(
        db,
        "SELECT a, b, t FROM predictive_join WHERE tbl = 'satellites' AND within = 2970 AND now = 0 "
        "AND h = " +
            horizon);
    std::int64_t rows = 0;
    const double seconds = seconds_of([&] { rows = join.step_all(); });
    const double all_legs = static_cast<double>(count) * legs;
    std::printf(
        "%d orbits, %g h, %.0f legs: load %.1f s (%.0f ns per leg), join %.2f s (%.0f ns per leg), %lld "
        "pairs, %.0f MB "
        "beside the table's %.0f MB\n",
        count, hours, all_legs, loading, 1e9 * loading / all_legs, seconds, 1e9 * seconds / all_legs,
        static_cast<long long>(rows), (Resident::peak() - before) / 1e6, before / 1e6);
    check_some(db, horizon);
  });
}

}  // namespace foresee::bench
