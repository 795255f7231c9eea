// The judge of the unit tests of numbers/: exact rational numbers of Boost, the double nearest to one, and
// seeded inputs.
//
//   EXPECT_EQ(rounded(Dyadic(1.0) + Dyadic(0x1p-53)), nearest_double(rational(1.0) + power_of_two(-53)));
//
// Nothing here computes as numbers/ does: the nearest double is searched among all doubles by comparisons.
// FORESEE_LONG=1: fifty times the cases.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <vector>

#include "numbers/dyadic.h"
#include "numbers/midrad.h"
#include "numbers/midrad_128.h"
#include "scenes.h"

namespace foresee::judge {

using Whole = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

inline int cases(int count) {
  return std::getenv("FORESEE_LONG") ? 50 * count : testing::sanitized ? (count + 19) / 20 : count;
}

inline Rational power_of_two(int exponent) {
  const Whole power = Whole(1) << std::abs(exponent);
  return exponent >= 0 ? Rational(power) : Rational(Whole(1), power);
}
inline Rational rational(const Dyadic& number) {
  return Rational(Whole(number.mantissa())) * power_of_two(number.exponent());
}
inline Rational rational(double number) {
  int exponent;
  const double fraction = std::frexp(number, &exponent);
  return Rational(static_cast<std::int64_t>(std::ldexp(fraction, 53))) * power_of_two(exponent - 53);
}
inline Rational low_of(const Midrad128& ball) {
  return rational(ball.low().dyadic());
}
inline Rational high_of(const Midrad128& ball) {
  return rational(ball.high().dyadic());
}
inline Rational low_of(const Midrad& ball) {
  return rational(ball.low());
}
inline Rational high_of(const Midrad& ball) {
  return rational(ball.high());
}

template <class Ball>
bool holds(const Ball& ball, const Rational& number) {
  return low_of(ball) <= number && number <= high_of(ball);
}
template <class Ball>
Rational width_of(const Ball& ball) {
  return high_of(ball) - low_of(ball);
}

/// The doubles in order, by whole numbers; 0 stands for both zeros.
inline double double_at(std::int64_t place) {
  return place >= 0 ? std::bit_cast<double>(place) : -std::bit_cast<double>(-place);
}
inline constexpr std::int64_t place_of_infinity = 0x7ff0000000000000;

/// The double nearest to a number, ties to even; infinity stands for 2^1024.
inline double nearest_double(const Rational& number) {
  const auto exact = [](std::int64_t place) {
    const Rational beyond = power_of_two(1024);
    if (std::abs(place) == place_of_infinity) return place > 0 ? beyond : Rational(-beyond);
    return rational(double_at(place));
  };
  std::int64_t below = -place_of_infinity, above = place_of_infinity;
  if (number <= exact(below)) return double_at(below);
  if (number >= exact(above)) return double_at(above);
  while (below + 1 < above) {
    const std::int64_t middle = std::midpoint(below, above);
    (exact(middle) <= number ? below : above) = middle;
  }
  const int side = Rational(2 * number).compare(exact(below) + exact(above));
  return double_at(side < 0 ? below : side > 0 ? above : below % 2 == 0 ? below : above);
}

class Inputs {
 public:
  explicit Inputs(std::uint64_t seed) : random_(seed) {}

  int below(int bound) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(bound))); }
  int between(int lower, int upper) { return lower + below(upper - lower + 1); }
  bool one_in(int times) { return below(times) == 0; }
  double sign() { return one_in(2) ? 1 : -1; }

  /// 53 random bits, now and then fewer; its magnitude is between the two exponents.
  double number(int lower, int upper) {
    double digits = 1 + random_.unit();
    if (one_in(4)) digits = 1 + below(16) * 0x1p-4;
    return sign() * std::ldexp(digits, between(lower, upper));
  }
  /// From the whole range of doubles.
  double any_double() {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double edges[] = {0.0, -0.0, 5e-324, 0x1p-1022, 0x1.fffffffffffffp-1023, 1, 0x1p53, largest};
    if (one_in(8)) return sign() * edges[below(std::size(edges))];
    return sign() * double_at(static_cast<std::int64_t>(random_.below(place_of_infinity)));
  }
  /// Up to a few hundred bits, now and then 0.
  Dyadic dyadic(int lower = -150, int upper = 150) {
    Dyadic sum;
    if (one_in(20)) return sum;
    for (int i = below(6); i >= 0; --i) sum = sum + Dyadic(number(lower, upper));
    return sum;
  }

 private:
  testing::Random random_;
};

}  // namespace foresee::judge
