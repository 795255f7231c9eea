#include "contact/closest_approach.h"

#include <array>

namespace foresee {
namespace {

bool less(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}

/// How far apart at a moment: the exact power of two `scale` keeps the square from over- and underflowing.
struct Distance {
  DoubleDouble square;  ///< of distance / scale
  double scale;
  double error;  ///< bound on what square can be off

  double value() const {
    if (square.high <= error) return 0;
    const double root = std::sqrt(square.high);
    const DoubleDouble rest = square - product(root, root);
    return (root + rest.high / (2 * root)) * scale;
  }

  /// The same with a scale that is at least as large; what becomes 0 is too small to matter beside it.
  Distance scaled_to(double larger) const {
    const double share = scale / larger, squared = share * share;
    return {{square.high * squared, square.low * squared}, larger, error * squared};
  }
};

template <int D>
class Approach {
 public:
  Approach(const Setup& setup, const double* row_a, const double* row_b)
      : course_(course_of<DoubleDouble, D>(setup, row_a, row_b)) {
    const Moments moments = moments_of(setup, row_a, row_b);
    begin_ = difference(moments.t_begin, setup.horizon.now);
    end_ = moments.ends_with_horizon ? DoubleDouble{moments.dt_end, 0}
                                     : difference(moments.t_end, setup.horizon.now);
    for (int j = 0; j < D; ++j) bent_ = bent_ || course_.a[j].high != 0;
  }

  struct Nearest {
    DoubleDouble tau;
    double distance;
  };

  Nearest nearest() const {
    std::array<DoubleDouble, 8> moments;
    const int count = bent_ ? bent_candidates(moments) : straight_candidates(moments);
    DoubleDouble best_tau = moments[0];
    Distance best = distance_at(best_tau);
    for (int i = 1; i < count; ++i) {
      const Distance found = distance_at(moments[i]);
      const double larger = std::max(best.scale, found.scale);
      const Distance other = found.scaled_to(larger), nearest = best.scaled_to(larger);
      // Not nearer by more than the error: a tie, and the earlier moment stays.
      const DoubleDouble gap = nearest.square - other.square;
      if (!(gap.high > nearest.error + other.error)) continue;
      best = found;
      best_tau = moments[i];
    }
    return {best_tau, best.value()};
  }

 private:
  DoubleDouble place(int j, const DoubleDouble& tau) const {
    return bent_ ? course_.x[j] + tau * (course_.v[j] + tau * course_.a[j])
                 : course_.x[j] + tau * course_.v[j];
  }
  DoubleDouble speed(int j, const DoubleDouble& tau) const {
    const DoubleDouble turn = tau * course_.a[j];
    return course_.v[j] + turn + turn;
  }

  Distance distance_at(const DoubleDouble& tau) const {
    Distance d{{0, 0}, 1, 0};
    DoubleDouble away[D];
    double largest = 0, size = 0;
    const double t = std::abs(tau.high);
    for (int j = 0; j < D; ++j) {
      away[j] = place(j, tau);
      largest = std::max(largest, std::abs(away[j].high));
      size = std::max(size, std::abs(course_.x[j].high) +
                                t * (std::abs(course_.v[j].high) + t * std::abs(course_.a[j].high)));
    }
    // The exponent of the largest term at this moment: what a far end of the horizon brings does not blur it.
    if (size > 0 && std::isfinite(size)) d.scale = std::ldexp(1.0, std::clamp(std::ilogb(size), -1000, 1000));
    const double inverse = 1 / d.scale;
    for (int j = 0; j < D; ++j) {
      const DoubleDouble part{away[j].high * inverse, away[j].low * inverse};
      d.square = d.square + part * part;
    }
    // Each coordinate is within 2^-96 of the largest term.
    const double coordinate = 0x1p-96 * (size * inverse);
    d.error = D * coordinate * (2 * largest * inverse + coordinate) + 0x1p-98 * d.square.high;
    return d;
  }

  DoubleDouble clipped(const DoubleDouble& tau) const {
    if (less(tau, begin_)) return begin_;
    return less(end_, tau) ? end_ : tau;
  }

  int straight_candidates(std::array<DoubleDouble, 8>& moments) const {
    DoubleDouble along{0, 0}, speed_squared{0, 0};
    for (int j = 0; j < D; ++j) {
      along = along + course_.x[j] * course_.v[j];
      speed_squared = speed_squared + course_.v[j] * course_.v[j];
    }
    int count = 0;
    moments[count++] = begin_;
    const DoubleDouble turn = -along / speed_squared;
    if (std::isfinite(turn.high)) moments[count++] = clipped(turn);
    moments[count++] = end_;
    return count;
  }

