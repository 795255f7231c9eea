// Error analysis of the quotient
// ------------------------------
// Let D = dx.high + dx.low and T = dt.high + dt.low be the exact differences, u = 2^-53, and q = D.high / T.high,
// rounded. Heads within [2^-400, 2^400] keep every product below in range, and losses by underflow, which are
// below 2^-1070, far beneath the bound. Then |D / T - q| <= 4u |q|, since each of heads and division is off by u.
// The remainder D - q T is computed as ((D.high - p.high) - p.low) + (D.low - q T.low) with p = q T.high exactly.
// D.high - p.high is exact, since the two differ by less than a factor of 2. The other three operations round
// numbers of at most 4u |D|, so the remainder is off by at most 16u^2 |D|, and the correction, remainder / T.high,
// by at most 16u^2 |q| + 2u 4u |q| = 24u^2 |q|. The sum q + correction = high + low is exact. `doubt` is 64u^2 |q|:
// if low - doubt and low + doubt both leave `high` as it is, then so does D / T.
#include "motion/plan/plan_legs.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "motion/manoeuvre.h"
#include "numbers/correct_rounding.h"
#include "numbers/double_double.h"

namespace foresee {

namespace {

bool is_moderate(double number) {
  return 0x1p-400 < std::abs(number) && std::abs(number) < 0x1p400;
}

double exact_velocity(double from, double to, double t0, double t1) {
  return rounded_quotient(Dyadic(to) - Dyadic(from), Dyadic(t1) - Dyadic(t0));
}

/// "knot 4", or "knot 4 of part 2" if there are several parts: counted from 1.
std::string name_of_knot(const Plan& plan, std::size_t knot) {
  std::size_t part = 0;
  while (plan.part_end(part) <= knot) ++part;
  const std::string name = "knot " + std::to_string(knot - plan.part_starts[part] + 1);
  return plan.parts() == 1 ? name : name + " of part " + std::to_string(part + 1);
}

void check_part(const Plan& plan, std::size_t part) {
  const std::size_t first = plan.part_starts[part], end = plan.part_end(part);
  if (end - first < 2)
    throw Error(plan.parts() == 1 && end == first
                    ? "a plan without knots: write two, or NULL and a plain row"
                    : "part " + std::to_string(part + 1) + " has one knot: write two, or a plain row");
  for (std::size_t i = first + 1; i < end; ++i) {
    const Knot &before = plan.knots[i - 1], &knot = plan.knots[i];
    if (!(before.t < knot.t))
      throw Error(name_of_knot(plan, i) + ": t is " + shown(knot.t) + " after " + shown(before.t) +
                  ": times must rise; write MULTILINESTRING M for a jump");
    if (knot.t == no_end && knot.x != before.x)
      throw Error(name_of_knot(plan, i) + ": t is inf, but its place is not that of " +
                  name_of_knot(plan, i - 1) + ": write the place where the mover stays");
  }
}

void check_knots(const Plan& plan) {
  for (std::size_t part = 0; part < plan.parts(); ++part) {
    check_part(plan, part);
    if (part == 0) continue;
    const double start = plan.knots[plan.part_starts[part]].t;
    const double end = plan.knots[plan.part_starts[part] - 1].t;
    if (start < end)
      throw Error("part " + std::to_string(part + 1) + " starts at " + shown(start) + ", before part " +
                  std::to_string(part) + " ends at " + shown(end));
  }
}

void check_legs(const std::vector<Leg>& legs) {
  if (legs.empty()) throw Error("a plan without legs: write one, or NULL and a plain row");
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].until < legs[i].t)
      throw Error("leg " + std::to_string(i + 1) + " ends at " + shown(legs[i].until) +
                  ", before it starts at " + shown(legs[i].t));
    if (i > 0 && legs[i].t < legs[i - 1].until)
      throw Error("leg " + std::to_string(i + 1) + " starts at " + shown(legs[i].t) + ", before leg " +
                  std::to_string(i) + " ends at " + shown(legs[i - 1].until));
  }
}

}  // namespace

