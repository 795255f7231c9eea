// Numbers of 128 bits that know how wrong they may be: midpoint and error bound, with exponents as wide as an
// int.
//
//   Wide gap = Wide(1e300) - Wide(0.1) * Wide(3);        // some double's worth of error in the 128th bit
//   gap.sign() == 1                                       // or unknown_sign where the error reaches 0
//
// The stage between certified doubles and numbers of any length: forty digits at some ten nanoseconds an
// operation, where a double's range does not matter (squares of 1e-300, fourth powers of 1e300). What fits
// into 128 bits is exact and stays exact, with error 0, so that ties between numbers of few digits are
// decided here too. Whole arithmetic only, and the same on every processor.
//
// Ball arithmetic as in F. Johansson, "Arb: efficient arbitrary-precision midpoint-radius interval
// arithmetic" (IEEE Transactions on Computers 66, 2017).
#pragma once

#include <cstdint>

#include "numbers/dyadic.h"

namespace foresee {

__extension__ using Uint128 = unsigned __int128;

/// What sign() says where the error bound reaches 0.
constexpr int unknown_sign = 2;

class Wide {
 public:
  Wide() = default;
  /// Exact. Requires: value finite.
  explicit Wide(double value);
  /// Exact if the value has at most 128 bits, else within a unit of the last.
  explicit Wide(const Dyadic& value);
  /// Holds every number between the least of `low` and the greatest of `high`. Requires: 0 <= low <= high.
  static Wide hull(const Wide& low, const Wide& high);

  /// -1, 0, 1, or unknown_sign. 0 is exactly 0.
  int sign() const {
    if (bits_ > error_) return negative_ ? -1 : 1;
    return bits_ == 0 && error_ == 0 ? 0 : unknown_sign;
  }
  bool exact() const { return error_ == 0; }
  /// The midpoint's sign, whatever the error.
  int side() const { return bits_ == 0 ? 0 : negative_ ? -1 : 1; }
  /// floor(log2 |midpoint|). Requires: not 0.
  int magnitude() const;

  /// The least and the greatest number that this may be, and the midpoint; exact.
  Wide low() const;
  Wide high() const;
  Wide middle() const;
  Dyadic dyadic() const;  ///< of the midpoint
  /// The nearest double to the midpoint, ties to even; infinite beyond the largest.
  double rounded() const;

  Wide scaled(int shift) const {
    Wide shifted = *this;
    shifted.exponent_ += shift;
    return shifted;
  }
  friend Wide operator-(Wide a) {
    a.negative_ = !a.negative_;
    return a;
  }
  friend Wide operator+(const Wide& a, const Wide& b);
  friend Wide operator-(const Wide& a, const Wide& b) { return a + -b; }
  friend Wide operator*(const Wide& a, const Wide& b);
  /// Requires: the sign of b is known and not 0.
  friend Wide operator/(const Wide& a, const Wide& b);
  /// Requires: the sign of a is known and not negative.
  friend Wide sqrt(const Wide& a);
  /// Both exact and the same number.
  friend bool same(const Wide& a, const Wide& b) {
    return a.error_ == 0 && b.error_ == 0 && a.bits_ == b.bits_ &&
           (a.bits_ == 0 || (a.exponent_ == b.exponent_ && a.negative_ == b.negative_));
  }

  /// Midpoint and error are the same, so that each may be what the other is.
  friend bool identical(const Wide& a, const Wide& b) {
    return a.bits_ == b.bits_ && a.error_ == b.error_ &&
           (a.exponent_ == b.exponent_ || (a.bits_ == 0 && a.error_ == 0)) &&
           (a.negative_ == b.negative_ || a.bits_ == 0);
  }

 private:
  /// (+-bits +- error) 2^exponent, brought to the form that every Wide has.
  static Wide of(bool negative, Uint128 bits, std::uint64_t error, int exponent);
  /// The same with any error bound, also one that no integer holds.
  static Wide with_error(bool negative, Uint128 bits, double error, int exponent);
  /// Where neither has its highest bit set: both are wide, and the error is multiplied out.
  static Wide coarse_product(const Wide& a, const Wide& b);
  Wide moved_by_error(bool up) const;
  /// As large a part of the error as a double tells: error / bits, rounded up.
  double relative_error() const;

  // bits_ has its highest bit set, unless the error is too large for that or the number is exactly 0.
  Uint128 bits_ = 0;
  std::uint64_t error_ = 0;  ///< below 2^62
  std::int32_t exponent_ = 0;
  bool negative_ = false;
};

inline Wide half_of(const Wide& a) {
  return a.scaled(-1);
}

}  // namespace foresee