  /// Half the slope of the squared distance.
  DoubleDouble slope(const DoubleDouble& tau) const {
    DoubleDouble sum{0, 0};
    for (int j = 0; j < D; ++j) sum = sum + place(j, tau) * speed(j, tau);
    return sum;
  }
  double slope_of_slope(double tau) const {
    double sum = 0;
    for (int j = 0; j < D; ++j) {
      const double a = course_.a[j].high, q = course_.v[j].high + 2 * tau * a;
      sum += q * q + 2 * a * (course_.x[j].high + tau * (course_.v[j].high + tau * a));
    }
    return sum;
  }

  /// Begin, the minima between the turning points of the slope, and end, in order of time.
  int bent_candidates(std::array<DoubleDouble, 8>& moments) const {
    double c1 = 0, c2 = 0, c3 = 0;  // slope of the slope: c1 + 2 c2 tau + 3 c3 tau^2
    for (int j = 0; j < D; ++j) {
      const double x = course_.x[j].high, v = course_.v[j].high, a = course_.a[j].high;
      c1 += v * v + 2 * x * a;
      c2 += 3 * v * a;
      c3 += 2 * a * a;
    }
    double turns[4] = {begin_.high, begin_.high, end_.high, end_.high};
    const double discriminant = c2 * c2 - 3 * c3 * c1;
    if (discriminant > 0) {
      const double q = -(c2 + std::copysign(std::sqrt(discriminant), c2));
      const double one = q / (3 * c3), two = q != 0 ? c1 / q : one;
      turns[1] = std::clamp(std::min(one, two), begin_.high, end_.high);
      turns[2] = std::clamp(std::max(one, two), begin_.high, end_.high);
    } else {
      turns[1] = turns[2] = end_.high;
    }
    int count = 0;
    moments[count++] = begin_;
    for (int piece = 0; piece < 3; ++piece)
      if (turns[piece] < turns[piece + 1] && slope({turns[piece], 0}).high < 0 &&
          slope({turns[piece + 1], 0}).high > 0)
        moments[count++] = clipped(bottom(turns[piece], turns[piece + 1]));
    moments[count++] = end_;
    return count;
  }

  double rough_slope(double tau) const {
    double sum = 0;
    for (int j = 0; j < D; ++j) {
      const double a = course_.a[j].high, v = course_.v[j].high;
      sum += (course_.x[j].high + tau * (v + tau * a)) * (v + 2 * tau * a);
    }
    return sum;
  }

  /// Where the slope goes through zero from below: Newton in double, kept between the ends by bisection, then
  /// Newton in DoubleDouble.
  DoubleDouble bottom(double low, double high) const {
    double tau = low + 0.5 * (high - low);
    for (int i = 0; i < 100; ++i) {
      const double slope = rough_slope(tau);
      (slope < 0 ? low : high) = tau;
      double next = tau - slope / slope_of_slope(tau);
      if (!(low < next && next < high)) next = low + 0.5 * (high - low);
      const bool settled = std::abs(next - tau) <= 1e-11 * next;
      tau = next;
      if (settled) break;
    }
    return polished(tau);
  }

  DoubleDouble polished(double tau) const {
    DoubleDouble moment{tau, 0};
    for (int i = 0; i < 3; ++i) {
      const double step = -slope(moment).high / slope_of_slope(moment.high);
      // A flat bottom: there the distance hardly depends on the moment, and a step is not to be trusted.
      if (!(std::abs(step) <= 1e-6 * tau)) break;
      moment = moment + DoubleDouble{step, 0};
      if (std::abs(step) < 0x1p-80 * tau) break;
    }
    return moment;
  }

  Course<DoubleDouble, D> course_;
  DoubleDouble begin_, end_;
  bool bent_ = false;
};

}  // namespace

template <int D>
ClosestApproach closest_approach_of(const Setup& setup, const double* row_a, const double* row_b) {
  const auto nearest = Approach<D>(setup, row_a, row_b).nearest();
  const DoubleDouble moment = sum(setup.horizon.now, nearest.tau.high);
  return {moment.high + (moment.low + nearest.tau.low), nearest.tau.high, nearest.distance};
}

template ClosestApproach closest_approach_of<1>(const Setup&, const double*, const double*);
template ClosestApproach closest_approach_of<2>(const Setup&, const double*, const double*);
template ClosestApproach closest_approach_of<3>(const Setup&, const double*, const double*);

}  // namespace foresee
