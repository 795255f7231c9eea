// The closest approach of two centres: the minimum of |x + v tau + a tau^2| while both objects exist in the
// horizon, and its time; the earliest one on ties.
//
// Time and distance are the exact ones, each rounded once. As for contact, doubles with error bounds and one
// step in DoubleDouble decide nearly all pairs. Exact arithmetic decides a tie, a distance of exactly 0,
// numbers near the ends of the range of doubles, and times halfway between two doubles.

#include <optional>

#include "contact/certified/certain_motion.h"
#include "contact/certified/certain_slope.h"
#include "contact/constraint/constraint.h"
#include "contact/contact.h"
#include "contact/exact/exact_contact.h"
#include "contact/minkowski/relative_motion.h"
#include "numbers/crossed_root.h"

namespace foresee {
namespace {

/// The error of DoubleDouble as a share of the error bound of double, which counts at least 4 u of every
/// term.
constexpr double fine = 0x1p-45;
constexpr double fine_roundoff = 0x1p-97;

/// A squared distance and its time, as reported.
struct Nearness {
  DoubleDouble square;
  double error = 0;  ///< bound on the error of square
  Instant instant{};

  bool certainly_below(const Nearness& other) const {
    return (other.square - square).high > (error + other.error) * (1 + 0x1p-40);
  }
};

/// The rounded square root, if it is the same for all numbers within the error.
std::optional<double> rounded_square_root(const Nearness& n) {
  const double square = n.square.high;
  if (!(0x1p-900 < square && square < 0x1p900 && n.error < 0x1p-10 * square)) return {};
  const double root = std::sqrt(square);
  const double rest = (n.square - product(root, root)).high / (2 * root);
  const double radius = n.error / root + 0x1p-97 * root;
  const double low = root + (rest - radius), high = root + (rest + radius);
  if (low != high) return {};
  return low;
}

/// The closest approach in double and DoubleDouble, if error bounds certify it.
template <int D>
class CertainApproach {
 public:
  CertainApproach(const Setup& setup, const double* row_a, const double* row_b)
      : setup_(setup),
        lifetime_(pair_lifetime_of(setup, row_a, row_b)),
        relative_(certain_motion_of<D, 2>(setup, row_a, row_b)),
        motion_(relative_motion_of<DoubleDouble, D>(setup, row_a, row_b)) {
    begin_ = difference(lifetime_.t_start, setup.horizon.now);
    end_ = lifetime_.ends_with_horizon ? DoubleDouble{lifetime_.dt_end, 0}
                                       : difference(lifetime_.t_end, setup.horizon.now);
    still_ = keeps_its_place(row_a, row_b) || (end_ - begin_).high == 0;
  }

  std::optional<ClosestApproach> answer() {
    std::optional<Nearness> nearest = still_ ? at_start() : minimum();
    if (!nearest) return {};
    const std::optional<double> distance = rounded_square_root(*nearest);
    if (!distance) return {};
    return ClosestApproach{nearest->instant.t, nearest->instant.dt, *distance};
  }

 private:
  /// Whether there is exactly no relative motion.
  bool keeps_its_place(const double* row_a, const double* row_b) const {
    const bool same_time = value_or(row_a, setup_.a.at.t, 0) == value_or(row_b, setup_.b.at.t, 0);
    for (int j = 0; j < D; ++j) {
      const AxisMotion a = axis_motion(setup_.a, row_a, j), b = axis_motion(setup_.b, row_b, j);
      if (a.v != b.v || a.a != b.a || (a.a != 0 && !same_time)) return false;
    }
    return true;
  }

  /// The smaller of one or two local minima; no value if it is undecided.
  std::optional<Nearness> minimum() {
    const double low = lifetime_.start_exact ? begin_.high : begin_.high * (1 - 2 * unit_roundoff);
    const double high = lifetime_.end_exact ? end_.high : end_.high * (1 + 2 * unit_roundoff);
    const Slope at_low = slope_at(low), at_high = slope_at(high);
    int budget = 16;
    if (!find_valleys(low, at_low, high, at_high, budget)) return {};
    std::optional<Nearness> best;
    if (at_low.sign() > 0) best = at_start();
    for (int i = 0; i < valley_count_; ++i)
      if (!keep_nearer(best, bottom(valleys_[i]))) return {};
    if (at_high.sign() < 0 && !keep_nearer(best, at_end())) return {};
    return best;
  }

