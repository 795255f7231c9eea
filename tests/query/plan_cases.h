// Seeded tables that mix plain rows and plans, and all their legs as rows of a plain table: the reference for queries
// about movers.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "motion/plan/plan_legs.h"
#include "query/legs/mover_contacts.h"
#include "query/memory_table.h"
#include "scenes.h"

namespace foresee::testing {

struct Mover {
  std::int64_t id;
  std::vector<double> record;
  std::vector<Leg> legs;  ///< empty: a plain row
};

struct Movers {
  Layout layout;
  std::vector<Mover> all;
};

/// What numbers of a plan are: short ones touch at joints, thirds are rounded everywhere, and late times have few
/// digits left for fractions.
enum class PlanNumbers { halves, thirds, late };

inline constexpr PlanNumbers all_plan_numbers[] = {PlanNumbers::halves, PlanNumbers::thirds,
                                                   PlanNumbers::late};

inline std::vector<Layout> layouts_with_plans() {
  const auto layout = [](int axes, Law law, Shape shape, bool kinds = false) {
    return Layout{.axes = axes,
                  .law = law,
                  .shape = shape,
                  .has_t = true,
                  .has_until = true,
                  .has_category = kinds,
                  .has_mask = kinds,
                  .has_plan = true};
  };
  return {layout(1, Law::uniform, Shape::point),   layout(2, Law::uniform, Shape::ball, true),
          layout(2, Law::accelerated, Shape::box), layout(2, Law::uniform, Shape::point),
          layout(3, Law::uniform, Shape::box),     layout(3, Law::accelerated, Shape::cylinder, true)};
}

/// Plans with stops, gaps and jumps at the times of others; some are cut, and some last permanently.
class PlanMaker {
 public:
  PlanMaker(const Layout& layout, PlanNumbers numbers, std::uint64_t seed)
      : layout_(layout), at_(record_offsets(layout)), numbers_(numbers), random(seed) {}

  double number(int lower, int upper) {
    const auto whole = static_cast<double>(
        lower + static_cast<int>(random.below(static_cast<std::uint64_t>(upper - lower + 1))));
    return whole / (numbers_ == PlanNumbers::halves ? 2 : 3);
  }

  double time(int lower, int upper) {
    return number(lower, upper) + (numbers_ == PlanNumbers::late ? 1.7e9 : 0);
  }

  std::vector<Leg> legs() {
    std::vector<Leg> legs;
    double t = time(-6, 24);
    std::array<double, 3> x = place();
    const std::uint64_t count = random.below(5) == 0 ? 20 + random.below(30) : 1 + random.below(6);
    for (std::uint64_t i = 0; i < count; ++i) {
      Leg leg{.t = t, .until = t + number(1, 5), .x = x, .v = {}, .a = {}};
      const std::array<double, 3> to = random.below(4) ? place() : x;
      const bool bent = layout_.law == Law::accelerated && random.below(2);
      for (std::size_t j = 0; j < static_cast<std::size_t>(layout_.axes); ++j) {
        leg.v[j] = velocity_between(x[j], to[j], leg.t, leg.until);
        if (bent) leg.a[j] = number(-3, 3), leg.v[j] -= leg.a[j] * (leg.until - leg.t) / 2;
      }
      legs.push_back(leg);
      t = leg.until, x = to;
      if (random.below(6) == 0) t += number(0, 5);  // a gap
      if (random.below(6) == 0) x = place();        // a jump
    }
    if (random.below(5) == 0) legs.push_back({.t = t, .x = x, .v = {}, .a = {}});
    return legs;
  }

  /// `plain`: without a plan.
  Mover mover(std::int64_t id, bool plain) {
    Mover mover{id, std::vector<double>(static_cast<std::size_t>(at_.size)), legs()};
    if (plain) mover.legs.resize(1);
    const Leg& first = mover.legs[0];
    double* const record = mover.record.data();
    record[at_.t] = first.t, record[at_.until] = plain ? first.until : mover.legs.back().until;
    if (random.below(5) == 0)  // cut, perhaps at a joint
      record[at_.until] =
          random.below(2) ? mover.legs[random.below(mover.legs.size())].until : first.t + number(0, 9);
    std::copy_n(first.x.begin(), layout_.axes, record + at_.x);
    std::copy_n(first.v.begin(), layout_.axes, record + at_.v);
    if (at_.a != Offsets::absent) std::copy_n(first.a.begin(), layout_.axes, record + at_.a);
    for (const int place : {at_.r, at_.hz})
      if (place != Offsets::absent) record[place] = number(0, 3);
    if (at_.half != Offsets::absent)
      for (int axis = 0; axis < layout_.axes; ++axis) record[at_.half + axis] = number(0, 3);
    if (at_.category != Offsets::absent) record[at_.category] = static_cast<double>(1 + random.below(7));
    if (at_.mask != Offsets::absent) record[at_.mask] = static_cast<double>(1 + random.below(7));
    if (plain) mover.legs.clear();
    return mover;
  }

