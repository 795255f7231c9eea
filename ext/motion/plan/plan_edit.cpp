#include "motion/plan/plan_edit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "motion/manoeuvre.h"
#include "motion/plan/plan_legs.h"

namespace foresee {
namespace {

/// The leg from `time` on, with position and velocity rounded once.
Leg leg_from(const Leg& leg, double time) {
  if (time == leg.t) return leg;
  OwnMotion motion;
  motion.t = leg.t, motion.x = leg.x, motion.v = leg.v, motion.a = leg.a;
  const OwnMotion later = motion_from(motion, time);
  if (!is_finite(later))
    throw Error("the leg from " + shown(leg.t) + " on: no double holds its position at " + shown(time) +
                "; write an earlier time");
  return {time, leg.until, later.x, later.v, leg.a};
}

/// A knot on the way from `before` to `after`.
Knot knot_between(const Plan& plan, const Knot& before, const Knot& after, double time) {
  if (time == no_end) return {time, before.x};
  Leg leg{before.t, after.t, before.x, {}, {}};
  for (std::size_t j = 0; j < static_cast<std::size_t>(plan.axes); ++j)
    leg.v[j] = velocity_between(before.x[j], after.x[j], before.t, after.t);
  return {time, leg_from(leg, time).x};
}

/// Appends what one part of a plan of knots does between two times.
void cut_part(const Plan& plan, std::size_t part, double from, double to, Plan& cut) {
  const auto first = plan.knots.begin() + static_cast<std::ptrdiff_t>(plan.part_starts[part]);
  const auto end = plan.knots.begin() + static_cast<std::ptrdiff_t>(plan.part_end(part));
  from = std::max(from, first->t), to = std::min(to, std::prev(end)->t);
  if (!(from < to)) return;
  if (!cut.knots.empty()) cut.part_starts.push_back(cut.knots.size());
  const auto at = [&](double time) {
    const auto next =
        std::lower_bound(first, end, time, [](const Knot& knot, double t) { return knot.t < t; });
    return next->t == time ? *next : knot_between(plan, *std::prev(next), *next, time);
  };
  cut.knots.push_back(at(from));
  for (auto knot = first; knot != end; ++knot)
    if (from < knot->t && knot->t < to) cut.knots.push_back(*knot);
  cut.knots.push_back(at(to));
}

}  // namespace

Plan shifted_plan(const Plan& plan, double seconds) {
  const FloatEnvironment environment;
  Plan shifted = plan;
  const auto shift = [&](double& time) {
    const bool ends = std::isfinite(time);
    time += seconds;
    if (ends && !std::isfinite(time))
      throw Error("seconds is " + shown(seconds) +
                  ": no double holds a time of the shifted plan; write less");
  };
  for (Knot& knot : shifted.knots) shift(knot.t);
  for (Leg& leg : shifted.legs) shift(leg.t), shift(leg.until);
  check_plan(shifted);
  return shifted;
}

std::optional<Plan> cut_plan(const Plan& plan, double from, double to) {
  const FloatEnvironment environment;
  Plan cut{.kind = plan.kind, .axes = plan.axes};
  if (plan.kind == PlanKind::knots)
    for (std::size_t part = 0; part < plan.parts(); ++part) cut_part(plan, part, from, to, cut);
  for (const Leg& leg : plan.legs) {
    const double start = std::max(from, leg.t), end = std::min(to, leg.until);
    if (start > end || (start == end && leg.t < leg.until)) continue;
    cut.legs.push_back(leg_from(leg, start));
    cut.legs.back().until = end;
  }
  if (cut.knots.empty() && cut.legs.empty()) return std::nullopt;
  return cut;
}

}  // namespace foresee
