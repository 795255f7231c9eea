#include "numbers/midrad.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

Integer shifted(const Integer& value, int left) {
  return left >= 0 ? Integer(value << left) : without_last(value, -left);
}

/// The square root, off by at most 4. Requires: not negative.
Integer rough_root(const Integer& square) {
  const int length = bit_length(square);
  if (length <= 104) return static_cast<std::int64_t>(std::sqrt(square.convert_to<double>()));
  // The upper half of the root and four more bits, then one Newton step: off by 4^2 / 2^9 and the truncation.
  const int half = length / 4 - 4;
  const Integer start = rough_root(square >> (2 * half)) << half;
  return (start + square / start) >> 1;
}

}  // namespace

Midrad Midrad::of(Integer mantissa, int exponent, int error, int bits) {
  Midrad p;
  p.bits_ = bits;
  int cut = bit_length(mantissa) - bits;
  if (error != none) cut = std::max(cut, error - 2 - exponent);
  if (!mantissa.is_zero() && cut > 0) {
    if (error != none || zeros_of(mantissa) < cut) error = both(error, exponent + cut);
    mantissa = without_last(std::move(mantissa), cut);
    exponent += cut;
  }
  p.mantissa_ = std::move(mantissa), p.exponent_ = exponent, p.error_ = error;
  return p;
}

int Midrad::both(int error, int other) {
  if (error == none || other == none) return std::max(error, other);
  return std::max(error, other) + 1;
}

Midrad::Midrad(const Midrad128& value, int bits)
    : Midrad(hull(value.low().dyadic(), value.high().dyadic(), bits)) {}

Midrad Midrad::hull(const Dyadic& low, const Dyadic& high, int bits) {
  const Dyadic middle = half_of(low + high), width = high - low;
  return of(middle.mantissa(), middle.exponent(), width.sign() == 0 ? none : width.magnitude(), bits);
}

int Midrad::sign() const {
  if (mantissa_.is_zero()) return exact() ? 0 : unknown_sign;
  return exact() || magnitude() > error_ ? mantissa_.sign() : unknown_sign;
}

Dyadic Midrad::low() const {
  return exact() ? middle() : middle() - Dyadic::power_of_two(error_);
}

Dyadic Midrad::high() const {
  return exact() ? middle() : middle() + Dyadic::power_of_two(error_);
}

Midrad Midrad::scaled(int shift) const {
  Midrad p = *this;
  p.exponent_ += shift, p.error_ = times(error_, shift);
  return p;
}

Midrad operator-(Midrad a) {
  a.mantissa_ = -a.mantissa_;
  return a;
}

Midrad operator+(const Midrad& a, const Midrad& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const int bits = std::max(a.bits_, b.bits_);
  int top = Midrad::none;
  for (const Midrad* p : {&a, &b})
    if (!p->mantissa_.is_zero()) top = std::max(top, p->magnitude());
  int error = Midrad::both(a.error_, b.error_);
  if (top == Midrad::none) return Midrad::of(0, 0, error, bits);
  // Digits below the last one of the sum are cut off before the addition.
  const int last = std::max(top - bits - 2, std::min(a.exponent_, b.exponent_));
  for (const Midrad* p : {&a, &b})
    if (p->exponent_ < last) error = Midrad::both(error, last);
  const Integer sum = shifted(a.mantissa_, a.exponent_ - last) + shifted(b.mantissa_, b.exponent_ - last);
  return Midrad::of(sum, last, error, bits);
}

Midrad operator*(const Midrad& a, const Midrad& b) {
  if (a.is_zero() || b.is_zero()) return {};
  int error = a.exact() || b.exact() ? Midrad::none : a.error_ + b.error_;
  if (!a.mantissa_.is_zero()) error = Midrad::both(error, Midrad::times(b.error_, a.magnitude() + 1));
  if (!b.mantissa_.is_zero()) error = Midrad::both(error, Midrad::times(a.error_, b.magnitude() + 1));
  return Midrad::of(a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_, error, std::max(a.bits_, b.bits_));
}

Midrad operator/(const Midrad& a, const Midrad& b) {
  if (a.is_zero()) return {};
  const int bits = std::max(a.bits_, b.bits_), divisor = bit_length(b.mantissa_),
            divided = bit_length(a.mantissa_);
  // No more digits than the errors of a and b leave significant.
  int wanted = bits;
  if (!a.exact()) wanted = std::min(wanted, divided);
  if (!b.exact()) wanted = std::min(wanted, divisor);
  const int shift = wanted + 4 + divisor - divided;
  const int exponent = a.exponent_ - b.exponent_ - shift;
  // The true divisor is more than half of b; truncating a and dividing lose less than a unit each.
  const int lowest = b.magnitude() - 1;
  int error = Midrad::both(exponent + 1, Midrad::times(a.error_, -lowest));
  if (divided > 0)
    error = Midrad::both(error, Midrad::times(b.error_, a.magnitude() + 1 - b.magnitude() - lowest));
  return Midrad::of(shifted(a.mantissa_, shift) / b.mantissa_, exponent, error, bits);
}

Midrad sqrt(const Midrad& a) {
  if (a.is_zero()) return {};
  int shift = 2 * a.bits_ - bit_length(a.mantissa_);
  if ((a.exponent_ - shift) % 2 != 0) --shift;
  const int exponent = (a.exponent_ - shift) / 2;
  // The derivative is below 2^-(magnitude / 2), because a is more than half its midpoint.
  const int error = Midrad::both(exponent + 3, Midrad::times(a.error_, -(a.magnitude() - 1) / 2 + 1));
  return Midrad::of(rough_root(shifted(a.mantissa_, shift)), exponent, error, a.bits_);
}

}  // namespace foresee
