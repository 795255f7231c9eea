#include "numbers/sine_cosine.h"

#include <array>
#include <cstddef>

namespace foresee::numbers {

namespace {

Midrad number(double value, int bits) {
  return {Dyadic(value), bits};
}

/// 2^bits arc tan(1 / n) = 2^bits (1/n - 1/(3 n^3) + 1/(5 n^5) - ...), off by less than `bits`: two divisions
/// a term, each off by less than 1, and no term is less than 16 times smaller than the one before it.
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

/// The series, `terms` deep. Requires: inverse(n) = 1 / (n (n - 1)); |angle| < 1.
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

/// What the series takes in 128 bits, computed once.
struct SeriesNumbers {
  static constexpr int terms = 14;  // the last is 45 degrees to the power of 28 by 28!, below 2^-107

  Midrad128 degree = in_128_bits(radians_of_degree(256));
  Midrad128 one{1.0}, half_to_one = Midrad128::hull(Midrad128(0.5), Midrad128(1.0));
  std::array<Midrad128, 2 * terms + 2> inverses;

  SeriesNumbers() {
    for (std::size_t n = 2; n < inverses.size(); ++n)
      inverses[n] = one / Midrad128(static_cast<double>(n * (n - 1)));
  }
};

}  // namespace

SineCosine<Midrad128> sine_cosine(double degrees) {
  static const SeriesNumbers numbers;
  return series(numbers.degree * Midrad128(degrees), SeriesNumbers::terms, numbers.one, numbers.half_to_one,
                [](int n) -> const Midrad128& { return numbers.inverses[static_cast<std::size_t>(n)]; });
}

SineCosine<Midrad> sine_cosine(double degrees, int bits) {
  // A quarter as many terms as bits: what a power of two as an error bound gives away is theirs too.
  return series(radians_of_degree(bits) * number(degrees, bits), bits / 4, number(1, bits),
                Midrad::hull(Dyadic(0.5), Dyadic(1.0), bits),
                [bits](int n) { return number(1, bits) / number(static_cast<double>(n) * (n - 1), bits); });
}

}  // namespace foresee::numbers
