// When are polynomials certainly, and when possibly, at most 0 together? Stays: stretches of time whose ends
// are known up to rounding.
//
//   Stays stays;
//   stays.start({{0, 0}, {600, 600}});                     // all of what is asked about
//   stays.keep(times_inside(p, lost, 600));                      // for each polynomial p that has to be <= 0
//   for (const Stay& stay : stays) met |= stay.is_certain();     // surely not empty
//
// The two ends are enclosed apart from each other. Nothing possible is ever lost: a stay may turn out not to
// be one, and then it is not certain. Roots come from the formula that does not cancel, with error bounds.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/certain/leaps.h"
#include "numbers/powers.h"

namespace foresee {

struct Enclosure {
  double low, high;

  bool meets(const Enclosure& other) const { return low <= other.high && other.low <= high; }
};

/// Closed.
struct Stay {
  Enclosure begin, end;

  bool is_possible() const { return begin.low <= end.high; }
  bool is_certain() const { return begin.high <= end.low; }

  static constexpr double inf = std::numeric_limits<double>::infinity();
  static constexpr Stay always() { return {{-inf, -inf}, {inf, inf}}; }
  /// Possibly always, certainly never.
  static constexpr Stay in_doubt() { return {{-inf, inf}, {-inf, inf}}; }
};

/// The error in full, so that signs can be read from it.
inline Bounded with_lost(const Bounded& c, double lost) {
  return {c.value, c.error_bound(lost)};
}
/// -1, 1, or 0 where the error leaves it open.
inline int certain_sign(const Bounded& c) {
  return c.value > c.error ? 1 : c.value < -c.error ? -1 : 0;
}
/// Infinite where no double is near.
inline Enclosure enclosure_of(const Bounded& root) {
  const double error = root.error_bound(0x1p-1060) + 4 * unit_roundoff * std::abs(root.value);
  if (!(std::abs(root.value) + error < Stay::inf)) return {-Stay::inf, Stay::inf};
  return {root.value - error, root.value + error};
}

inline Stay overlap(const Stay& a, const Stay& b) {
  return {{std::max(a.begin.low, b.begin.low), std::max(a.begin.high, b.begin.high)},
          {std::min(a.end.low, b.end.low), std::min(a.end.high, b.end.high)}};
}

/// When one polynomial is at most 0: in order, and apart from each other where it is certain.
struct Inside {
  std::array<Stay, 2> list;
  int count;

  static Inside never() { return {{}, 0}; }
  static Inside one(const Stay& stay) { return {{stay}, 1}; }
};

/// Of p0 + p1 s, with the errors in full: for 0 <= s <= length.
inline Inside inside_line(const Bounded& p0, const Bounded& p1, double length) {
  const int way = certain_sign(p1);
  if (way == 0) {
    const double moved = length * (std::abs(p1.value) + p1.error) * (1 + 0x1p-40);
    const int side = certain_sign({p0.value, p0.error + moved});
    return side > 0 ? Inside::never() : Inside::one(side < 0 ? Stay::always() : Stay::in_doubt());
  }
  const Enclosure root = enclosure_of(-p0 / p1);
  return Inside::one(way < 0 ? Stay{root, Stay::always().end} : Stay{Stay::always().begin, root});
}

/// For 0 <= s <= length; `lost`: what underflow takes from a coefficient.
inline Inside times_inside(const Powers<Bounded, 1>& p, double lost, double length) {
  return inside_line(with_lost(p[0], lost), with_lost(p[1], lost), length);
}
Inside times_inside(const Powers<Bounded, 2>& p, double lost, double length);

/// The same for degree 4, which has no formula: in leaps over [asked.begin.low, asked.end.high].
/// polynomial_at(tau): by powers of the time after tau.
template <class PolynomialAt>
Inside inside_by_leaps(PolynomialAt&& polynomial_at, double lost, const Stay& asked);

class Stays {
 public:
  /// Begins anew, with one stay or with those of another.
  void start(const Stay& stay) { list_.assign(1, stay); }
  void start(const Stays& other) { list_ = other.list_; }
  /// What is in both.
  void keep(const Inside& other) {
    if (list_.size() != 1 || other.count != 1) return keep_each(other);
    list_[0] = overlap(list_[0], other.list[0]);
    if (!list_[0].is_possible()) list_.clear();
  }

  bool empty() const { return list_.empty(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }

 private:
  void keep_each(const Inside& other);

  std::vector<Stay> list_, kept_;
};

template <class PolynomialAt>
Inside inside_by_leaps(PolynomialAt&& polynomial_at, double lost, const Stay& asked) {
  const double last = asked.end.high;
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
  Inside found = Inside::never();
  double tau = asked.begin.low;
  while (found.count < 2) {
    Bracket in, out;
    in.before = leap(lasts(1), tau, last);
    if (in.before == for_ever) break;
    Stay& stay = found.list[static_cast<std::size_t>(found.count++)];
    stay = {{in.before, Stay::inf}, {-Stay::inf, Stay::inf}};
    if (!witness(is_certain(-1), in, in.before, last)) break;
    stay.begin = in.after > asked.begin.low ? Enclosure{in.before, in.after} : Stay::always().begin;
    out.before = leap(lasts(-1), in.after, last);
    stay.end.low = std::min(out.before, Stay::inf);
    if (out.before == for_ever || !witness(is_certain(1), out, out.before, last)) break;
    stay.end.high = tau = out.after;
  }
  return found;
}

}  // namespace foresee
