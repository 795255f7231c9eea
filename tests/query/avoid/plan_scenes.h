// Random scenes of movers with plans, and the plain answer for one manoeuvre: its legs, each with each leg of the
// others, by exact contact.
//
//   const PlanScene scene = plan_scene(random);
//   const AvoidQuestion question = scene.question(random);
//   meets(question, legs_after(question, Manoeuvre::wait, 3))            // whether a wait of 3 touches anybody
//
// The legs of a manoeuvre are made here from its definition, not by the code under test. Places, times and sizes are
// often small whole numbers, so that movers meet at joints, jumps and ends.
#pragma once

#include <cmath>

#include "motion/plan/plan_legs.h"
#include "query/avoid/avoid_cases.h"
#include "query/avoid/own_state.h"
#include "shape/chunk_item.h"

namespace foresee::avoid_oracle {

using testing::Random;

struct PlanScene {
  std::shared_ptr<Scene> scene = std::make_shared<Scene>();
  std::vector<std::vector<double>> records;
  std::vector<std::shared_ptr<const Plan>> plans;  ///< or null
  double now = 0, h = 0, within = 0;

  /// About the object with this index.
  AvoidQuestion question(std::size_t i) const {
    AvoidQuestion question;
    const auto own = std::make_shared<Scene>();
    own->name = "robots", own->layout = scene->layout;
    own->add(static_cast<std::int64_t>(i) + 1, records[i].data(),
             plans[i] ? legs_of(*plans[i]) : std::vector<Leg>{});
    question.own_scene = own, question.record = records[i], question.plan = plans[i];
    question.others = {"robots", scene, nullptr};
    question.now = now, question.now_given = true, question.h = h, question.within = within;
    return question;
  }
};

/// Draws plans of knots with stops, jumps and gaps, and plans of legs.
class PlanMaker {
 public:
  PlanMaker(const Layout& layout, double start, Random& random)
      : layout_(layout), start_(start), random_(random) {}

  double number(double size) {
    const double drawn = random_.in(-size, size);
    return random_.below(2) ? std::round(drawn) : drawn;
  }
  std::array<double, 3> vector(double size) {
    std::array<double, 3> drawn{};
    for (int axis = 0; axis < layout_.axes; ++axis) drawn[static_cast<std::size_t>(axis)] = number(size);
    return drawn;
  }
  double time(double from, double to) {
    const double drawn = random_.in(from, to);
    return random_.below(2) ? std::round(drawn) : drawn;
  }

  Plan knots() {
    Plan plan{.kind = PlanKind::knots, .axes = layout_.axes};
    double t = start_ + time(-6, 12);
    std::array<double, 3> x = vector(12);
    for (std::uint64_t parts = 1 + random_.below(2); parts > 0; --parts) {
      if (!plan.knots.empty()) {
        plan.part_starts.push_back(plan.knots.size());
        x = vector(12);
        if (random_.below(2)) t += time(1, 4);
      }
      plan.knots.push_back({t, x});
      for (std::uint64_t legs = 1 + random_.below(4); legs > 0; --legs) {
        t += std::max(0.25, time(0, 8));
        if (random_.below(4) != 0) x = vector(12);
        plan.knots.push_back({t, x});
      }
    }
    if (random_.below(5) == 0) plan.knots.push_back({no_end, x});
    return plan;
  }

  Plan legs() {
    const bool bends = layout_.law == Law::accelerated;
    Plan plan{.kind = bends ? PlanKind::accelerated : PlanKind::uniform, .axes = layout_.axes};
    double t = start_ + time(-6, 12);
    for (std::uint64_t legs = 1 + random_.below(5); legs > 0; --legs) {
      Leg leg{t, t + time(0, 8), vector(12), vector(2), {}};
      if (bends && random_.below(2)) leg.a = vector(0.3);
      if (legs == 1 && random_.below(6) == 0) leg.until = no_end;
      if (leg.until < leg.t) leg.until = leg.t;
      plan.legs.push_back(leg);
      t = leg.until + (random_.below(2) ? 0 : time(0, 3));
      if (t < leg.until) t = leg.until;
    }
    return plan;
  }

 private:
  Layout layout_;
  double start_;
  Random& random_;
};

inline PlanScene plan_scene(Random& random, std::size_t count) {
  const Shape shapes[] = {Shape::ball, Shape::ball, Shape::box, Shape::point};
  Layout layout{.axes = static_cast<int>(1 + random.below(3)),
                .law = random.below(3) == 0 ? Law::accelerated : Law::uniform,
                .shape = shapes[random.below(4)],
                .has_t = true,
                .has_until = true,
                .has_plan = true};
  PlanScene made;
  made.scene->name = "robots", made.scene->layout = layout;
  const double start = random.below(6) == 0 ? 1.7e9 : 0;
  PlanMaker maker(layout, start, random);
  const Offsets at = record_offsets(layout);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> record(static_cast<std::size_t>(at.size));
    const bool has_plan = i == 0 ? random.below(4) != 0 : random.below(3) != 0;
    Leg first{start + maker.time(-6, 6), no_end, maker.vector(12), maker.vector(2), {}};
    if (layout.law == Law::accelerated && random.below(2)) first.a = maker.vector(0.3);
    std::vector<Leg> legs;
    if (has_plan) {
      const Plan plan = random.below(2) ? maker.knots() : maker.legs();
      legs = legs_of(plan), first = legs[0];
      made.plans.push_back(std::make_shared<const Plan>(plan));
      record[static_cast<std::size_t>(at.plan)] = record[static_cast<std::size_t>(at.chunks)] = 1;
    } else {
      made.plans.push_back(nullptr);
    }
    write_leg(at, layout.axes, first, record.data());
    record[static_cast<std::size_t>(at.until)] = random.below(3) == 0 ? first.t + maker.time(1, 25) : no_end;
    for (int axis = 0; axis < layout.axes; ++axis) {
      if (at.half != Offsets::absent)
        record[static_cast<std::size_t>(at.half + axis)] = std::abs(maker.number(1.5));
    }
    if (at.r != Offsets::absent) record[static_cast<std::size_t>(at.r)] = std::abs(maker.number(1.5));
    made.scene->add(static_cast<std::int64_t>(i) + 1, record.data(), legs);
    made.records.push_back(record);
  }
  made.now = start + maker.time(-4, 14);
  made.h = random.below(8) == 0 ? 0 : std::abs(maker.time(1, 30));
  made.within = random.below(3) == 0 ? 1 : 0.25;
  return made;
}

