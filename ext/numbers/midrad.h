// Ball arithmetic of any precision: a midpoint and an error radius, like Midrad128 with as many bits as
// needed.
//
//   Midrad third = Midrad(Dyadic(1.0), 1000) / Midrad(Dyadic(3.0), 1000);    // off by about 2^-1000
//   third.sign() == 1                                  // or unknown_sign where the error reaches 0
//
// If 128 bits do not decide a sign, the computation is repeated with 512, 1024 and so on. A number that fits
// into the length is exact, so that the sign of an exact expression is always found in the end. A sum or
// product is as long as the longer argument; digits below the error are dropped. The error bound is a power
// of two: cheap, but crude, which costs a dozen bits in a polynomial.
#pragma once

#include <limits>

#include "numbers/midrad_128.h"

namespace foresee {

/// The first length in bits; each repetition doubles it.
constexpr int first_length = 512;

class Midrad {
 public:
  Midrad() = default;
  /// Exact if the value has at most `bits` bits, else off by at most a unit of the last bit.
  Midrad(const Dyadic& value, int bits) : Midrad(of(value.mantissa(), value.exponent(), none, bits)) {}
  Midrad(const Midrad128& value, int bits);
  /// A ball that contains every number between `low` and `high`. Requires: low <= high.
  static Midrad hull(const Dyadic& low, const Dyadic& high, int bits);

  /// -1, 0, 1, or unknown_sign. 0: the number is exactly 0.
  int sign() const;
  bool exact() const { return error_ == none; }
  /// The lower bound, the upper bound, and the midpoint.
  Dyadic low() const;
  Dyadic high() const;
  Dyadic middle() const { return {mantissa_, exponent_}; }

  /// Shortened to at most `bits` bits.
  Midrad cut_to(int bits) const { return of(mantissa_, exponent_, error_, bits); }
  Midrad scaled(int shift) const;
  friend Midrad operator-(Midrad a);
  friend Midrad operator+(const Midrad& a, const Midrad& b);
  friend Midrad operator-(const Midrad& a, const Midrad& b) { return a + -b; }
  friend Midrad operator*(const Midrad& a, const Midrad& b);
  /// Requires: the sign of b is known and not 0.
  friend Midrad operator/(const Midrad& a, const Midrad& b);
  /// Requires: the sign of a is known and not negative.
  friend Midrad sqrt(const Midrad& a);

 private:
  static constexpr int none = std::numeric_limits<int>::min();  ///< the error of an exact number
  /// (mantissa +- 2^(error - exponent)) 2^exponent without digits below the error.
  static Midrad of(Integer mantissa, int exponent, int error, int bits);
  /// A bound on the sum of two errors.
  static int both(int error, int other);
  /// A bound on an error times a factor below 2^magnitude.
  static int times(int error, int magnitude) { return error == none ? none : error + magnitude; }
  /// floor(log2 |midpoint|). Requires: the midpoint is not 0.
  int magnitude() const { return bit_length(mantissa_) - 1 + exponent_; }
  bool is_zero() const { return mantissa_.is_zero() && exact(); }

  Integer mantissa_ = 0;
  int exponent_ = 0;
  int error_ = none;  ///< at most 2^error_
  int bits_ = 0;
};

inline Midrad half_of(const Midrad& a) {
  return a.scaled(-1);
}

}  // namespace foresee
