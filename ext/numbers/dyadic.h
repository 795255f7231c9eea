// Exact dyadic rationals m 2^e: every double is one, and sums, differences, products and halves are exact.
//
//   Dyadic gap = Dyadic(1e300) - Dyadic(1e-300);         // all bits kept
//   double nearest = rounded(gap);                        // once, ties to even
//
// Up to 1024 bits are stored inside the object (allocation costs more than arithmetic), longer ones on the
// heap.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>

namespace foresee {

using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked>,
    boost::multiprecision::et_off>;

/// The number of bits of |value|; 0 for 0.
int bit_length(const Integer& value);
/// The number of trailing zero bits. Requires: value is not 0.
int zeros_of(const Integer& value);
/// value / 2^bits, truncated towards 0. (>> of Boost 1.74 loses the sign of some negative numbers.)
Integer without_last(Integer value, int bits);

class Dyadic {
 public:
  Dyadic() = default;
  /// Requires: value finite.
  explicit Dyadic(double value);
  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}
  static Dyadic power_of_two(int exponent) { return {Integer(1), exponent}; }

  int sign() const { return mantissa_.sign(); }
  const Integer& mantissa() const { return mantissa_; }
  int exponent() const { return exponent_; }
  /// floor(log2 |value|). Requires: not zero.
  int magnitude() const;
  /// The same number with an odd mantissa.
  Dyadic reduced() const;
  /// value 2^shift
  Dyadic scaled(int shift) const { return {mantissa_, exponent_ + shift}; }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }
  friend std::strong_ordering operator<=>(const Dyadic& a, const Dyadic& b) { return (a - b).sign() <=> 0; }

 private:
  Integer mantissa_ = 0;
  int exponent_ = 0;
};

inline Dyadic half_of(const Dyadic& a) {
  return a.scaled(-1);
}

/// The nearest double, ties to even; infinite beyond the largest.
double rounded(const Dyadic& value);

}  // namespace foresee