  /// Keeps the nearer one in `best`. False if `later` is unknown, or neither is certainly nearer.
  static bool keep_nearer(std::optional<Nearness>& best, const std::optional<Nearness>& later) {
    if (!later) return false;
    if (best && best->certainly_below(*later)) return true;
    if (best && !later->certainly_below(*best)) return false;
    best = later;
    return true;
  }

  Slope slope_at(double tau) const { return slope_of(view_from<2>(relative_, tau)); }

  /// Isolates all minima, the rising roots of the slope, in order; false if that fails.
  bool find_valleys(double low, const Slope& at_low, double high, const Slope& at_high, int& budget) {
    const double length = high - low;
    const Verdict falls_and_rises = has_valley(at_low, at_high, length);
    if (falls_and_rises == Verdict::yes) {
      if (valley_count_ == 2) return false;
      valleys_[valley_count_++] = {low, high};
    }
    if (falls_and_rises != Verdict::uncertain) return true;
    if (--budget < 0) return false;
    const double middle = low + 0.5 * length;
    const Slope at_middle = slope_at(middle);
    return find_valleys(low, at_low, middle, at_middle, budget) &&
           find_valleys(middle, at_middle, high, at_high, budget);
  }

  /// An approximate root: Newton's steps, kept in the interval by bisection. Its error affects no guarantee.
  double rough_root(const Interval<double>& valley) const {
    double low = valley.begin, high = valley.end, tau = low + 0.5 * (high - low);
    for (int i = 0; i < 60; ++i) {
      double value = 0, growth = 0;
      for (int j = 0; j < D; ++j) {
        const CertainAxisMotion<double>& r = relative_.axis[j];
        const double turn = tau * r.a;
        const double p = r.x + tau * (r.v + turn), q = r.v + 2 * turn;
        value += p * q;
        growth += q * q + 2 * (r.a * p);
      }
      (value < 0 ? low : high) = tau;
      double next = tau - value / growth;
      if (!(low < next && next < high)) next = low + 0.5 * (high - low);
      const double step = std::abs(next - tau);
      tau = next;
      if (step <= 0x1p-40 * tau) break;
    }
    return tau;
  }

  /// The minimum in a valley, or at the end of the lifetime if the valley's minimum is beyond it.
  ///
  /// With g the slope and s its derivative at tau, the root is tau - g / s and the minimum of the square is
  /// |x|^2 - g^2 / s, up to the relative change of s between tau and the root.
  std::optional<Nearness> bottom(const Interval<double>& valley) const {
    const double tau = rough_root(valley);
    const Spot spot = spot_at({tau, 0});
    const double growth = spot.rough.growth, value = spot.slope.high;
    const double step = -value / growth;
    const double reach = 4 * std::abs(step) + 0x1p-60 * tau;
    const double change = spot.rough.growth_error + reach * (spot.bend + reach * spot.bend_growth);
    const double slope_error = spot.slope_error + std::abs(spot.slope.low);
    // So steep that the root is within reach: the valley has no other.
    if (!(change < 0.25 * growth && std::abs(value) + slope_error < 0.5 * growth * reach)) return {};
    const double share = change / growth + 8 * unit_roundoff;
    const double radius = 2 * (slope_error / growth + std::abs(step) * share) + 0x1p-1060;
    if (const int side = side_of(sum(tau, step), radius); side != 0)
      return side == 2 ? std::nullopt : side < 0 ? at_start() : at_end();

    const double gain = std::abs(value * step);
    Nearness nearness{spot.square - DoubleDouble{gain, 0}, 0, {}};
    nearness.error = spot.square_error + 6 * share * gain +
                     4 * (slope_error * (std::abs(step) + slope_error / growth)) + fine_roundoff * gain;
    nearness.instant = rounded_instant(setup_.horizon.now, tau, step, radius);
    if (!nearness.instant.known()) return {};
    return nearness;
  }

