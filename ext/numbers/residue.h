// Arithmetic modulo the prime 2^61 - 1: a fast proof that an exact number is not 0.
//
// A residue other than 0 is the proof; it takes a few nanoseconds where exact arithmetic takes milliseconds.
// Powers of two are rotations, so that every m 2^e has a residue, and sums and products agree with the exact
// ones.
#pragma once

#include <cstdint>

#include "numbers/midrad_128.h"

namespace foresee {

class Residue {
 public:
  Residue() = default;
  explicit Residue(const Dyadic& number) {
    const auto& digits = number.mantissa().backend();
    for (unsigned i = digits.size(); i-- > 0;) value_ = folded((Uint128{value_} << 64) + digits.limbs()[i]);
    const int turn = number.exponent() % bits;
    value_ = folded(Uint128{value_} << (turn < 0 ? turn + bits : turn));
    if (number.sign() < 0) *this = Residue() - *this;
  }

  bool is_zero() const { return value_ == 0; }

  friend Residue operator-(Residue a, Residue b) {
    return of(a.value_ >= b.value_ ? a.value_ - b.value_ : a.value_ + prime - b.value_);
  }
  friend Residue operator*(Residue a, Residue b) { return of(folded(Uint128{a.value_} * b.value_)); }

 private:
  static constexpr int bits = 61;
  static constexpr std::uint64_t prime = (std::uint64_t{1} << bits) - 1;

  static Residue of(std::uint64_t value) {
    Residue r;
    r.value_ = value;
    return r;
  }
  static std::uint64_t folded(Uint128 x) {
    x = (x & prime) + (x >> bits);
    x = (x & prime) + (x >> bits);
    const auto value = static_cast<std::uint64_t>(x);
    return value >= prime ? value - prime : value;
  }

  std::uint64_t value_ = 0;
};

}  // namespace foresee
