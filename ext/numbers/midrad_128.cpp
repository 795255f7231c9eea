#include "numbers/midrad_128.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace foresee {
namespace {

constexpr Uint128 top_bit = Uint128{1} << 127;
constexpr int max_error_bits = 62;

int leading_zeros(Uint128 x) {
  const auto high = static_cast<std::uint64_t>(x >> 64);
  return high != 0 ? std::countl_zero(high) : 64 + std::countl_zero(static_cast<std::uint64_t>(x));
}

/// A product of 256 bits.
struct Product {
  Uint128 high, low;
};
Product product(Uint128 a, Uint128 b) {
  constexpr Uint128 half = ~std::uint64_t{0};
  const Uint128 a0 = a & half, a1 = a >> 64, b0 = b & half, b1 = b >> 64;
  const Uint128 low = a0 * b0, cross = a1 * b0, other = a0 * b1;
  const Uint128 middle = (low >> 64) + (cross & half) + (other & half);
  return {a1 * b1 + (cross >> 64) + (other >> 64) + (middle >> 64), (middle << 64) | (low & half)};
}

}  // namespace

Midrad128 Midrad128::of(bool negative, Uint128 bits, std::uint64_t error, int exponent) {
  if (bits == 0 && error == 0) return {};
  Midrad128 w;
  if (error >> max_error_bits) {
    constexpr int shift = 4;
    bits >>= shift, error = (error >> shift) + 2, exponent += shift;
  }
  int shift = bits == 0 ? 127 : leading_zeros(bits);
  if (error != 0) shift = std::min(shift, std::countl_zero(error) - (64 - max_error_bits));
  w.bits_ = bits << shift, w.error_ = error == 0 ? 0 : error << shift;
  w.exponent_ = exponent - shift;
  w.negative_ = negative;
  return w;
}

Midrad128 Midrad128::with_error(bool negative, Uint128 bits, double error, int exponent) {
  int shift = 0;
  if (error >= 0x1p60) {
    shift = std::ilogb(error) - 58;
    bits = shift < 128 ? bits >> shift : 0;
  }
  return of(negative, bits, static_cast<std::uint64_t>(std::ldexp(error, -shift)) + 2, exponent + shift);
}

Midrad128::Midrad128(double value) {
  if (value == 0) return;
  constexpr int digits = std::numeric_limits<double>::digits - 1;
  constexpr std::uint64_t one = std::uint64_t{1} << digits;
  const auto pattern = std::bit_cast<std::uint64_t>(value);
  const auto exponent = static_cast<int>(pattern >> digits & 0x7ff);
  const std::uint64_t whole = (pattern & (one - 1)) | (exponent == 0 ? 0 : one);
  *this = of(value < 0, whole, 0, std::max(exponent, 1) - 1075);
}

Midrad128::Midrad128(const Dyadic& value) {
  if (value.sign() == 0) return;
  const Integer whole = abs(value.mantissa());
  const int dropped = std::max(0, static_cast<int>(msb(whole)) + 1 - 128);
  const Integer kept = whole >> dropped;
  const bool cut = dropped > 0 && (kept << dropped) != whole;
  const auto high = static_cast<std::uint64_t>(kept >> 64);
  const auto low = static_cast<std::uint64_t>(kept & Integer(~std::uint64_t{0}));
  *this = of(value.sign() < 0, Uint128{high} << 64 | low, cut ? 1 : 0, value.exponent() + dropped);
}

int Midrad128::magnitude() const {
  return 127 - leading_zeros(bits_) + exponent_;
}

Midrad128 Midrad128::middle() const {
  return of(negative_, bits_, 0, exponent_);
}

Midrad128 Midrad128::moved_by_error(bool up) const {
  if (error_ == 0) return *this;
  const Midrad128 error = of(!up, error_, 0, exponent_);
  Midrad128 end = middle() + error;
  // The sum may need one bit more than there are: then the bound moves outward by a unit.
  if (end.error_ != 0) end = end.middle() + of(!up, 2, 0, end.exponent_);
  return end.middle();
}

Midrad128 Midrad128::low() const {
  return moved_by_error(false);
}

Midrad128 Midrad128::high() const {
  return moved_by_error(true);
}

