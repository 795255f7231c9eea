#include <algorithm>
#include <cmath>

#include "contact/exact/exact_contact.h"
#include "numbers/correct_rounding.h"
#include "numbers/interval_newton.h"
#include "numbers/time_intervals.h"

namespace foresee {
namespace {

/// A LazyPolynomial of given exact coefficients.
class KnownPolynomial final : public PolynomialSource {
 public:
  explicit KnownPolynomial(const SquaredDistance& c) : exact_(c), polynomial_(rough(c), *this, 0) {}

  Polynomial exact_polynomial(int /*number*/) const override { return exact_; }
  const Polynomial& exact() const { return exact_; }
  LazyPolynomial& polynomial() { return polynomial_; }

 private:
  static LazyPolynomial::RoughCoefficients rough(const SquaredDistance& c) {
    LazyPolynomial::RoughCoefficients rough;
    std::transform(c.begin(), c.end(), rough.begin(), [](const Dyadic& d) { return Midrad128(d); });
    return rough;
  }

  Polynomial exact_;
  LazyPolynomial polynomial_;
};

class ExactApproach {
 public:
  ExactApproach(const SquaredDistance& square, const ExactLifetime& lifetime)
      : square_(square), lifetime_(lifetime), known_(square), begin_(lifetime.begin), end_(lifetime.end) {}

  ClosestApproach nearest() {
    const PairLifetime& m = lifetime_.rounded;
    const auto [first, second] = minima();
    AlgebraicRoot& best = second && second_is_nearer(*first, *second) ? *second : *first;
    const double distance = distance_at(best);
    if (&best == &begin_) return {m.t_start, m.dt_start, distance};
    if (&best == &end_) return {m.t_end, m.dt_end, distance};
    return {rounded(best, lifetime_.now), rounded(best, Dyadic()), distance};
  }

 private:
  struct Minima {
    AlgebraicRoot *first = nullptr, *second = nullptr;
    void add(AlgebraicRoot& time) { (first ? second : first) = &time; }
  };

  /// The local minima of the squared distance in order of time: one or two, because its slope is a cubic.
  Minima minima() {
    Minima minima;
    if (slope().degree() < 0 || !(lifetime_.begin < lifetime_.end)) return {&begin_};
    int side = slope_after(begin_);
    if (side > 0) minima.add(begin_);
    const Roots turns = zeros_within(slope(), {begin_, end_});
    for (int i = 0; i < turns.count; ++i) {
      const int after = slope_after(*turns.list[i]);
      if (side < 0 && after > 0) minima.add(*turns.list[i]);
      side = after;
    }
    if (side < 0) minima.add(end_);
    return minima;
  }

  LazyPolynomial& slope() { return known_.polynomial().slope(); }

  /// The sign of the slope just after a time: that of its first derivative that is not zero there.
  int slope_after(AlgebraicRoot& time) {
    LazyPolynomial* polynomial = &slope();
    int sign = polynomial->sign_at(time);
    for (; sign == 0; sign = polynomial->sign_at(time)) polynomial = &polynomial->slope();
    return sign;
  }

  /// The sign of the squared distance minus `limit`.
  int sign_beyond(const Dyadic& limit, AlgebraicRoot& time) const {
    SquaredDistance difference = square_;
    difference[0] = square_[0] - limit;
    KnownPolynomial beyond(difference);
    return beyond.polynomial().sign_at(time);
  }

  bool second_is_nearer(AlgebraicRoot& first, AlgebraicRoot& second) const {
    const Polynomial& p = known_.exact();
    if (first.known) return sign_beyond(value_at(p, *first.known), second) < 0;
    if (second.known) return sign_beyond(value_at(p, *second.known), first) > 0;
    // Two minima with a maximum between them. Of c0 + c1 t + c2 t^2 + c3 t^3 with three roots, the integral
    // between the outer ones is negative just if the value at the mean of the roots, -c2 / (3 c3), is.
    const Polynomial slope = derivative(p);
    const Dyadic &c0 = slope.c[0], &c1 = slope.c[1], &c2 = slope.c[2], &c3 = slope.c[3];
    const Dyadic two(2.0), nine(9.0), twenty_seven(27.0);
    return (two * c2 * c2 * c2 - nine * c1 * c2 * c3 + twenty_seven * c0 * c3 * c3).sign() < 0;
  }

  /// The distance at an end or a root of the slope, rounded once.
  double distance_at(AlgebraicRoot& time) {
    if (time.known) return rounded_root(value_at(known_.exact(), *time.known));
    if (known_.polynomial().sign_at(time) == 0) return 0;
    for (int bits = first_length;; bits *= 2) {
      const Polynomial& p = known_.exact();
      const Midrad square = value_at(known_.polynomial().enclosure(bits), p.degree, time.enclosure(bits));
      const double lower = rounded_root(square.low()), upper = rounded_root(square.high());
      if (lower == upper) return lower;
      if (std::nextafter(lower, upper) != upper) continue;
      // Rounding treats infinity as 2^1024.
      const Dyadic above = std::isfinite(upper) ? Dyadic(upper) : Dyadic::power_of_two(1024);
      const Dyadic tie = half_of(Dyadic(lower) + above);
      const int side = sign_beyond(tie * tie, time);
      return side < 0 ? lower : side > 0 ? upper : rounded(tie);
    }
  }

  const SquaredDistance& square_;
  const ExactLifetime& lifetime_;
  KnownPolynomial known_;
  AlgebraicRoot begin_, end_;
};

}  // namespace

ClosestApproach exact_approach(const SquaredDistance& square, const ExactLifetime& lifetime) {
  return ExactApproach(square, lifetime).nearest();
}

}  // namespace foresee
