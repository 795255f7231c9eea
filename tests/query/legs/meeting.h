// Two movers that may meet: traps at joints, jumps, gaps and ends, random paths, and the contacts of all pairs of legs.
// The contacts are the engine's; legs are rows of a table.
#pragma once

#include <ostream>
#include <vector>

#include "motion/plan/plan_legs.h"
#include "numbers/rationals.h"
#include "query/legs/mover_contacts.h"

namespace foresee::leg_oracle {

/// Two movers, a horizon, and the distance per axis that counts as touching.
struct Meeting {
  std::vector<Leg> a, b;
  double now = 0, h = 0, reach = 1;
};

inline std::ostream& operator<<(std::ostream& out, const Meeting& meeting) {
  out << std::hexfloat << "now " << meeting.now << " h " << meeting.h << " reach " << meeting.reach;
  for (const auto* legs : {&meeting.a, &meeting.b}) {
    out << "\nmover";
    for (const Leg& leg : *legs)
      out << "\n  " << leg.t << " to " << leg.until << ": " << leg.x[0] << ' ' << leg.x[1] << ", v "
          << leg.v[0] << ' ' << leg.v[1] << ", a " << leg.a[0] << ' ' << leg.a[1];
  }
  return out;
}

inline std::vector<Leg> legs_through(std::vector<Knot> knots, std::vector<std::size_t> part_starts = {0}) {
  const Plan plan{
      .kind = PlanKind::knots, .axes = 2, .knots = std::move(knots), .part_starts = std::move(part_starts)};
  check_plan(plan);
  return legs_of(plan);
}

/// A mover that rests permanently.
inline std::vector<Leg> resting_at(double x, double y) {
  return {{.t = 0, .x = {x, y, 0}}};
}

struct Trap {
  const char* name;
  Meeting meeting;
  std::vector<std::pair<double, double>> contacts;  ///< from t to t_end
};

inline std::vector<Trap> traps() {
  const std::vector<Leg> path = legs_through({{0, {0, 5}}, {4, {4, 1}}, {8, {8, 5}}});
  const std::vector<Leg> gaps = legs_through(
      {{0, {0, 0}}, {2, {0, 0}}, {6, {0, 0}}, {6.5, {0, 0}}, {6.5, {9, 9}}, {8, {9, 9}}}, {0, 2, 4});
  return {{"at a joint alone", {path, resting_at(4, 0), 0, 10}, {{4, 4}}},
          {"the horizon starts at a joint", {path, resting_at(4, 0), 4, 10}, {{4, 4}}},
          {"the horizon ends at a joint", {path, resting_at(4, 0), 0, 4}, {{4, 4}}},
          {"the horizon is a joint", {path, resting_at(4, 0), 4, 0}, {{4, 4}}},
          {"the horizon starts after the joint", {path, resting_at(4, 0), 4.5, 10}, {}},
          {"through joints of both at once",
           {legs_through({{0, {0, 0}}, {4, {4, 0}}, {8, {4, 4}}}),
            legs_through({{0, {8, 0}}, {4, {5, 0}}, {8, {5, 4}}}), 0, 8},
           {{4, 8}}},
          {"two exchange their places by jumps",
           {legs_through({{0, {0, 0}}, {4, {0, 0}}, {4, {9, 9}}, {8, {9, 9}}}, {0, 2}),
            legs_through({{0, {9, 9}}, {4, {9, 9}}, {4, {0, 0}}, {8, {0, 0}}}, {0, 2}), 0, 8},
           {{4, 4}}},
          {"one ends as the other starts",
           {legs_through({{0, {0, 0}}, {4, {4, 0}}}), legs_through({{4, {4, 0}}, {9, {9, 9}}}), 0, 20},
           {{4, 4}}},
          {"a horizon wholly in a gap", {gaps, resting_at(0, 0), 3, 2}, {}},
          {"before and after a gap", {gaps, resting_at(0, 0), 0, 20}, {{0, 2}, {6, 6.5}}},
          {"no horizon, before a jump", {gaps, resting_at(0, 0), 6.5, 0}, {{6.5, 6.5}}},
          {"no horizon, after a jump", {gaps, resting_at(9, 9), 6.5, 0}, {{6.5, 6.5}}},
          {"a stop without end",
           {legs_through({{0, {0, 0}}, {8, {8, 0}}, {no_end, {8, 0}}}), resting_at(8, 1), 2, 1000},
           {{7, 1002}}}};
}

/// Two that move along each other through a hundred joints; they touch from 0.5 to 100.
inline Meeting zigzags() {
  std::vector<Knot> a, b;
  for (int i = 0; i <= 100; ++i) {
    const double t = i, y = i % 2;
    a.push_back({t, {t, y}}), b.push_back({t + 0.5, {t + 0.5, 0.5 - y}});
  }
  return {legs_through(a), legs_through(b), 0, 200};
}

/// A path with stops, jumps and gaps. `thirds`: of times and places that are no short numbers.
inline std::vector<Leg> random_path(judge::Inputs& inputs, bool thirds) {
  std::vector<Knot> knots;
  std::vector<std::size_t> parts{0};
  double t = inputs.between(-4, 4) * 0.5;
  for (int i = inputs.between(2, 9); i > 0; --i) {
    const double x = inputs.between(-3, 3), y = inputs.between(-3, 3);
    knots.push_back({t, {thirds ? x / 3 : x, thirds ? y / 7 : y}});
    if (i > 3 && knots.size() - parts.back() > 1 && inputs.one_in(4)) {
      parts.push_back(knots.size());
      if (inputs.one_in(2)) t += 1;
      continue;
    }
    t += thirds ? inputs.between(1, 5) / 3.0 : std::ldexp(1, inputs.between(-1, 1));
  }
  if (inputs.one_in(4)) knots.push_back({no_end, knots.back().x});
  return legs_through(knots, parts);
}

/// The contacts of all pairs of legs by the engine: legs are rows of a table.
inline std::vector<LegContact> contacts_of_legs(const Meeting& meeting) {
  const Layout layout{
      .axes = 2, .law = Law::accelerated, .shape = Shape::point, .has_t = true, .has_until = true};
  const auto rows_of = [&](const std::vector<Leg>& legs) {
    std::vector<double> rows;
    for (const Leg& leg : legs)
      rows.insert(rows.end(), {leg.t, leg.x[0], leg.x[1], leg.v[0], leg.v[1], leg.a[0], leg.a[1], leg.until});
    return rows;
  };
  // A box of this half extent and a point: the distance per axis.
  Layout boxes = layout;
  boxes.shape = Shape::box;
  const Offsets at = row_offsets(boxes);
  const std::vector<double> rows_a = rows_of(meeting.a);
  std::vector<double> rows_b(meeting.b.size() * static_cast<std::size_t>(at.size));
  for (std::size_t i = 0; i < meeting.b.size(); ++i) {
    double* row = &rows_b[i * static_cast<std::size_t>(at.size)];
    const Leg& leg = meeting.b[i];
    row[at.t] = leg.t, row[at.until] = leg.until;
    for (int j = 0; j < 2; ++j) {
      const auto axis = static_cast<std::size_t>(j);
      row[at.x + j] = leg.x[axis], row[at.v + j] = leg.v[axis], row[at.a + j] = leg.a[axis];
      row[at.half + j] = meeting.reach;
    }
  }
  const Bodies a(layout, rows_a.data(), meeting.a.size()), b(boxes, rows_b.data(), meeting.b.size());
  const auto contact = make_contact(a, b, {.horizon = {meeting.now, meeting.h}}, "a", "b");
  std::vector<Pair> pairs, hits;
  for (std::uint32_t i = 0; i < meeting.a.size(); ++i)
    for (std::uint32_t k = 0; k < meeting.b.size(); ++k) pairs.push_back({i, k});
  std::vector<ContactTimes> times;
  contact->all_contacts(pairs, hits, times);
  std::vector<LegContact> found;
  for (std::size_t i = 0; i < hits.size(); ++i) found.push_back({hits[i].a, hits[i].b, times[i]});
  return found;
}

}  // namespace foresee::leg_oracle
