// Intersection of the sublevel sets {p <= 0} of polynomials in time, as intervals whose ends are known up to
// rounding.
//
//   IntervalUnion intervals;
//   intervals.start({{0, 0}, {600, 600}});                     // the whole queried time
//   intervals.keep(sublevel_intervals(p, lost, 600));          // for each polynomial p that has to be <= 0
//   for (const UncertainInterval& interval : intervals) met |= interval.is_certain();     // surely not empty
//
// Both ends of an uncertain interval are enclosed independently. Guarantee: no time that is possibly in the
// set is lost. An interval may turn out to be empty; then it is not certain. Roots come from the formula
// without cancellation, with error bounds.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "contact/certified/root_bracketing.h"
#include "numbers/coefficients.h"

namespace foresee {

/// A number between two doubles.
struct Enclosure {
  double low, high;

  friend bool operator==(const Enclosure&, const Enclosure&) = default;
  bool meets(const Enclosure& other) const { return low <= other.high && other.low <= high; }
};

/// A closed interval of time; it is empty if its end is before its start.
struct UncertainInterval {
  Enclosure begin, end;

  bool is_possible() const { return begin.low <= end.high; }
  bool is_certain() const { return begin.high <= end.low; }

  static constexpr UncertainInterval always() { return {{-unbounded, -unbounded}, {unbounded, unbounded}}; }
  /// Possibly all times, certainly none.
  static constexpr UncertainInterval in_doubt() { return {{-unbounded, unbounded}, {-unbounded, unbounded}}; }
};

/// The coefficient with its full error bound, from which a sign can be read. `lost`: what underflow takes.
inline Bounded with_lost(const Bounded& c, double lost) {
  return {c.value, c.error_bound(lost)};
}
/// -1 or 1; 0 if the error bound leaves the sign open.
inline int certain_sign(const Bounded& c) {
  return c.value > c.error ? 1 : c.value < -c.error ? -1 : 0;
}
/// An enclosure of the root; infinite if the root may be beyond all doubles.
inline Enclosure enclosure_of(const Bounded& root) {
  const double error = root.error_bound(0x1p-1060) + 4 * unit_roundoff * std::abs(root.value);
  if (!(std::abs(root.value) + error < unbounded)) return {-unbounded, unbounded};
  return {root.value - error, root.value + error};
}

inline UncertainInterval overlap(const UncertainInterval& a, const UncertainInterval& b) {
  return {{std::max(a.begin.low, b.begin.low), std::max(a.begin.high, b.begin.high)},
          {std::min(a.end.low, b.end.low), std::min(a.end.high, b.end.high)}};
}

/// The times at which one polynomial is at most 0: in order, and disjoint where they are certain.
struct SublevelIntervals {
  std::array<UncertainInterval, 2> list;
  int count;

  static SublevelIntervals never() { return {{}, 0}; }
  static SublevelIntervals one(const UncertainInterval& interval) { return {{interval}, 1}; }
};

/// The sublevel set of p0 + p1 s for 0 <= s <= length. Requires: full error bounds (with_lost()).
inline SublevelIntervals sublevel_of_line(const Bounded& p0, const Bounded& p1, double length) {
  const int slope_sign = certain_sign(p1);
  if (slope_sign == 0) {
    const double moved = length * (std::abs(p1.value) + p1.error) * (1 + 0x1p-40);
    const int side = certain_sign({p0.value, p0.error + moved});
    return side > 0 ? SublevelIntervals::never()
                    : SublevelIntervals::one(side < 0 ? UncertainInterval::always()
                                                      : UncertainInterval::in_doubt());
  }
  const Enclosure root = enclosure_of(-p0 / p1);
  return SublevelIntervals::one(slope_sign < 0 ? UncertainInterval{root, UncertainInterval::always().end}
                                               : UncertainInterval{UncertainInterval::always().begin, root});
}

/// The sublevel set for 0 <= s <= length. `lost`: what underflow takes from a coefficient.
inline SublevelIntervals sublevel_intervals(const Coefficients<Bounded, 1>& p, double lost, double length) {
  return sublevel_of_line(with_lost(p[0], lost), with_lost(p[1], lost), length);
}
SublevelIntervals sublevel_intervals(const Coefficients<Bounded, 2>& p, double lost, double length);

/// The sublevel set of a polynomial of degree 4, by steps of certain sign over [queried.begin.low,
/// queried.end.high]. polynomial_at(tau): the coefficients by powers of the time after tau.
template <class PolynomialAt>
SublevelIntervals sublevel_by_steps(PolynomialAt&& polynomial_at, double lost,
                                    const UncertainInterval& queried) {
  const double last = queried.end.high;
  const auto lasts = [&](double side) {
    return [&polynomial_at, side, lost, last](double tau) {
      return positive_during(polynomial_at(tau), side, lost, (last - tau) * (1 + 4 * unit_roundoff));
    };
  };
  const auto is_certain = [&](double side) {
    return [&polynomial_at, side, lost](double tau) {
      const Bounded now = polynomial_at(tau)[0];
      return side * now.value > now.error_bound(lost);
    };
  };
  SublevelIntervals found = SublevelIntervals::never();
  double tau = queried.begin.low;
  while (found.count < 2) {
    Bracket in, out;
    in.before = leap(lasts(1), tau, last);
    if (in.before == unbounded) break;
    UncertainInterval& interval = found.list[static_cast<std::size_t>(found.count++)];
    interval = {{in.before, unbounded}, {-unbounded, unbounded}};
    if (!witness(is_certain(-1), in, in.before, last)) break;
    interval.begin =
        in.after > queried.begin.low ? Enclosure{in.before, in.after} : UncertainInterval::always().begin;
    out.before = leap(lasts(-1), in.after, last);
    interval.end.low = std::min(out.before, unbounded);
    if (out.before == unbounded || !witness(is_certain(1), out, out.before, last)) break;
    interval.end.high = tau = out.after;
  }
  return found;
}

/// Disjoint uncertain intervals in ascending order: what is left of a time after each intersection.
class IntervalUnion {
 public:
  /// Replaces the contents by one interval or by those of another union.
  void start(const UncertainInterval& interval) { list_.assign(1, interval); }
  void start(const IntervalUnion& other) { list_ = other.list_; }
  /// Intersects with the sublevel set of a polynomial.
  void keep(const SublevelIntervals& other) {
    if (list_.size() != 1 || other.count != 1) return keep_each(other);
    list_[0] = overlap(list_[0], other.list[0]);
    if (!list_[0].is_possible()) list_.clear();
  }

  bool empty() const { return list_.empty(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }

 private:
  void keep_each(const SublevelIntervals& other);

  std::vector<UncertainInterval> list_, kept_;
};

}  // namespace foresee