  /// The place of a time with error `radius`: -1 before the start, 1 after the end, 0 between, 2 undecided.
  int side_of(const DoubleDouble& tau, double radius) const {
    const double after_start = (tau - begin_).high, before_end = (end_ - tau).high;
    const double doubt = 2 * radius;
    if (after_start > doubt && before_end > doubt) return 0;
    return after_start < -doubt ? -1 : before_end < -doubt ? 1 : 2;
  }

  std::optional<Nearness> at_start() const {
    const Spot spot = spot_at(begin_);
    return Nearness{spot.square, spot.square_error, lifetime_.start()};
  }
  std::optional<Nearness> at_end() const {
    const Spot spot = spot_at(end_);
    return Nearness{spot.square, spot.square_error, lifetime_.end()};
  }

  /// Squared distance and slope at a time in DoubleDouble; the derivative of the slope in double.
  struct Spot {
    DoubleDouble square, slope;
    double square_error = 0, slope_error = 0;
    Slope rough;
    double bend = 0, bend_growth = 0;  ///< the growth changes by at most reach * (bend + reach * bend_growth)
  };

  Spot spot_at(const DoubleDouble& tau) const {
    const CertainMotion<D> view = view_from<2>(relative_, tau.high);
    Spot spot;
    spot.rough = slope_of(view);
    double squares = 0, products = 0;
    for (std::size_t j = 0; j < D; ++j) {
      const auto& [at_now, speed, half_a] = motion_[j];
      const DoubleDouble turn = tau * half_a, place = at_now + tau * (speed + turn);
      spot.square = spot.square + place * place;
      spot.slope = spot.slope + place * (speed + (turn + turn));

      const CertainAxisMotion<double>& w = view.axis[j];
      const double p = std::abs(w.x) + w.ex, q = std::abs(w.v) + w.ev, a = std::abs(w.a) + w.ea;
      const double ep = fine * w.ex + relative_.underflow, eq = fine * w.ev + relative_.underflow;
      squares += p * p, products += p * q;
      spot.square_error += ep * (2 * p + ep);
      spot.slope_error += p * eq + q * ep + ep * eq;
      spot.bend += 7 * (a * q), spot.bend_growth += 14 * (a * a);
    }
    spot.square_error += fine_roundoff * squares + 0x1p-1060;
    spot.slope_error += fine_roundoff * products + 0x1p-1060;
    return spot;
  }

  const Setup& setup_;
  PairLifetime lifetime_;
  CertainMotion<D> relative_;
  RelativeMotion<DoubleDouble, D> motion_;
  DoubleDouble begin_, end_;
  bool still_;
  Interval<double> valleys_[2];
  int valley_count_ = 0;
};

template <int D>
[[gnu::noinline]] ClosestApproach exact_answer(const Setup& setup, const double* row_a, const double* row_b) {
  const auto motion = relative_motion_of<Dyadic, D>(setup, row_a, row_b);
  const auto square = ball_polynomial<2>(motion, MovingSize<Dyadic>{}, [](const Dyadic&) { return true; });
  return exact_approach(square, exact_lifetime_of(setup, row_a, row_b));
}

}  // namespace

template <int D>
ClosestApproach closest_approach_of(const Setup& setup, const double* row_a, const double* row_b) {
  if (const auto certain = CertainApproach<D>(setup, row_a, row_b).answer()) return *certain;
  return exact_answer<D>(setup, row_a, row_b);
}

template ClosestApproach closest_approach_of<1>(const Setup&, const double*, const double*);
template ClosestApproach closest_approach_of<2>(const Setup&, const double*, const double*);
template ClosestApproach closest_approach_of<3>(const Setup&, const double*, const double*);

}  // namespace foresee
