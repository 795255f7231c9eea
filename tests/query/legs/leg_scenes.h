// Random scenes of movers with legs, and the plain answer of a join: all pairs of movers, all pairs of their legs.
#pragma once

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "motion/plan/plan_legs.h"
#include "numbers/rationals.h"
#include "query/join_cases.h"
#include "query/legs/mover_contacts.h"

namespace foresee::testing {

/// Movers on a few places of a small world, so that legs meet at joints, jumps, gaps and ends.
struct LegWorld {
  Layout layout{.axes = 2,
                .law = Law::uniform,
                .shape = Shape::ball,
                .has_t = true,
                .has_until = true,
                .has_plan = true};
  int movers = 12;
  int max_legs = 8;
  bool thirds = false;  ///< times and places that are no short numbers
  double side = 6;      ///< of the world
  int first_id = 1;
};

inline double number_of(judge::Inputs& inputs, double limit, bool thirds) {
  const int steps = static_cast<int>(2 * limit);
  return inputs.between(-steps, steps) / (thirds ? 6.0 : 4.0);
}

inline std::vector<Leg> random_legs(const LegWorld& world, judge::Inputs& inputs) {
  std::vector<Leg> legs;
  std::array<double, 3> place{};
  const auto move = [&] {
    for (int axis = 0; axis < world.layout.axes; ++axis)
      place[static_cast<std::size_t>(axis)] = number_of(inputs, world.side, world.thirds);
  };
  move();
  double t = inputs.between(-4, 8) / (world.thirds ? 3.0 : 2.0);
  for (int i = inputs.between(1, world.max_legs); i > 0; --i) {
    Leg leg{.t = t, .x = place};
    leg.until = t + (world.thirds ? inputs.between(1, 6) / 3.0 : std::ldexp(1, inputs.between(-1, 2)));
    const auto from = place;
    const bool rests = inputs.one_in(4);
    if (!rests) move();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      leg.v[axis] = velocity_between(from[axis], place[axis], leg.t, leg.until);
      if (world.layout.law == Law::accelerated && axis < static_cast<std::size_t>(world.layout.axes) &&
          inputs.one_in(2)) {  // bent, through the same two places
        const double a = inputs.between(-2, 2);
        leg.a[axis] = a, leg.v[axis] -= a * (leg.until - leg.t) / 2;
      }
    }
    if (rests && i == 1 && inputs.one_in(2)) leg.until = no_end;
    legs.push_back(leg);
    t = leg.until;
    if (inputs.one_in(5)) move();                           // a jump
    if (inputs.one_in(5)) t += inputs.between(1, 4) / 2.0;  // a gap
  }
  return legs;
}

/// One object in four has no plan.
inline std::shared_ptr<const Scene> random_movers(const LegWorld& world, judge::Inputs& inputs,
                                                  const std::string& name = "robots") {
  auto scene = std::make_shared<Scene>();
  scene->name = name, scene->layout = world.layout;
  const Offsets at = record_offsets(world.layout);
  for (int mover = 0; mover < world.movers; ++mover) {
    std::vector<double> record(static_cast<std::size_t>(at.size));
    const auto set = [&](int place, double value) {
      if (place != Offsets::absent) record[static_cast<std::size_t>(place)] = value;
    };
    std::vector<Leg> legs = random_legs(world, inputs);
    const bool has_plan = world.layout.has_plan && !inputs.one_in(4);
    const Leg& leg = legs[0];
    set(at.t, leg.t);
    set(at.until, has_plan ? (inputs.one_in(6) ? legs.back().t : no_end) : leg.until);
    for (int axis = 0; axis < world.layout.axes; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      set(at.x + axis, leg.x[j]);
      if (at.v != Offsets::absent) set(at.v + axis, leg.v[j]);
      if (at.a != Offsets::absent) set(at.a + axis, leg.a[j]);
      if (at.half != Offsets::absent) set(at.half + axis, inputs.between(0, 4) * 0.25);
    }
    set(at.r, inputs.between(0, 4) * 0.25), set(at.hz, inputs.between(0, 4) * 0.25);
    set(at.category, 1 << inputs.below(2)), set(at.mask, 1 + inputs.below(3));
    set(at.plan, has_plan ? 1 : 0), set(at.chunks, has_plan ? 1 : 0);
    const std::int64_t id = world.first_id + (mover * 7) % world.movers;
    scene->add(id, record.data(), has_plan ? std::span<const Leg>(legs) : std::span<const Leg>());
  }
  return scene;
}

/// Rows of the objects of a scene.
struct RowRange {
  std::uint32_t first, last;
};
inline std::vector<RowRange> movers_of(const Scene& scene) {
  std::vector<RowRange> movers;
  for (std::uint32_t row = 0; row < scene.size(); ++row)
    if (movers.empty() || scene.ids[movers.back().first] != scene.ids[row])
      movers.push_back({row, row + 1});
    else
      movers.back().last = row + 1;
  return movers;
}

