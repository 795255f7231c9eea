#include "numbers/sine_cosine.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace foresee {

namespace {

Midrad number(double value, int bits) {
  return {Dyadic(value), bits};
}

/// 2^bits arc tan(1 / n) = 2^bits (1/n - 1/(3 n^3) + 1/(5 n^5) - ...), off by less than `bits`. Each term has
/// two divisions, each off by less than 1, and is at least 16 times smaller than the term before it.
Integer arc_tangent_of_inverse(int n, int bits) {
  Integer power = (Integer(1) << bits) / n, sum = power;
  for (int k = 1; !power.is_zero(); ++k) {
    power /= n * n;
    sum += (k % 2 == 0 ? power : Integer(-power)) / (2 * k + 1);
  }
  return sum;
}

/// pi / 180, by Machin's formula: pi / 4 = 4 arc tan(1/5) - arc tan(1/239)
Midrad radians_of_degree(int bits) {
  const Integer quarter = 4 * arc_tangent_of_inverse(5, bits) - arc_tangent_of_inverse(239, bits);
  const Integer off = 5 * bits;
  return Midrad::hull({quarter - off, -bits}, {quarter + off, -bits}, bits) / number(45, bits);
}

Midrad128 in_128_bits(const Midrad& positive) {
  return Midrad128::hull(Midrad128(positive.low()), Midrad128(positive.high()));
}

/// Taylor's series of `terms` terms. Requires: inverse(n) = 1 / (n (n - 1)); |angle| < 1.
template <class T, class Inverse>
SineCosine<T> series(const T& angle, int terms, const T& one, const T& half_to_one, const Inverse& inverse) {
  const T square = angle * angle;
  SineCosine<T> sums{half_to_one, half_to_one};
  for (int n = 2 * terms; n > 0; n -= 2) {
    sums.sine = one - square * inverse(n + 1) * sums.sine;
    sums.cosine = one - square * inverse(n) * sums.cosine;
  }
  return {angle * sums.sine, sums.cosine};
}

/// Sines and cosines of the multiples of a step, computed once; every angle is near one of them.
class SineTable {
 public:
  static constexpr int steps = 64;
  static constexpr double step = 45.0 / steps;  // exact, like its multiples

  SineTable() {
    const Midrad128 one(1.0), half_to_one = Midrad128::hull(Midrad128(0.5), one);
    const auto inverse = [&](int n) { return one / Midrad128(static_cast<double>(n) * (n - 1)); };
    for (int k = 0; k <= steps; ++k)
      multiples_[at(k)] = series(angle(k * step), 16, one, half_to_one, inverse);
    inverse_factorials_ = {one, one};
    for (int n = 2; n < 2 * terms + 2; ++n)
      inverse_factorials_[at(n)] = inverse_factorials_[at(n - 1)] / Midrad128(n);
    for (const int n : {2 * terms, 2 * terms + 1})
      inverse_factorials_[at(n)] = inverse_factorials_[at(n)] * half_to_one;
  }

  SineCosine<Midrad128> of(double degrees) const {
    const double k = std::rint(std::abs(degrees) / step);
    const SineCosine<Midrad128>& table = multiples_[at(static_cast<int>(k))];
    const SineCosine<Midrad128> rest =
        near_zero(std::abs(degrees) - k * step);  // exact: they are near each other
    const Midrad128 sine = table.sine * rest.cosine + table.cosine * rest.sine;
    return {degrees < 0 ? -sine : sine, table.cosine * rest.cosine - table.sine * rest.sine};
  }

 private:
  static constexpr int terms = 6;  // (step / 2)^12 in radians is below 2^-87, and 1 / 12! below 2^-28

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  Midrad128 angle(double degrees) const { return degree_ * Midrad128(degrees); }

  /// 1 - x^2/2! + x^4/4! - ..., where the factor of the last term is only known to lie in [1/2, 1].
  SineCosine<Midrad128> near_zero(double degrees) const {
    const Midrad128 x = angle(degrees), square = x * x;
    Midrad128 sine = inverse_factorials_[at(2 * terms + 1)], cosine = inverse_factorials_[at(2 * terms)];
    for (int n = 2 * terms - 2; n >= 0; n -= 2) {
      sine = inverse_factorials_[at(n + 1)] - square * sine;
      cosine = inverse_factorials_[at(n)] - square * cosine;
    }
    return {x * sine, cosine};
  }

  Midrad128 degree_ = in_128_bits(radians_of_degree(256));
  std::array<SineCosine<Midrad128>, steps + 1> multiples_;
  std::array<Midrad128, 2 * terms + 2> inverse_factorials_;  ///< the last two times [1/2, 1]: the remainder
};

}  // namespace

SineCosine<Midrad128> sine_cosine(double degrees) {
  static const SineTable table;
  return table.of(degrees);
}

SineCosine<Midrad> sine_cosine(double degrees, int bits) {
  // A quarter as many terms as bits: enough also for the crude error bounds, which are powers of two.
  return series(radians_of_degree(bits) * number(degrees, bits), bits / 4, number(1, bits),
                Midrad::hull(Dyadic(0.5), Dyadic(1.0), bits),
                [bits](int n) { return number(1, bits) / number(static_cast<double>(n) * (n - 1), bits); });
}

}  // namespace foresee
