// Interval bounds of relative position and velocity over all changes of a range, and of the slope of the
// distance.
//
//   const SpreadOfChanges<2> spread(encounter, family);
//   spread.never_shrinks({0, 2}, 0, 5, evaluations)  // during 5 seconds, for every change: a proof
//
// The bounds are tight for narrow ranges. All rounding errors are included, and a 0 has no error.
// Cost: some 20 ns per evaluated time.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/clearance/separating_plane.h"

namespace foresee {

inline constexpr double padding = 0x1p-48;

/// [low, high].
struct EnclosedNumber {
  double low = 0, high = 0;

  /// Sums are padded by the size of their terms; a 0 has no error.
  EnclosedNumber& operator+=(const EnclosedNumber& more) {
    const double size = padding * (std::max(std::abs(low), std::abs(high)) +
                                   std::max(std::abs(more.low), std::abs(more.high)));
    low += more.low - size, high += more.high + size;
    return *this;
  }
};

inline EnclosedNumber operator*(double times, const EnclosedNumber& of) {
  return times >= 0 ? EnclosedNumber{times * of.low, times * of.high}
                    : EnclosedNumber{times * of.high, times * of.low};
}

inline EnclosedNumber product(const EnclosedNumber& a, const EnclosedNumber& b) {
  const double all[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  if (!std::isfinite(all[0] + all[1] + all[2] + all[3]))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  EnclosedNumber of{*std::min_element(all, all + 4), *std::max_element(all, all + 4)};
  of.low -= padding * std::abs(of.low), of.high += padding * std::abs(of.high);
  return of;
}

inline EnclosedNumber square(const EnclosedNumber& a) {
  EnclosedNumber of = product(a, a);
  if (a.low <= 0 && a.high >= 0) of.low = 0;
  if (a.low > 0) of.low = a.low * a.low * (1 - padding);
  if (a.high < 0) of.low = a.high * a.high * (1 - padding);
  return of;
}

/// Consecutive axes that are tested together.
struct AxisRange {
  int begin, end;
};

/// The relative motions of all changes of a range.
template <int D>
class SpreadOfChanges {
 public:
  SpreadOfChanges(const Encounter<D>& encounter, const TrajectoryFamily<D>& family)
      : encounter_(encounter), family_(family) {}

  EnclosedNumber place(int axis, double tau) const {
    EnclosedNumber at{encounter_.x[axis] - encounter_.ex[axis], encounter_.x[axis] + encounter_.ex[axis]};
    if (tau > 0) {
      at += tau * velocity(axis, 0);
      at += 0.5 * tau * tau * acceleration(axis);
    }
    return at;
  }
  EnclosedNumber velocity(int axis, double tau) const {
    const double ev = encounter_.ev[axis], size = ev == 0 ? 0 : 0x1p-52 * std::abs(encounter_.v[axis]);
    EnclosedNumber at = padded(encounter_.v[axis] - ev - family_.upper[1][axis],
                               encounter_.v[axis] + ev - family_.lower[1][axis]);
    at.low -= size;
    at.high += size;
    if (tau > 0) at += tau * acceleration(axis);
    return at;
  }
  EnclosedNumber acceleration(int axis) const {
    return padded(encounter_.a[axis] - family_.upper[2][axis], encounter_.a[axis] - family_.lower[2][axis]);
  }

  /// Half the slope of the squared distance along some axes.
  EnclosedNumber slope(const AxisRange& axes, double tau) const {
    EnclosedNumber sum;
    for (int axis = axes.begin; axis < axes.end; ++axis)
      sum += product(place(axis, tau), velocity(axis, tau));
    if (tau > 0 || axes.end - axes.begin < D) return sum;
    // All changes start at one position.
    const double min_slope = min_of<D>(encounter_.x, encounter_.v, encounter_.ev, family_.all.velocity) -
                             (encounter_.ex * speed()).sum();
    sum.low = std::max(sum.low, min_slope);
    return sum;
  }

  /// Whether the distance along these axes never decreases during [begin, end].
  bool never_shrinks(const AxisRange& axes, double begin, double end, std::uint64_t& evaluations) const {
    double length = end - begin;
    const double shortest = length * 0x1p-80;
    if (!(length > 0)) return !(length < 0);
    for (std::uint64_t parts = 0; parts < max_parts; ++parts, ++evaluations) {
      length = std::min(length, end - begin);
      const EnclosedNumber at_start = slope(axes, begin);
      if (!(at_start.low >= 0)) return false;
      if (!is_positive(axes, at_start.low, begin, length)) {
        length *= 0.5;
        if (length < shortest) return false;
        continue;
      }
      begin += length;
      length *= 2;
      if (begin >= end) return true;
    }
    return false;
  }

  /// Whether no change is farther than `half` from the middle on this axis during [0, end].
  bool remains_within(int axis, double half, double end) const {
    const double size = half * (1 - 0x1p-46);
    const EnclosedNumber x = place(axis, 0), v = velocity(axis, 0), a = acceleration(axis);
    // The object touches at first, so it is inside exactly, and remains inside while it approaches.
    const auto top = [&](double x0, double v0, double a0) {
      if (v0 <= 0 && v0 + 0.5 * end * a0 <= 0) return -size;
      const double last = x0 + end * (v0 + 0.5 * end * a0);
      const double turn = a0 < 0 && v0 > 0 && v0 < -a0 * end ? x0 - 0.5 * v0 * (v0 / a0) : x0;
      return std::max({x0, last, turn}) +
             padding * (std::abs(x0) + end * (std::abs(v0) + end * std::abs(a0)));
    };
    return top(x.high, v.high, a.high) <= size && top(-x.low, -v.low, -a.low) <= size;
  }
  /// Whether no change is farther than `radius` from the middle on the first two axes during [0, end].
  bool remains_within_disc(double radius, double end, std::uint64_t& evaluations) const {
    double begin = 0, length = end;
    const double shortest = end * 0x1p-10;
    // The object touches at first, so it is inside, and remains inside while it approaches.
    const AxisRange axes{0, std::min(D, 2)};
    for (double nearer = end; nearer > shortest && begin == 0; nearer *= 0.5)
      if (never_grows_at_first(axes, nearer)) begin = nearer;
    for (std::uint64_t parts = 0; begin < end; ++parts, ++evaluations) {
      length = std::min(length, end - begin);
      if (parts == max_parts || !(length > 0)) return false;
      if (is_within_disc(radius * radius * (1 - 0x1p-44), begin, length)) {
        begin += length;
        length *= 2;
      } else {
        length *= 0.5;
      }
    }
    return true;
  }

 private:
  static constexpr std::uint64_t max_parts = 160;
  /// A difference of two doubles, with its rounding error.
  static EnclosedNumber padded(double low, double high) {
    return {low - 0x1p-52 * std::abs(low), high + 0x1p-52 * std::abs(high)};
  }
  /// Whether the distance never increases during [0, length]: the polynomial of is_positive(), from above.
  bool never_grows_at_first(const AxisRange& axes, double length) const {
    const double c0 = slope(axes, 0).high;
    if (!(c0 <= 0)) return false;
    EnclosedNumber c1, c2, c3;
    find_coefficients(axes, 0, c1, c2, c3);
    const double b1 = c1.high * length / 3, b2 = c2.high * length / 3 * length,
                 b3 = c3.high * length * length * length;
    const double size = padding * (std::abs(b1) + std::abs(b2) + std::abs(b3));
    return c0 + b1 + size <= 0 && c0 + 2 * b1 + b2 + size <= 0 && c0 + 3 * b1 + 3 * b2 + b3 + 8 * size <= 0;
  }
  void find_coefficients(const AxisRange& axes, double begin, EnclosedNumber& c1, EnclosedNumber& c2,
                         EnclosedNumber& c3) const {
    for (int axis = axes.begin; axis < axes.end; ++axis) {
      const EnclosedNumber x = place(axis, begin), v = velocity(axis, begin), a = acceleration(axis);
      c1 += square(v);
      c1 += product(x, a);
      c2 += 1.5 * product(v, a);
      c3 += 0.5 * square(a);
    }
  }
  Vec<D> speed() const {
    return family_.upper[1].abs().max(family_.lower[1].abs()) + encounter_.v.abs() + encounter_.ev;
  }

  /// c0 + c1 s + c2 s^2 + c3 s^3 >= 0 during [0, length]: so is the smallest coefficient of its Bernstein
  /// form.
  bool is_positive(const AxisRange& axes, double c0, double begin, double length) const {
    EnclosedNumber c1, c2, c3;
    find_coefficients(axes, begin, c1, c2, c3);
    const double b1 = c1.low * length / 3, b2 = c2.low * length / 3 * length,
                 b3 = c3.low * length * length * length;
    const auto is_above = [](double sum, double size) { return sum - padding * size >= 0; };
    const double first = std::abs(b1), second = 2 * first + std::abs(b2), third = 3 * second + std::abs(b3);
    return is_above(c0 + b1, first) && is_above(c0 + 2 * b1 + b2, second) &&
           is_above(c0 + 3 * b1 + 3 * b2 + b3, 2 * third);
  }

  /// Whether the squared distance in x and y is not above `square` during these times: the Bernstein form of the
  /// difference.
  bool is_within_disc(double square_reach, double begin, double length) const {
    const AxisRange axes{0, std::min(D, 2)};
    EnclosedNumber c0, c1, c2, c3, c4;
    for (int axis = axes.begin; axis < axes.end; ++axis) {
      const EnclosedNumber x = place(axis, begin), v = velocity(axis, begin), a = acceleration(axis);
      c0 += square(x);
      c1 += 2 * product(x, v);
      c2 += square(v);
      c2 += product(x, a);
      c3 += product(v, a);
      c4 += 0.25 * square(a);
    }
    const double b1 = c1.high * length / 4, b2 = c2.high * length / 6 * length,
                 b3 = c3.high * length / 4 * length * length,
                 b4 = c4.high * length * length * length * length;
    const double size =
        padding * (std::abs(c0.high) + 4 * std::abs(b1) + 6 * std::abs(b2) + 4 * std::abs(b3) + b4);
    const auto is_below = [&](double sum) { return sum + size <= square_reach; };
    return is_below(c0.high) && is_below(c0.high + b1) && is_below(c0.high + 2 * b1 + b2) &&
           is_below(c0.high + 3 * b1 + 3 * b2 + b3) && is_below(c0.high + 4 * b1 + 6 * b2 + 4 * b3 + b4);
  }

  const Encounter<D>& encounter_;
  const TrajectoryFamily<D>& family_;
};

}  // namespace foresee