inline OwnMotion motion_of(const Leg& leg) {
  OwnMotion motion;
  motion.t = leg.t, motion.until = leg.until, motion.x = leg.x, motion.v = leg.v, motion.a = leg.a;
  return motion;
}
inline Leg leg_of(const OwnMotion& motion) {
  return {motion.t, motion.until, motion.x, motion.v, motion.a};
}
inline Leg leg_from(const Leg& leg, double time) {
  return leg_of(motion_from(motion_of(leg), time));
}

/// The legs of the object as they are stored, to the end of its life.
inline std::vector<Leg> stored_legs(const AvoidQuestion& question) {
  const OwnMotion record = motion_in(question.own_scene->layout, question.record);
  std::vector<Leg> legs = question.plan ? legs_of(*question.plan) : std::vector<Leg>{leg_of(record)};
  std::erase_if(legs, [&](const Leg& leg) { return leg.t > record.until; });
  for (Leg& leg : legs) leg.until = std::min(leg.until, record.until);
  return legs;
}

/// The legs after the manoeuvre. Requires: it exists at some time from now on.
inline std::vector<Leg> legs_after(const AvoidQuestion& question, Manoeuvre how, double k) {
  std::vector<Leg> legs = stored_legs(question);
  if (k == 0) return legs;
  if (how == Manoeuvre::delay) {
    for (Leg& leg : legs) leg.t += k, leg.until += k;
    return legs;
  }
  std::size_t here = 0;
  while (here + 1 < legs.size() && legs[here].until < question.now) ++here;
  const double s = std::max(question.now, legs[here].t);
  while (here + 1 < legs.size() && legs[here + 1].t <= s) ++here;
  const Leg base = leg_from(legs[here], s);
  std::vector<Leg> after;
  if (how == Manoeuvre::wait) {
    if (question.plan) after.assign(legs.begin(), legs.begin() + static_cast<std::ptrdiff_t>(here));
    if (question.plan && legs[here].t < s)
      after.push_back({legs[here].t, s, legs[here].x, legs[here].v, legs[here].a});
    after.push_back({s, s + k, base.x, {}, {}});
    after.push_back({s + k, base.until + k, base.x, base.v, base.a});
    for (std::size_t i = here + 1; i < legs.size(); ++i) {
      after.push_back(legs[i]);
      after.back().t += k, after.back().until += k;
    }
    return after;
  }
  OwnMotion changed = changes_by(how, motion_of(base))->changed(k);
  if (question.resume && s + *question.resume < base.until) {
    const double t = s + *question.resume;
    changed.until = t;
    Leg resumed = leg_from(base, t);
    resumed.x = leg_from(leg_of(changed), t).x;
    return {leg_of(changed), resumed};
  }
  return {leg_of(changed)};
}

/// Whether one of the legs touches a leg of another object during the horizon; `spared`: objects that do not count.
inline bool meets(const AvoidQuestion& question, const std::vector<Leg>& legs, const Horizon& horizon,
                  const std::vector<std::int64_t>& spared = {}, std::vector<std::int64_t>* met = nullptr) {
  Layout layout = question.own_scene->layout;
  const Offsets at = row_offsets(layout);
  const Scene& others = *question.others.scene;
  for (const Leg& leg : legs) {
    std::vector<double> row(question.own_scene->rows.begin(), question.own_scene->rows.begin() + at.size);
    write_leg(at, layout.axes, leg, row.data());
    row[static_cast<std::size_t>(at.until)] = leg.until;
    const auto contact = make_contact({layout, row.data(), 1}, others.bodies(),
                                      {horizon, question.within, {}}, "own", "others");
    std::vector<Pair> pairs, hits;
    for (std::uint32_t i = 0; i < others.size(); ++i)
      if (others.ids[i] != question.own_scene->ids[0] &&
          std::find(spared.begin(), spared.end(), others.ids[i]) == spared.end())
        pairs.push_back({0, i});
    contact->decide(pairs, hits);
    if (met)
      for (const Pair& hit : hits) met->push_back(others.ids[hit.b]);
    if (!met && !hits.empty()) return true;
  }
  return met && !met->empty();
}

}  // namespace foresee::avoid_oracle
