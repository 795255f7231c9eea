// Error analysis of the legs
// --------------------------
// With speed V, turn rate ω in radians, and τ the time since the start, the arc is
//   P(τ) = P(0) + V τ sinc(ωτ/2) e(ωτ/2),   sinc(x) = sin(x) / x,
// where e(α) is the first direction turned by α. The quadratic through P at the start, the middle and the end of a leg
// of duration T and angle θ = ωT has, with e and its normal n at the middle of the leg,
//   a = V ω sinc(θ/4)² n,   v = V sinc(θ/2) e - a T/2.
// Let u = 2^-53 and D be the duration of the turn. Sine and cosine are within 2^-49 (correct_rounding.h), and angles
// within 3u of their size; sinc is then within 2^-48.
//  - Start of a leg: the chord V τ sinc is at most V τ long, and an angle that is off by 3u ωτ moves its end by at most
//    6u V τ. Together with sinc and e: below 2^-47 V D. The stored coordinate is rounded: u (|x| + V D).
//  - Direction of a leg: an error of 3u ωD, over the length V T: at most 3u V D θ. The same holds for the length
//    a T²/2, which is at most the lesser of V T θ/2 and 8 V/ω. Sinc, e, and all products: below 2^-47 V T (1 + θ).
// rounding() is 2^-46 V D (1 + θ) + 2^-51 (|x| + |y|), more than the sum, plus 2^-1000 for underflow.
#include "motion/plan/arc.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "motion/manoeuvre.h"
#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

constexpr double max_angle = 0x1p40;  ///< degrees

/// The proof for one turn: bounds that hold for every leg.
class TurnBounds {
 public:
  explicit TurnBounds(const TurnManoeuvre& turn)
      : duration_(turn.duration), magnitude_(std::abs(turn.x[0]) + std::abs(turn.x[1])) {
    OwnMotion motion;
    motion.v = {turn.v[0], turn.v[1], 0};
    speed_ = speed_of(motion) * (1 + 0x1p-50);
    rate_ = std::abs(turn.rate) * radians_per_degree * (1 + 0x1p-50);
    time_ = std::max(std::abs(turn.t), std::abs(turn.t + turn.duration));
  }

  /// Of the duration of one of n legs, whose times are rounded.
  double longest(double n) const {
    return n == 1 ? duration_ : duration_ / n + 0x1p-49 * (duration_ + time_);
  }
  /// Of the distance between a leg and the arc, both in real numbers.
  double curve(double n) const {
    const double angle = rate_ * longest(n);
    return 0.008018754 * (speed_ * longest(n)) * angle * angle * (1 + 0x1p-40);
  }
  double rounding(double n) const {
    return 0x1p-46 * (speed_ * duration_) * (1 + rate_ * longest(n)) + 0x1p-51 * magnitude_ + 0x1p-1000;
  }
  /// Of the straight leg, beside the rounding of its start.
  double straight(double time) const { return std::isfinite(time) ? 0x1p-46 * (speed_ * time) : 0; }
  /// About the number of legs that keep `error` for the curve.
  double estimate(double error) const {
    const double angle = rate_ * duration_;
    return std::ceil(std::cbrt(0.008018754 * (speed_ * duration_) / error * angle * angle));
  }

 private:
  double duration_, magnitude_, speed_, rate_, time_;
};

/// The smallest number of legs that keep the error. Whether n legs do is monotonic in n, so that the estimate, which
/// takes libm's cube root, has no influence.
double legs_within(const TurnBounds& bounds, double straight, double error) {
  const auto keeps = [&](double n) { return bounds.curve(n) + bounds.rounding(n) + straight <= error; };
  constexpr double max_legs = max_plan_legs - 1;
  const double unavoidable = bounds.rounding(max_legs) + straight;
  if (!(unavoidable < error))
    throw Error("error is " + shown(error) + ": the doubles of this turn prove no less than " +
                shown(unavoidable) + "; write twice that");
  double n = std::clamp(bounds.estimate(error - unavoidable), 1.0, max_legs);
  while (n > 1 && keeps(n - 1)) --n;
  while (n < max_legs && !keeps(n)) ++n;
  if (!keeps(n))
    throw Error("error is " + shown(error) + ": the turn needs more than " + shown(max_legs) +
                " legs; write a larger error, or a shorter duration");
  return n;
}

void check_turn(const TurnManoeuvre& turn, double end) {
  if (!(turn.duration > 0))
    throw Error("duration is " + shown(turn.duration) + ": write a number greater than 0");
  if (!std::isfinite(end) || end == turn.t)
    throw Error("duration is " + shown(turn.duration) + ": at t = " + shown(turn.t) +
                " no double holds the end of the turn; count t from a later origin");
  if (turn.until < end)
    throw Error("until is " + shown(turn.until) + ", before the turn ends at " + shown(end) +
                ": write a later time, or NULL");
  if (!(std::abs(turn.rate) * turn.duration <= max_angle))
    throw Error("rate is " + shown(turn.rate) +
                ": the turn has more than 1e12 degrees; write degrees per unit of time");
}

}  // namespace

Plan turn_plan(const TurnManoeuvre& turn, double error) {
  const FloatEnvironment environment;
  const double end = turn.t + turn.duration;
  check_turn(turn, end);
  Plan plan{.kind = PlanKind::accelerated, .axes = 2};
  if (turn.rate == 0 || turn.v == std::array<double, 2>{}) {
    plan.legs.push_back({turn.t, turn.until, {turn.x[0], turn.x[1], 0}, {turn.v[0], turn.v[1], 0}, {}});
    return plan;
  }
  TurnManoeuvre exact = turn;
  exact.duration = std::nextafter(end - turn.t, std::numeric_limits<double>::infinity());
  const double straight = TurnBounds(exact).straight(turn.until - end);
  const double legs = legs_within(TurnBounds(exact), straight, error);
  const auto time = [&](double k) { return k == legs ? end : turn.t + (end - turn.t) * (k / legs); };
  const auto turned = [&](double degrees) { return quick_turned(turn.v[0], turn.v[1], degrees); };
  const auto place = [&](double tau) {
    const double half = turn.rate * tau * 0.5, chord = tau * quick_sinc(half);
    const Turned e = turned(half);
    return std::array<double, 3>{turn.x[0] + chord * e.x, turn.x[1] + chord * e.y, 0};
  };

  for (double k = 0; k < legs; ++k) {
    Leg& leg = plan.legs.emplace_back();
    leg.t = time(k), leg.until = time(k + 1);
    const double tau = leg.t - turn.t, duration = leg.until - leg.t, angle = turn.rate * duration;
    const double bend = quick_sinc(angle * 0.25), rate = turn.rate * radians_per_degree * bend * bend;
    const Turned e = turned(turn.rate * (tau + 0.5 * duration));
    const double chord = quick_sinc(angle * 0.5);
    leg.x = place(tau);
    leg.a = {rate * e.y + 0.0, rate * -e.x + 0.0, 0};
    leg.v = {chord * e.x - leg.a[0] * (0.5 * duration), chord * e.y - leg.a[1] * (0.5 * duration), 0};
  }
  if (turn.until > end) {
    const Turned v = turned(turn.rate * (end - turn.t));
    plan.legs.push_back({end, turn.until, place(end - turn.t), {v.x, v.y, 0}, {}});
  }
  return plan;
}

}  // namespace foresee
