#include "numbers/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace foresee {

namespace {
constexpr int limb_bits = std::numeric_limits<boost::multiprecision::limb_type>::digits;
}

int bit_length(const Integer& value) {
  const auto& digits = value.backend();
  return static_cast<int>(digits.size()) * limb_bits - std::countl_zero(digits.limbs()[digits.size() - 1]);
}

int zeros_of(const Integer& value) {
  const auto* digit = value.backend().limbs();
  int zeros = 0;
  for (; *digit == 0; ++digit) zeros += limb_bits;
  return zeros + std::countr_zero(*digit);
}

Integer without_last(Integer value, int bits) {
  const bool negative = value.sign() < 0;
  value.backend().sign(false);
  value >>= bits;
  if (negative) value.backend().negate();
  return value;
}

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  constexpr int digits = std::numeric_limits<double>::digits;
  const auto whole = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent_), digits));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(whole));
  mantissa_ = whole >> zeros;
  exponent_ += zeros - digits;
}

int Dyadic::magnitude() const {
  return bit_length(mantissa_) - 1 + exponent_;
}

Dyadic Dyadic::reduced() const {
  if (sign() == 0) return {};
  const int zeros = zeros_of(mantissa_);
  return zeros == 0 ? *this : Dyadic(without_last(mantissa_, zeros), exponent_ + zeros);
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  if (a.exponent_ == b.exponent_) return {a.mantissa_ + b.mantissa_, a.exponent_};
  if (a.exponent_ > b.exponent_)
    return {(a.mantissa_ << (a.exponent_ - b.exponent_)) + b.mantissa_, b.exponent_};
  return {a.mantissa_ + (b.mantissa_ << (b.exponent_ - a.exponent_)), a.exponent_};
}

Dyadic operator-(const Dyadic& a, const Dyadic& b) {
  return a + -b;
}

double rounded(const Dyadic& value) {
  if (value.sign() == 0) return 0;
  const Integer whole = abs(value.mantissa());
  const double side = value.sign();
  const int bits = static_cast<int>(msb(whole)) + 1;
  // Below 2^-1022 a double has fewer than 53 bits.
  const int kept = std::min(53, value.magnitude() + 1075);
  if (kept < 0) return 0;
  const int dropped = bits - kept;
  if (dropped <= 0) return side * std::ldexp(whole.convert_to<double>(), value.exponent());
  const Integer head = whole >> dropped;
  const Integer rest = whole - (head << dropped), half = Integer(1) << (dropped - 1);
  const int order = rest.compare(half);
  auto nearest = static_cast<std::int64_t>(head);
  if (order > 0 || (order == 0 && nearest % 2 != 0)) ++nearest;
  if (nearest == 0) return 0;
  return side * std::ldexp(static_cast<double>(nearest), value.exponent() + dropped);
}

}  // namespace foresee