/// Whether two rows exist together at some time of the horizon, in rational numbers.
inline bool exist_together(const Scene& a, std::uint32_t row_a, const Scene& b, std::uint32_t row_b,
                           const Horizon& horizon) {
  judge::Rational start = judge::rational(horizon.now), end = start + judge::rational(horizon.h);
  for (const auto& [scene, row] : {std::pair(&a, row_a), std::pair(&b, row_b)}) {
    const Bodies bodies = scene->bodies();
    const double t = value_or(bodies.row(row), bodies.at.t, 0);
    const double until = value_or(bodies.row(row), bodies.at.until, no_end);
    start = std::max(start, judge::rational(t));
    if (until < no_end) end = std::min(end, judge::rational(until));
  }
  return start <= end;
}

/// In order of a, b, t, t_end.
inline void sort_rows(std::vector<JoinRow>& rows) {
  std::sort(rows.begin(), rows.end(), [](const JoinRow& l, const JoinRow& r) {
    return std::tie(l.a, l.b, l.contact.t, l.contact.t_end) <
           std::tie(r.a, r.b, r.contact.t, r.contact.t_end);
  });
}

/// The contacts of two movers, from all pairs of their legs.
inline std::vector<ContactTimes> plain_contacts(const JoinQuestion& question, Contact& contact,
                                                const std::vector<Pair>& pairs) {
  std::vector<Pair> hits;
  std::vector<ContactTimes> times;
  if (has_bent_paths(question))
    contact.all_contacts(pairs, hits, times);
  else
    contact.first_contacts(pairs, TimesWanted::both, hits, times);
  std::vector<LegContact> legs;
  for (std::size_t i = 0; i < hits.size(); ++i) legs.push_back({hits[i].a, hits[i].b, times[i]});
  std::vector<ContactTimes> found = mover_contacts(legs);
  if (!question.all_contacts && found.size() > 1) found.resize(1);
  return found;
}

/// The closest approach of all pairs of legs that exist together.
inline ClosestApproach plain_approach(const JoinQuestion& question, Contact& contact,
                                      const std::vector<Pair>& pairs) {
  const Scene &a = *question.a, &b = question.b ? *question.b : a;
  ClosestApproach nearest{};
  nearest.d = HUGE_VAL;
  for (const Pair& pair : pairs) {
    if (!exist_together(a, pair.a, b, pair.b, {question.now, question.h})) continue;
    ClosestApproach one;
    contact.closest_approach({&pair, 1}, {&one, 1});
    if (std::tie(one.d, one.t, one.dt) < std::tie(nearest.d, nearest.t, nearest.dt)) nearest = one;
  }
  return nearest;
}

/// The rows of a join by their definition, in that order. Closest approaches only where they are wanted.
inline std::vector<JoinRow> plain_rows(const JoinQuestion& question) {
  const Scene &a = *question.a, &b = question.b ? *question.b : a;
  const auto contact = contact_of(question);
  const bool one = &a == &b;
  std::vector<JoinRow> rows;
  for (const RowRange& of_a : movers_of(a))
    for (const RowRange& of_b : movers_of(b)) {
      const std::int64_t id_a = a.ids[of_a.first], id_b = b.ids[of_b.first];
      if ((one && id_a == id_b) || (!question.b && id_a > id_b)) continue;
      if ((question.only_a && id_a != *question.only_a) || (question.only_b && id_b != *question.only_b))
        continue;
      std::vector<Pair> pairs;
      for (std::uint32_t i = of_a.first; i < of_a.last; ++i)
        for (std::uint32_t k = of_b.first; k < of_b.last; ++k) pairs.push_back({i, k});
      const std::vector<ContactTimes> found = plain_contacts(question, *contact, pairs);
      JoinRow row;
      row.a = id_a, row.b = id_b, row.approach = {0, 0, 0};
      if (question.wants.approach && !found.empty()) row.approach = plain_approach(question, *contact, pairs);
      for (const ContactTimes& times : found) {
        if (!question.queried_t.holds(times.t) || !question.queried_dt.holds(times.dt)) continue;
        row.contact = times;
        if (!rows.empty() && rows.back().a == row.a && rows.back().b == row.b &&
            rows.back().contact.t == times.t && rows.back().contact.t_end == times.t_end) {
          rows.back().contact.dt = std::min(rows.back().contact.dt, times.dt);
          rows.back().contact.dt_end = std::max(rows.back().contact.dt_end, times.dt_end);
          continue;
        }
        rows.push_back(row);
      }
    }
  sort_rows(rows);
  return rows;
}

/// All rows of a join in that order; columns that are not wanted are 0.
inline std::vector<JoinRow> sorted_rows(const JoinQuestion& question) {
  std::vector<JoinRow> rows = rows_in_order(question);
  for (JoinRow& row : rows) {
    if (!question.wants.ends) row.contact.t_end = row.contact.dt_end = 0;
    if (!question.wants.approach) row.approach = {0, 0, 0};
  }
  sort_rows(rows);
  return rows;
}

}  // namespace foresee::testing
