// Movers between random way-points, whose legs are rows of one table and plans of another.
//
//   const Schedule schedule = make_schedule(10000, 100);        // shuffled legs; the same for the same numbers
//   load_legs(db, "legs", schedule, -1e9, 1e9, false);          // ids: mover * ids_per_mover + leg
//   load_plans(db, "movers", schedule);                         // ids: mover; the same doubles
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sql.h"

namespace foresee::bench {

struct ScheduledLeg {
  std::int64_t id;
  double t, x, y, vx, vy, until;
};

struct Schedule {
  std::vector<ScheduledLeg> legs;  ///< shuffled
  int movers, legs_of_mover;
  double side;  ///< of the square, in metres
};

constexpr std::int64_t ids_per_mover = 1000;
constexpr double leg_seconds = 10;

/// One mover per 100 m², legs of 10 s each at 0.5 to 1.5 m/s, the first of which starts within [-10, 0].
Schedule make_schedule(int movers, int legs_of_mover);

/// A table moving_objects(id, t, x, y, vx, vy, r, until) of the legs that live in [from, to], r = 1 m. Returns
/// nanoseconds of processor time per leg.
double load_legs(Database& db, const std::string& table, const Schedule& schedule, double from, double to,
                 bool one_by_one);

enum class PlanForm { blob, text };

/// A table moving_objects(id, x, y, plan, r), filled by one INSERT … SELECT from a table of plans that is ready.
/// Returns nanoseconds per leg.
double load_plans(Database& db, const std::string& table, const Schedule& schedule,
                  PlanForm form = PlanForm::blob);

/// Bytes of the pages of the database that are in use.
double used_bytes(Database& db);

}  // namespace foresee::bench