  std::array<double, 3> place() {
    std::array<double, 3> x{};
    for (std::size_t j = 0; j < static_cast<std::size_t>(layout_.axes); ++j) x[j] = number(-16, 16);
    return x;
  }

 private:
  Layout layout_;
  Offsets at_;
  PlanNumbers numbers_;

 public:
  Random random;
};

inline Movers random_movers(const Layout& layout, PlanNumbers numbers, std::size_t count,
                            std::uint64_t seed) {
  PlanMaker maker(layout, numbers, seed);
  Movers movers{layout, {}};
  for (std::size_t i = 0; i < count; ++i)
    movers.all.push_back(
        maker.mover(static_cast<std::int64_t>(1 + i * 7 % count), maker.random.below(3) == 0));
  return movers;
}

inline std::shared_ptr<MemoryTable> table_of(const Movers& movers, const std::string& name = "robots") {
  auto table = std::make_shared<MemoryTable>(name, movers.layout);
  for (const Mover& mover : movers.all) table->put(mover.id, mover.record, mover.legs);
  return table;
}

/// The rows of one mover in a plain table: its legs, cut at its until.
inline Scene legs_as_rows(const Layout& layout, const Mover& mover) {
  Scene scene;
  scene.layout = layout, scene.layout.has_plan = false;
  const Offsets at = row_offsets(scene.layout), stored = record_offsets(layout);
  const double end = mover.record[static_cast<std::size_t>(stored.until)];
  std::vector<double> row(mover.record.begin(), mover.record.begin() + at.size);
  const auto add = [&] {
    scene.ids.push_back(mover.id);
    scene.rows.insert(scene.rows.end(), row.begin(), row.end());
  };
  if (mover.legs.empty()) add();
  for (const Leg& leg : mover.legs) {
    if (end < leg.t) continue;
    row[static_cast<std::size_t>(at.t)] = leg.t;
    row[static_cast<std::size_t>(at.until)] = std::min(end, leg.until);
    for (std::size_t j = 0; j < static_cast<std::size_t>(layout.axes); ++j) {
      row[static_cast<std::size_t>(at.x) + j] = leg.x[j], row[static_cast<std::size_t>(at.v) + j] = leg.v[j];
      if (at.a != Offsets::absent) row[static_cast<std::size_t>(at.a) + j] = leg.a[j];
    }
    add();
  }
  return scene;
}

/// The plain contacts of two movers: of all pairs of their legs, merged by rule 3.
inline std::vector<ContactTimes> plain_contacts(const Bodies& legs_a, const Bodies& legs_b,
                                                const Horizon& horizon, double within) {
  const auto contact = make_contact(legs_a, legs_b, {.horizon = horizon, .within = within}, "a", "b");
  std::vector<Pair> pairs, hits;
  for (std::uint32_t i = 0; i < legs_a.count; ++i)
    for (std::uint32_t k = 0; k < legs_b.count; ++k) pairs.push_back({i, k});
  std::vector<ContactTimes> times;
  contact->all_contacts(pairs, hits, times);
  std::vector<LegContact> contacts;
  for (std::size_t i = 0; i < hits.size(); ++i) contacts.push_back({hits[i].a, hits[i].b, times[i]});
  return mover_contacts(contacts);
}

/// The same table as every kind of target: all legs, those of the horizon, and both trees.
inline std::vector<SearchTarget> targets_of(MemoryTable& table, const Horizon& horizon) {
  const LegTimes during{horizon.now, std::nextafter(horizon.now + horizon.h, no_end)};
  return {{table.name(), table.all(), nullptr},
          {table.name(), table.all({.times = during}), nullptr},
          {table.name(), nullptr, table.tree(), table.chunks()}};
}

}  // namespace foresee::testing
