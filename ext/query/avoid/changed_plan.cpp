// The plan and the record that a change gives an object with several legs.
#include <algorithm>

#include "base/error.h"
#include "motion/plan/plan_legs.h"
#include "query/avoid/manoeuvre_case.h"

namespace foresee {
namespace {

Leg leg_of(const OwnMotion& motion) {
  return {motion.t, motion.until, motion.x, motion.v, motion.a};
}

Leg later(Leg leg, double k) {
  leg.t += k;
  leg.until += k;
  return leg;
}

/// All legs of the plan, where the object stands for k from the start of the manoeuvre on.
std::vector<Leg> legs_with_wait(const std::vector<Leg>& legs, const OwnState& own, double k) {
  const OwnMotion& base = own.base;
  const std::size_t here = own.legs_before + own.current_leg;
  std::vector<Leg> changed(legs.begin(), legs.begin() + static_cast<std::ptrdiff_t>(here));
  Leg before = legs[here];
  before.until = base.t;
  if (before.t < before.until) changed.push_back(before);
  changed.push_back({base.t, base.t + k, base.x, {}, {}});
  changed.push_back({base.t + k, legs[here].until + k, base.x, base.v, base.a});
  for (std::size_t i = here + 1; i < legs.size(); ++i) changed.push_back(later(legs[i], k));
  return changed;
}

/// The plan of knots, where the object stands for k; it need not have the legs of legs_with_wait().
Plan knots_with_wait(const Plan& plan, const OwnState& own, double k) {
  Plan changed{.kind = plan.kind, .axes = plan.axes, .part_starts = {}};
  const OwnMotion& base = own.base;
  std::size_t leg = 0;
  const std::size_t here = own.legs_before + own.current_leg;
  for (std::size_t part = 0; part < plan.parts(); ++part) {
    changed.part_starts.push_back(changed.knots.size());
    for (std::size_t i = plan.part_starts[part]; i < plan.part_end(part); ++i) {
      Knot knot = plan.knots[i];
      if (leg > here || knot.t > base.t) knot.t += k;
      const bool starts = leg == here && i + 1 < plan.part_end(part);
      if (!starts || knot.t < base.t) changed.knots.push_back(knot);
      if (starts) {
        changed.knots.push_back({base.t, base.x});
        changed.knots.push_back({base.t + k, base.x});
      }
      if (i + 1 < plan.part_end(part)) ++leg;
    }
  }
  return changed;
}

/// A plan of these legs; knots if these are their legs, or if it must be knots.
template <class MakeKnots>
std::optional<Plan> plan_of_legs(std::vector<Leg> legs, const AvoidQuestion& question,
                                 MakeKnots&& make_knots) {
  const Plan& stored = *question.plan;
  if (stored.kind == PlanKind::knots) {
    try {
      Plan plan = make_knots(stored);
      check_plan(plan);
      if (question.in_degrees || legs_of(plan) == legs) return plan;
    } catch (const Error&) {  // no knots have these legs
    }
  }
  if (question.in_degrees) return std::nullopt;
  const PlanKind kind = stored.kind == PlanKind::knots ? PlanKind::uniform : stored.kind;
  return Plan{.kind = kind, .axes = stored.axes, .legs = std::move(legs)};
}

}  // namespace

std::optional<Plan> changed_plan(const ManoeuvreCase& manoeuvre, double k) {
  const AvoidQuestion& question = manoeuvre.question;
  const OwnState& own = manoeuvre.own;
  const bool waits = manoeuvre.queried.manoeuvre == Manoeuvre::wait;
  if (question.plan) {
    if (k == 0) return *question.plan;
    std::vector<Leg> legs = legs_of(*question.plan);
    if (waits)
      return plan_of_legs(legs_with_wait(legs, own, k), question,
                          [&](const Plan& knots) { return knots_with_wait(knots, own, k); });
    for (Leg& leg : legs) leg = later(leg, k);
    return plan_of_legs(std::move(legs), question, [&](const Plan& knots) { return shifted_plan(knots, k); });
  }
  const bool has_legs = waits || question.resume;
  const bool needs_plan = takes_plan(question) && (question.lacks_t || question.lacks_velocity);
  if (k == 0 || question.in_degrees || !(has_legs || needs_plan)) return std::nullopt;
  const Offsets at = record_offsets(own.layout);
  const bool bends = at.a != Offsets::absent || at.force != Offsets::absent;
  Plan plan{.kind = bends ? PlanKind::accelerated : PlanKind::uniform, .axes = own.layout.axes};
  double heading = 0;
  for (const auto& leg : manoeuvre.changed.legs) {
    const OwnMotion motion = leg->changed(k);
    if (leg == manoeuvre.changed.legs.front())
      heading = motion.heading;
    else if (own.layout.has_heading && motion.heading != heading)
      return std::nullopt;  // a plan has one heading
    plan.legs.push_back(leg_of(motion));
  }
  return plan;
}

std::vector<double> changed_record(const ManoeuvreCase& manoeuvre, double k) {
  const AvoidQuestion& question = manoeuvre.question;
  const OwnState& own = manoeuvre.own;
  if (k == 0) return question.record;
  const Layout& layout = question.own_scene->layout;
  const bool waits = manoeuvre.queried.manoeuvre == Manoeuvre::wait;
  OwnMotion motion = manoeuvre.first_leg().changed(k);
  const bool has_started = own.legs_before + own.current_leg > 0 || own.stored.t < own.base.t;
  if (question.plan && waits && has_started) motion = own.stored;
  if (question.plan || waits || question.resume) {
    motion.until = motion_in(layout, question.record).until;
    if (manoeuvre.changed.are_later) motion.until += k;
  }
  return with_motion(layout, question.record, motion);
}

}  // namespace foresee
