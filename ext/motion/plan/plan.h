// Plan of one mover: legs that follow each other in time, or the knots between straight legs.
//
//   Plan plan{.kind = PlanKind::knots, .axes = 2};
//   plan.knots = {{0, {0, 0}}, {5, {10, 0}}, {9, {10, 0}}};            // drives for 5 s, then waits for 4 s
//   for (const Leg& leg : legs_of(plan)) use(leg.t, leg.v);            // plan_legs.h
//
// A mover is the union of its legs. Each leg is a motion with a closed life [t, until], as an object of a table
// is; at a joint of two legs both exist. Positions have up to three axes; unused axes are 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace foresee {

/// The largest number of legs that a table or a function accepts; plan_cut alone reads longer plans.
inline constexpr std::size_t max_plan_legs = 1 << 20;

/// The last time of a plan that never ends.
inline constexpr double no_end = std::numeric_limits<double>::infinity();

/// Position and time of a mover, between two legs.
struct Knot {
  double t = 0;  ///< infinite for the last knot of a plan that rests permanently
  std::array<double, 3> x{};

  friend bool operator==(const Knot&, const Knot&) = default;
};

/// At time s of [t, until] the position is x + v (s - t) + a (s - t)^2 / 2.
struct Leg {
  double t = 0, until = no_end;
  std::array<double, 3> x{}, v{}, a{};

  friend bool operator==(const Leg&, const Leg&) = default;
};

/// A closed interval of times at which legs may exist.
struct LegTimes {
  double from = -no_end, until = no_end;

  bool meet(double t, double leg_until) const { return t <= until && from <= leg_until; }
  bool cover(const LegTimes& times) const { return from <= times.from && times.until <= until; }
};

/// What a plan is written in; the values are those of the blob (packed_legs.h).
enum class PlanKind : std::uint8_t {
  knots,        ///< straight legs, each from one knot to the next of its part
  uniform,      ///< legs with velocities
  accelerated,  ///< legs with velocities and accelerations
};

struct Plan {
  PlanKind kind = PlanKind::knots;
  int axes = 2;
  std::vector<Knot> knots = {};  ///< PlanKind::knots
  std::vector<std::size_t> part_starts = {
      0};                      ///< first knot of each part, ascending; between parts is a gap or jump
  std::vector<Leg> legs = {};  ///< the other kinds

  std::size_t parts() const { return part_starts.size(); }
  /// One past the last knot of a part.
  std::size_t part_end(std::size_t part) const {
    return part + 1 < parts() ? part_starts[part + 1] : knots.size();
  }

  friend bool operator==(const Plan&, const Plan&) = default;
};

}  // namespace foresee
