// Numbers of as many bits as one asks for that know how wrong they may be: what Wide is, at any length.
//
//   Precise third = Precise(Dyadic(1.0), 1000) / Precise(Dyadic(3.0), 1000);    // off by 2^-1000 or so
//   third.sign() == 1                                  // or unknown_sign where the error reaches 0
//
// Where 128 bits do not tell, the same question is asked with 512, 1024 and so on. What fits into the length
// stays exact, so that signs of exact expressions are always found in the end. A sum or product is as long as
// the longer of the two; digits that the error makes meaningless are not kept. The error bound is a power of
// two: crude, which costs a dozen bits in a polynomial, and cheap.
#pragma once

#include <limits>

#include "numbers/wide.h"

namespace foresee {

/// The length to begin with; then twice as many, and so on.
constexpr int first_length = 512;

class Precise {
 public:
  Precise() = default;
  /// Exact if the value has at most `bits` bits, else within a unit of the last.
  Precise(const Dyadic& value, int bits) : Precise(of(value.mantissa(), value.exponent(), none, bits)) {}
  Precise(const Wide& value, int bits);
  /// Holds every number between `low` and `high`. Requires: low <= high.
  static Precise hull(const Dyadic& low, const Dyadic& high, int bits);

  /// -1, 0, 1, or unknown_sign. 0 is exactly 0.
  int sign() const;
  bool exact() const { return error_ == none; }
  /// The least and the greatest number that this may be, and the midpoint.
  Dyadic low() const;
  Dyadic high() const;
  Dyadic middle() const { return {mantissa_, exponent_}; }

  /// The same in at most so many bits.
  Precise cut_to(int bits) const { return of(mantissa_, exponent_, error_, bits); }
  Precise scaled(int shift) const;
  friend Precise operator-(Precise a);
  friend Precise operator+(const Precise& a, const Precise& b);
  friend Precise operator-(const Precise& a, const Precise& b) { return a + -b; }
  friend Precise operator*(const Precise& a, const Precise& b);
  /// Requires: the sign of b is known and not 0.
  friend Precise operator/(const Precise& a, const Precise& b);
  /// Requires: the sign of a is known and not negative.
  friend Precise sqrt(const Precise& a);

 private:
  static constexpr int none = std::numeric_limits<int>::min();  ///< the error of what is exact
  /// (mantissa +- 2^(error - exponent)) 2^exponent without meaningless digits.
  static Precise of(Integer mantissa, int exponent, int error, int bits);
  /// A bound on the sum of two errors.
  static int both(int error, int other);
  /// An error times what is below 2^magnitude.
  static int times(int error, int magnitude) { return error == none ? none : error + magnitude; }
  /// floor(log2 |midpoint|). Requires: the midpoint is not 0.
  int magnitude() const { return length_of(mantissa_) - 1 + exponent_; }
  bool is_zero() const { return mantissa_.is_zero() && exact(); }

  Integer mantissa_ = 0;
  int exponent_ = 0;
  int error_ = none;  ///< at most 2^error_
  int bits_ = 0;
};

inline Precise half_of(const Precise& a) {
  return a.scaled(-1);
}

}  // namespace foresee
