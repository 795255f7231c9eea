// Ball arithmetic in 128 bits: a midpoint and a radius that bounds the error, with exponents as wide as an
// int.
//
//   Midrad128 third = Midrad128(1) / Midrad128(3);     // off by a unit of the 128th bit or so
//   third.sign() == 1                                  // or unknown_sign where the error reaches 0
//
// The stage between certified doubles and numbers of any length: forty digits at some ten nanoseconds per
// operation, for magnitudes beyond a double's range too (squares of 1e-300, fourth powers of 1e300). A number
// that fits into 128 bits is exact, with error 0, so that ties between numbers of few digits are decided
// here. Integer arithmetic only: the same result on every processor.
//
// As in F. Johansson, "Arb: efficient arbitrary-precision midpoint-radius interval arithmetic" (IEEE
// Transactions on Computers 66, 2017).
#pragma once

#include <cstdint>

#include "numbers/dyadic.h"

namespace foresee {

__extension__ using Uint128 = unsigned __int128;

/// The result of sign() if the ball contains 0 and is not exactly 0.
constexpr int unknown_sign = 2;

class Midrad128 {
 public:
  Midrad128() = default;
  /// Exact. Requires: value finite.
  explicit Midrad128(double value);
  /// Exact if the value has at most 128 bits, else off by at most a unit of the last bit.
  explicit Midrad128(const Dyadic& value);
  /// A ball that contains every number from the lower bound of `low` to the upper bound of `high`. Requires:
  /// 0 <= low <= high.
  static Midrad128 hull(const Midrad128& low, const Midrad128& high);

  /// -1, 0, 1, or unknown_sign. 0: the number is exactly 0.
  int sign() const {
    if (bits_ > error_) return negative_ ? -1 : 1;
    return bits_ == 0 && error_ == 0 ? 0 : unknown_sign;
  }
  bool exact() const { return error_ == 0; }
  /// The midpoint's sign, whatever the error.
  int side() const { return bits_ == 0 ? 0 : negative_ ? -1 : 1; }
  /// floor(log2 |midpoint|). Requires: not 0.
  int magnitude() const;

  /// The lower bound, the upper bound, and the midpoint; exact numbers.
  Midrad128 low() const;
  Midrad128 high() const;
  Midrad128 middle() const;
  Dyadic dyadic() const;  ///< the midpoint
  /// The nearest double to the midpoint, ties to even; infinite beyond the largest.
  double rounded() const;

  Midrad128 scaled(int shift) const {
    Midrad128 shifted = *this;
    shifted.exponent_ += shift;
    return shifted;
  }
  friend Midrad128 operator-(Midrad128 a) {
    a.negative_ = !a.negative_;
    return a;
  }
  friend Midrad128 operator+(const Midrad128& a, const Midrad128& b);
  friend Midrad128 operator-(const Midrad128& a, const Midrad128& b) { return a + -b; }
  friend Midrad128 operator*(const Midrad128& a, const Midrad128& b);
  /// Requires: the sign of b is known and not 0.
  friend Midrad128 operator/(const Midrad128& a, const Midrad128& b);
  /// Requires: the sign of a is known and not negative.
  friend Midrad128 sqrt(const Midrad128& a);
  /// Whether both are exact and the same number.
  friend bool same(const Midrad128& a, const Midrad128& b) {
    return a.error_ == 0 && b.error_ == 0 && a.bits_ == b.bits_ &&
           (a.bits_ == 0 || (a.exponent_ == b.exponent_ && a.negative_ == b.negative_));
  }

  /// Whether midpoint and error are the same; the two numbers may still differ.
  friend bool identical(const Midrad128& a, const Midrad128& b) {
    return a.bits_ == b.bits_ && a.error_ == b.error_ &&
           (a.exponent_ == b.exponent_ || (a.bits_ == 0 && a.error_ == 0)) &&
           (a.negative_ == b.negative_ || a.bits_ == 0);
  }

 private:
  /// (+-bits +- error) 2^exponent, normalized.
  static Midrad128 of(bool negative, Uint128 bits, std::uint64_t error, int exponent);
  /// of() with an error bound of any size, also one beyond 64 bits.
  static Midrad128 with_error(bool negative, Uint128 bits, double error, int exponent);
  /// The product if neither has its highest bit set: both errors are large, and the error is multiplied out.
  static Midrad128 coarse_product(const Midrad128& a, const Midrad128& b);
  Midrad128 moved_by_error(bool up) const;
  /// error / (bits - error), rounded up: an upper bound of the relative error.
  double relative_error() const;

  // Normal form: bits_ has its highest bit set, unless the error is too large for that or the number is 0.
  Uint128 bits_ = 0;
  std::uint64_t error_ = 0;  ///< below 2^62
  std::int32_t exponent_ = 0;
  bool negative_ = false;
};

inline Midrad128 half_of(const Midrad128& a) {
  return a.scaled(-1);
}

}  // namespace foresee