Midrad128 Midrad128::hull(const Midrad128& low, const Midrad128& high) {
  const Midrad128 a = low.low(), b = high.high();
  if (same(a, b)) return a;
  const Midrad128 middle = half_of(a + b), radius = half_of(b - a);
  const double error = std::ldexp(static_cast<double>(radius.bits_) * (1 + 0x1p-50),
                                  std::max(radius.exponent_ - middle.exponent_, -1000));
  return with_error(false, middle.bits_, error + static_cast<double>(middle.error_) + 2, middle.exponent_);
}

Dyadic Midrad128::dyadic() const {
  if (bits_ == 0) return {};
  const auto low = static_cast<std::uint64_t>(bits_), high = static_cast<std::uint64_t>(bits_ >> 64);
  const int zeros = low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(high);
  const Uint128 odd = bits_ >> zeros;
  const Integer whole =
      (Integer(static_cast<std::uint64_t>(odd >> 64)) << 64) | Integer(static_cast<std::uint64_t>(odd));
  return {negative_ ? Integer(-whole) : whole, exponent_ + zeros};
}

double Midrad128::rounded() const {
  if (bits_ == 0) return 0;
  const Midrad128 full = of(negative_, bits_, 0, exponent_);
  // Below 2^-1022 a double has fewer than 53 bits.
  const int kept = std::min(53, full.magnitude() + 1075);
  if (kept < 0) return 0;
  const int dropped = 128 - kept;
  Uint128 head = dropped == 128 ? 0 : full.bits_ >> dropped;
  const Uint128 rest = dropped == 128 ? full.bits_ : full.bits_ << kept;
  if (rest > top_bit || (rest == top_bit && (head & 1) != 0)) ++head;
  if (head == 0) return 0;
  const double value = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(head)),
                                  std::min(full.exponent_ + dropped, 2000));
  return negative_ ? -value : value;
}

Midrad128 operator+(const Midrad128& left, const Midrad128& right) {
  if (left.bits_ == 0 && left.error_ == 0) return right;
  if (right.bits_ == 0 && right.error_ == 0) return left;
  const bool swap = left.exponent_ < right.exponent_;
  const Midrad128 &a = swap ? right : left, &b = swap ? left : right;
  const int shift = a.exponent_ - b.exponent_;
  const Uint128 bits = shift < 128 ? b.bits_ >> shift : 0;
  const bool cut = shift < 128 ? (bits << shift) != b.bits_ : b.bits_ != 0;
  std::uint64_t error = a.error_ + (cut ? 1 : 0);
  if (b.error_ != 0) error += (shift < 64 ? b.error_ >> shift : 0) + 1;
  if (a.negative_ != b.negative_) {
    const bool more = a.bits_ >= bits;
    return Midrad128::of(more ? a.negative_ : b.negative_, more ? a.bits_ - bits : bits - a.bits_, error,
                         a.exponent_);
  }
  const Uint128 sum = a.bits_ + bits;
  if (sum >= bits) return Midrad128::of(a.negative_, sum, error, a.exponent_);
  return Midrad128::of(a.negative_, (sum >> 1) | top_bit, (error >> 1) + (error & 1) + (sum & 1 ? 1 : 0),
                       a.exponent_ + 1);
}

Midrad128 Midrad128::coarse_product(const Midrad128& a, const Midrad128& b) {
  const auto bits_a = static_cast<double>(a.bits_), bits_b = static_cast<double>(b.bits_);
  const auto error_a = static_cast<double>(a.error_), error_b = static_cast<double>(b.error_);
  const double error = (bits_a * error_b + (bits_b + error_b) * error_a) * (1 + 0x1p-50);
  // Both errors are at least 2^61: at least 64 bits are not significant, and the rest fits.
  const int shift = std::ilogb(error) - 58;
  const Product p = product(a.bits_, b.bits_);
  const Uint128 bits = shift < 128 ? (p.high << (128 - shift)) | (p.low >> shift) : p.high >> (shift - 128);
  return of(a.negative_ != b.negative_, bits, static_cast<std::uint64_t>(std::ldexp(error, -shift)) + 2,
            a.exponent_ + b.exponent_ + shift);
}

