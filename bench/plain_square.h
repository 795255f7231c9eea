// First time at which a distance falls to a radius: the square of the distance as a polynomial in plain
// double, without error bounds.
//
//   PlainSquare<2> f(-r * r);                       // accelerated: |x + v t + turn t^2|^2 - r^2 has degree 4
//   for (int j = 0; j < 2; ++j) f.add(pair.x(j), pair.v(j), pair.turn(j));
//   const double t = f.first_within<true>(0, 3);    // -1: never
//
// Degree two has a formula. In degree four a minimum is a zero of the slope where the slope ascends, between
// the roots of the second derivative. The first root lies before the first minimum that is not above zero.
// Newton's method finds both, kept within its bracket. Maxima are not computed.
#pragma once

#include <cmath>
#include <initializer_list>

namespace foresee::bench {

template <int Degree>
class PlainSquare {
 public:
  explicit PlainSquare(double constant) : c_{constant} {}

  /// Adds the square of one axis.
  void add(double x, double v, double turn) {
    c_[0] += x * x;
    c_[1] += 2 * x * v;
    c_[2] += v * v;
    if constexpr (Degree == 2) {
      c_[2] += 2 * x * turn;
      c_[3] += 2 * v * turn;
      c_[4] += turn * turn;
    }
  }

  /// The first time in [begin, end] at which the polynomial is not above zero, or -1. Not timed: some such
  /// time.
  template <bool Timed>
  double first_within(double begin, double end) const {
    if (value(begin) <= 0) return begin;
    if constexpr (Degree == 1)
      return first_root(begin, end);
    else
      return first_fall<Timed>(begin, end);
  }

 private:
  double value(double t) const {
    double sum = c_[2 * Degree];
    for (int k = 2 * Degree - 1; k >= 0; --k) sum = sum * t + c_[k];
    return sum;
  }
  double slope(double t) const { return c_[1] + t * (2 * c_[2] + t * (3 * c_[3] + t * 4 * c_[4])); }
  double bend(double t) const { return 2 * c_[2] + t * (6 * c_[3] + t * 12 * c_[4]); }

  double first_root(double begin, double end) const {
    const double under_root = c_[1] * c_[1] - 4 * c_[2] * c_[0];
    if (c_[2] == 0 || under_root < 0) return -1;
    const double t = (-c_[1] - std::sqrt(under_root)) * 0.5 / c_[2];
    return begin <= t && t <= end ? t : -1;
  }

  template <bool Timed>
  double first_fall(double begin, double end) const {
    double low = begin;  // above zero up to here
    for (const double high :
         {clamp(turn_of_slope(-1), begin, end), clamp(turn_of_slope(1), begin, end), end}) {
      if (high <= low) continue;
      double reached = high;
      if (slope(low) < 0 && slope(high) > 0)  // a minimum between them
        reached =
            crossing([this](double t) { return slope(t); }, [this](double t) { return bend(t); }, low, high);
      if (value(reached) <= 0) {
        if (!Timed) return reached;
        return crossing([this](double t) { return -value(t); }, [this](double t) { return -slope(t); }, low,
                        reached);
      }
      low = high;
    }
    return -1;
  }

  /// Where the second derivative, a parabola that opens upward, is zero; NaN where it has no zero.
  double turn_of_slope(int sign) const {
    const double a = 6 * c_[4], half_b = 1.5 * c_[3], c = c_[2];  // half of it is a t^2 + 2 half_b t + c
    return (-half_b + sign * std::sqrt(half_b * half_b - a * c)) / a;
  }
  static double clamp(double t, double begin, double end) {
    return t > begin ? (t < end ? t : end) : begin;  // NaN: the start
  }

  /// The place between low and high where f ascends through zero.
  template <class F, class Slope>
  static double crossing(F&& f, Slope&& slope, double low, double high) {
    constexpr double close = 0x1p-50;
    double t = 0.5 * (low + high);
    for (int step = 0; step < 100; ++step) {
      const double now = f(t), newton = t - now / slope(t);
      if (std::abs(newton - t) <= close * high) return t;
      (now < 0 ? low : high) = t;
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (next == t) return t;
      t = next;
    }
    return t;
  }

  double c_[2 * Degree + 1];
};

}  // namespace foresee::bench
