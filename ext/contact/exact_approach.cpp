#include "contact/exact_approach.h"

#include <cmath>

#include "contact/roots.h"

namespace foresee {
namespace {

/// The double nearest to the square root, ties to even.
double rounded_square_root(const Dyadic& square) {
  if (square.sign() <= 0) return 0;
  // 128 bits or one less, so that the exponent is even; what is cut off only has to be known to exist.
  const int bits = static_cast<int>(msb(square.mantissa())) + 1;
  int shift = 128 - bits;
  if ((square.exponent() - shift) % 2 != 0) --shift;
  const Integer head =
      shift >= 0 ? Integer(square.mantissa() << shift) : Integer(square.mantissa() >> -shift);
  Integer rest;
  const Integer root = sqrt(head, rest);
  const bool more = !rest.is_zero() || (shift < 0 && Integer(head << -shift) != square.mantissa());
  return rounded(Dyadic((root << 1) + (more ? 1 : 0), (square.exponent() - shift) / 2 - 1));
}

Dyadic value_at(const SquaredDistance& square, const Dyadic& tau) {
  Dyadic value;
  for (int k = Polynomial::most; k >= 0; --k) value = value * tau + square[k];
  return value;
}

/// The sign of the squared distance minus `limit` where the root is.
int sign_beyond(const SquaredDistance& square, const Dyadic& limit, Root& root) {
  SquaredDistance difference = square;
  difference[0] = square[0] - limit;
  return root.sign_of(Polynomial(difference));
}

/// A number not above the least value around `root`, by Taylor's formula from its low side.
Dyadic less_than_least(const SquaredDistance& square, const Root& root) {
  const Dyadic &low = root.low(), &high = root.high();
  Dyadic slope, bend;  // at low; a bound on half the second derivative's magnitude up to high
  for (int k = Polynomial::most; k >= 1; --k) slope = slope * low + square[k] * Dyadic(k);
  for (int k = Polynomial::most; k >= 2; --k) {
    const Dyadic term = square[k] * Dyadic(k * (k - 1) / 2);
    bend = bend * high + (term.sign() < 0 ? -term : term);
  }
  const Dyadic width = high - low;
  const Dyadic fall = slope.sign() < 0 ? slope * width : Dyadic();
  return value_at(square, low) + fall - bend * width * width;
}

/// The distance at a minimum of its square, rounded once.
double distance_at(const SquaredDistance& square, Root& root) {
  for (int round = 0;; ++round) {
    const Dyadic at_low = value_at(square, root.low());
    if (root.exact()) return rounded_square_root(at_low);
    const double least = rounded_square_root(less_than_least(square, root));
    if (least == 0 && round == 0 && root.sign_of(Polynomial(square)) == 0) return 0;
    const double most = rounded_square_root(at_low);
    if (least == most) return least;
    if (std::nextafter(least, most) == most) {
      // Infinity stands for 2^1024, as rounding has it.
      const Dyadic above = std::isfinite(most) ? Dyadic(most) : Dyadic::power_of_two(1024);
      const Dyadic tie = half_of(Dyadic(least) + above);
      const int side = sign_beyond(square, tie * tie, root);
      return side < 0 ? least : side > 0 ? most : rounded(tie);
    }
    root.narrow(round);
  }
}

class ExactApproach {
 public:
  ExactApproach(const SquaredDistance& square, const ExactMoments& moments)
      : square_(square), moments_(moments), slope_(derivative(Polynomial(square))) {}

  ClosestApproach nearest() {
    const Moments& m = moments_.rounded;
    const std::vector<Place> minima = this->minima();
    Place best = minima.front();
    if (minima.size() == 2 && second_is_nearer(minima[0], minima[1])) best = minima[1];
    if (best == at_begin)
      return {m.t_begin, m.dt_begin, rounded_square_root(value_at(square_, moments_.begin))};
    if (best == at_end) return {m.t_end, m.dt_end, rounded_square_root(value_at(square_, moments_.end))};
    Root& root = roots_[best];
    const double dt = root.rounded_with(Dyadic()), t = root.rounded_with(moments_.now);
    return {t, dt, distance_at(square_, root)};
  }

 private:
  using Place = int;  ///< the number of a root, or an end
  static constexpr Place at_begin = -1, at_end = -2;

  /// Where the squared distance has fallen before and rises after, in order of time: one or two, as its slope
  /// is a cubic.
  std::vector<Place> minima() {
    if (slope_.degree < 0 || !(moments_.begin < moments_.end)) return {at_begin};
    std::vector<Place> minima;
    int side = descartes(slope_, moments_.begin, moments_.end).first;
    if (side > 0) minima.push_back(at_begin);
    roots_ = roots_between(slope_, moments_.begin, moments_.end, square_free_part_);
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      const int after = sign_after(roots_[i]);
      if (side < 0 && after > 0) minima.push_back(static_cast<Place>(i));
      side = after;
    }
    if (side < 0) minima.push_back(at_end);
    return minima;
  }

  /// Of the slope: the sign of its first derivative that is not zero at the root.
  int sign_after(Root& root) const {
    int sign = 0;
    for (Polynomial p = derivative(slope_); sign == 0; p = derivative(p)) sign = root.sign_of(p);
    return sign;
  }

  bool second_is_nearer(Place first, Place second) {
    if (first == at_begin) {
      const Dyadic at_first = value_at(square_, moments_.begin);
      if (second == at_end) return value_at(square_, moments_.end) < at_first;
      return sign_beyond(square_, at_first, roots_[second]) < 0;
    }
    if (second == at_end) return sign_beyond(square_, value_at(square_, moments_.end), roots_[first]) > 0;
    // Two minima with a maximum between them. Of c0 + c1 t + c2 t^2 + c3 t^3 with three roots, the integral
    // between the outer ones is negative just if the value at the mean of the roots, -c2 / (3 c3), is.
    const Integer &c0 = slope_.c[0], &c1 = slope_.c[1], &c2 = slope_.c[2], &c3 = slope_.c[3];
    return Integer(2 * c2 * c2 * c2 - 9 * c1 * c2 * c3 + 27 * c0 * c3 * c3).sign() < 0;
  }

  const SquaredDistance& square_;
  const ExactMoments& moments_;
  Polynomial slope_, square_free_part_;
  std::vector<Root> roots_;
};

}  // namespace

ClosestApproach exact_approach(const SquaredDistance& square, const ExactMoments& moments) {
  return ExactApproach(square, moments).nearest();
}

}  // namespace foresee