double velocity_between(double from, double to, double t0, double t1) {
  if (from == to || t1 == no_end) return 0;
  const DoubleDouble dx = difference(to, from), dt = difference(t1, t0);
  if (!std::isfinite(dx.high) || !std::isfinite(dt.high)) return exact_velocity(from, to, t0, t1);
  const double q = dx.high / dt.high;
  if (dx.low == 0 && dt.low == 0) return q + 0.0;
  if (!is_moderate(dx.high) || !is_moderate(dt.high)) return exact_velocity(from, to, t0, t1);
  const DoubleDouble p = product(q, dt.high);
  const double remainder = ((dx.high - p.high) - p.low) + (dx.low - q * dt.low);
  const DoubleDouble corrected = sum(q, remainder / dt.high);
  const double doubt = 0x1p-100 * std::abs(q);
  if (corrected.high + (corrected.low - doubt) == corrected.high &&
      corrected.high + (corrected.low + doubt) == corrected.high)
    return corrected.high;
  return exact_velocity(from, to, t0, t1);
}

std::size_t leg_count(const Plan& plan) {
  return plan.kind == PlanKind::knots ? plan.knots.size() - plan.parts() : plan.legs.size();
}

std::vector<Leg> legs_of(const Plan& plan) {
  if (plan.kind != PlanKind::knots) return plan.legs;
  const FloatEnvironment environment;
  std::vector<Leg> legs;
  legs.reserve(leg_count(plan));
  for (std::size_t part = 0; part < plan.parts(); ++part)
    for (std::size_t i = plan.part_starts[part] + 1; i < plan.part_end(part); ++i) {
      const Knot &from = plan.knots[i - 1], &to = plan.knots[i];
      Leg& leg = legs.emplace_back(Leg{from.t, to.t, from.x, {}, {}});
      for (std::size_t j = 0; j < static_cast<std::size_t>(plan.axes); ++j) {
        leg.v[j] = velocity_between(from.x[j], to.x[j], from.t, to.t);
        if (!std::isfinite(leg.v[j]))
          throw Error("leg " + std::to_string(legs.size()) + " from " + shown(from.x[j]) + " to " +
                      shown(to.x[j]) + ": no double holds its velocity");
      }
    }
  return legs;
}

void check_plan(const Plan& plan) {
  if (plan.kind == PlanKind::knots)
    check_knots(plan);
  else
    check_legs(plan.legs);
}

void check_size(const Plan& plan) {
  if (leg_count(plan) > max_plan_legs)
    throw Error(std::to_string(leg_count(plan)) + " legs; at most " + std::to_string(max_plan_legs) +
                ": cut it with plan_cut");
}

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

/// Appends what one part of a plan of knots does between two times.
void cut_part(const Plan& plan, std::size_t part, double from, double to, const KnotBetween& between,
              Plan& cut) {
  const auto first = plan.knots.begin() + static_cast<std::ptrdiff_t>(plan.part_starts[part]);
  const auto end = plan.knots.begin() + static_cast<std::ptrdiff_t>(plan.part_end(part));
  from = std::max(from, first->t), to = std::min(to, std::prev(end)->t);
  if (!(from < to)) return;
  if (!cut.knots.empty()) cut.part_starts.push_back(cut.knots.size());
  const auto at = [&](double time) {
    const auto next =
        std::lower_bound(first, end, time, [](const Knot& knot, double t) { return knot.t < t; });
    return next->t == time ? *next : between(plan, static_cast<std::size_t>(next - plan.knots.begin()), time);
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
  for (Leg& leg : shifted.legs) {
    shift(leg.t);
    shift(leg.until);
  }
  check_plan(shifted);
  return shifted;
}

Knot knot_between(const Plan& plan, std::size_t after, double time) {
  const Knot &from = plan.knots[after - 1], &to = plan.knots[after];
  if (time == no_end) return {time, from.x};
  Leg leg{from.t, to.t, from.x, {}, {}};
  for (std::size_t j = 0; j < static_cast<std::size_t>(plan.axes); ++j)
    leg.v[j] = velocity_between(from.x[j], to.x[j], from.t, to.t);
  return {time, leg_from(leg, time).x};
}

std::optional<Plan> cut_plan(const Plan& plan, double from, double to, const KnotBetween& between) {
  const FloatEnvironment environment;
  Plan cut{.kind = plan.kind, .axes = plan.axes};
  if (plan.kind == PlanKind::knots)
    for (std::size_t part = 0; part < plan.parts(); ++part) cut_part(plan, part, from, to, between, cut);
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