Midrad128 operator*(const Midrad128& a, const Midrad128& b) {
  if ((a.bits_ == 0 && a.error_ == 0) || (b.bits_ == 0 && b.error_ == 0)) return {};
  if (!((a.bits_ | b.bits_) & top_bit)) return Midrad128::coarse_product(a, b);
  Product p = product(a.bits_, b.bits_);
  std::uint64_t error = a.error_ + b.error_ + (a.error_ != 0 && b.error_ != 0 ? 1 : 0);
  int exponent = a.exponent_ + b.exponent_ + 128;
  // If the leading bits are free, the product is shifted up instead of cut off: exact products of few digits
  // remain exact.
  if (!(p.high & top_bit) && p.high != 0 && p.low != 0 && !(error >> max_error_bits)) {
    const int shift = error == 0 ? leading_zeros(p.high) : 1;
    p.high = (p.high << shift) | (p.low >> (128 - shift));
    p.low <<= shift, exponent -= shift, error <<= shift;
  }
  return Midrad128::of(a.negative_ != b.negative_, p.high, error + (p.low != 0 ? 1 : 0), exponent);
}

double Midrad128::relative_error() const {
  return static_cast<double>(error_) / static_cast<double>(bits_ - error_) * (1 + 0x1p-50);
}

Midrad128 operator/(const Midrad128& a, const Midrad128& b) {
  if (a.bits_ == 0 && a.error_ == 0) return {};
  const double divisor = static_cast<double>(b.bits_);
  if (a.bits_ <= a.error_) {
    const double bound = (static_cast<double>(a.bits_) + static_cast<double>(a.error_)) /
                         (divisor * (1 - b.relative_error() / (1 + b.relative_error())));
    return Midrad128::with_error(false, 0, std::ldexp(bound * (1 + 0x1p-40), 140),
                                 a.exponent_ - b.exponent_ - 140);
  }
  // Long division by some fifty bits per round: divides the remainder in double.
  Midrad128 quotient, rest = a.middle();
  const Midrad128 exact_divisor = b.middle();
  for (int round = 0; round < 3 && rest.bits_ != 0; ++round) {
    Midrad128 part(static_cast<double>(rest.bits_) / divisor);
    part.exponent_ += rest.exponent_ - b.exponent_;
    part.negative_ = rest.negative_ != b.negative_;
    quotient = (quotient + part).middle();
    rest = (rest - part * exact_divisor).middle();
  }
  // Three rounds leave a remainder below 2^-145; each sum and product added less than 2^-126 of the quotient.
  const bool exact = rest.bits_ == 0 && a.error_ == 0 && b.error_ == 0 && same(quotient * exact_divisor, a);
  if (exact) return quotient;
  const double error_a = a.relative_error(), error_b = b.relative_error();
  const double relative = (error_a + error_b + error_a * error_b) * (1 + 0x1p-40) + 0x1p-122;
  return Midrad128::with_error(quotient.negative_, quotient.bits_,
                               relative * static_cast<double>(quotient.bits_) * (1 + 0x1p-40),
                               quotient.exponent_);
}

Midrad128 sqrt(const Midrad128& a) {
  if (a.bits_ == 0) return {};
  const Midrad128 square = a.middle();
  // The exponent is made even. From a double's root of 53 bits, two Newton steps add remainder / (2 root).
  const int shift = square.exponent_ & 1 ? square.exponent_ + 1 : square.exponent_;
  const double start = std::sqrt(std::ldexp(static_cast<double>(square.bits_), square.exponent_ - shift));
  Midrad128 root = Midrad128(start).scaled(shift / 2);
  for (int round = 0; round < 2; ++round) {
    const Midrad128 rest = (square - root * root).middle();
    if (rest.bits_ == 0) break;
    const double correction = static_cast<double>(rest.bits_) / (2 * static_cast<double>(root.bits_));
    const Midrad128 part = Midrad128(correction).scaled(rest.exponent_ - root.exponent_);
    root = (root + (rest.negative_ ? -part : part)).middle();
  }
  if (a.error_ == 0 && same(root * root, square)) return root;
  const double relative = a.relative_error() * (1 + 0x1p-40) + 0x1p-122;
  return Midrad128::with_error(false, root.bits_, relative * static_cast<double>(root.bits_) * (1 + 0x1p-40),
                               root.exponent_);
}

}  // namespace foresee
