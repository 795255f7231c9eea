#include "numbers/correct_rounding.h"

#include <array>
#include <cmath>
#include <optional>

namespace foresee {
namespace {

/// Beyond so many bits, only a value exactly halfway between two doubles is still in doubt.
constexpr int longest = 4 * first_length;

Midrad midrad_of(double value, int bits) {
  return {Dyadic(value), bits};
}

/// Terms of Taylor's series, nested from its end; the remainder at 45 degrees is 2^-60.
constexpr std::size_t series_terms = 9;
constexpr std::array<double, series_terms> factors(int beside) {
  std::array<double, series_terms> factors{};
  for (std::size_t i = 0; i < series_terms; ++i) {
    const int n = 18 - 2 * static_cast<int>(i);
    factors[i] = 1.0 / (n * (n + beside));
  }
  return factors;
}
constexpr std::array<double, series_terms> sine_factors = factors(1), cosine_factors = factors(-1);

/// degrees = 90 quarters + rest, |rest| <= 45; exact, because the rest has no bits that degrees has not.
struct Angle {
  int quarters;
  double rest;
};
Angle angle_of(double degrees) {
  const double quarters = std::rint(degrees / 90);
  return {static_cast<int>(quarters) & 3, degrees - 90 * quarters};
}

/// Turns (x, y) clockwise by `quarters` right angles.
template <class T>
void turn_quarters(T& x, T& y, int quarters) {
  for (int i = 0; i < quarters; ++i) {
    const T east = x;
    x = y, y = -east;
  }
}

/// The double to which the whole ball rounds, if it is only one.
std::optional<double> rounded_if_known(const Midrad128& value) {
  const double low = value.low().rounded(), high = value.high().rounded();
  if (low != high) return std::nullopt;
  return low + 0.0;
}

/// Rounds enclosure(bits), with more bits until all of it rounds to one double.
template <class Enclosure>
double rounded_in_the_end(const Enclosure& enclosure) {
  for (int bits = first_length;; bits *= 2) {
    const Midrad value = enclosure(bits);
    const double low = rounded(value.low()), high = rounded(value.high());
    if (low == high) return low + 0.0;
    if (bits >= longest) return rounded(value.middle()) + 0.0;
  }
}

}  // namespace

Turned turned_clockwise(double x, double y, double degrees) {
  const Angle angle = angle_of(degrees);
  turn_quarters(x, y, angle.quarters);
  if (angle.rest == 0 || (x == 0 && y == 0)) return {x + 0.0, y + 0.0};
  const SineCosine<Midrad128> quick = sine_cosine(angle.rest);
  const auto component = [&](double along, double across) {
    const Midrad128 rough = Midrad128(along) * quick.cosine + Midrad128(across) * quick.sine;
    if (const auto known = rounded_if_known(rough)) return *known;
    return rounded_in_the_end([&](int bits) {
      const SineCosine<Midrad> at = sine_cosine(angle.rest, bits);
      return midrad_of(along, bits) * at.cosine + midrad_of(across, bits) * at.sine;
    });
  };
  return {component(x, y), component(y, -x)};
}

double rounded_quotient(const Dyadic& a, const Dyadic& b) {
  if (a.sign() == 0) return 0;
  if (const auto known = rounded_if_known(Midrad128(a) / Midrad128(b))) return *known;
  const Midrad quotient = Midrad(a, longest) / Midrad(b, longest);
  const double low = rounded(quotient.low()), high = rounded(quotient.high());
  if (low == high) return low + 0.0;
  if (!std::isfinite(low) || !std::isfinite(high)) return rounded(quotient.middle());
  // The value lies halfway between two doubles, or next to that.
  const Dyadic between = half_of(Dyadic(low) + Dyadic(high));
  const int side = (a - between * b).sign();
  return (side < 0 ? low : side > 0 ? high : rounded(between)) + 0.0;
}

double rounded_root(const Dyadic& square) {
  if (square.sign() <= 0) return 0;
  // 128 bits or one less, so that the exponent is even. Of the bits cut off only their presence matters.
  const int bits = bit_length(square.mantissa());
  int shift = 128 - bits;
  if ((square.exponent() - shift) % 2 != 0) --shift;
  const Integer head =
      shift >= 0 ? Integer(square.mantissa() << shift) : Integer(square.mantissa() >> -shift);
  Integer rest;
  const Integer root = sqrt(head, rest);
  const bool more = !rest.is_zero() || (shift < 0 && Integer(head << -shift) != square.mantissa());
  return rounded(Dyadic((root << 1) + (more ? 1 : 0), (square.exponent() - shift) / 2 - 1));
}

SineCosine<double> quick_sine_cosine(double degrees) {
  const Angle angle = angle_of(degrees);
  const double x = angle.rest * radians_per_degree, square = x * x;
  double sine = 1, cosine = 1;
  for (std::size_t i = 0; i < series_terms; ++i) {
    sine = 1 - square * sine_factors[i] * sine;
    cosine = 1 - square * cosine_factors[i] * cosine;
  }
  sine *= x;
  // A quarter turn makes (sine, cosine) into (cosine, -sine).
  turn_quarters(sine, cosine, angle.quarters);
  return {sine, cosine};
}

// By Taylor's series below 1, where the quotient of a rounded sine would not do.
double quick_sinc(double degrees) {
  const double x = degrees * radians_per_degree;
  if (std::abs(x) >= 1) return quick_sine_cosine(std::fmod(degrees, 360)).sine / x;
  double sum = 1;
  for (int n = 20; n >= 2; n -= 2) sum = 1 - x * x / (n * (n + 1)) * sum;
  return sum;
}

double quick_degrees(const SineCosine<double>& angle) {
  // The tangent of half the angle, or its inverse, in a polynomial whose error is 1e-5 (Abramowitz and Stegun, 4.4.47).
  const double tangent = angle.sine / (1 + angle.cosine), t = std::abs(tangent) > 1 ? 1 / tangent : tangent,
               s = t * t;
  if (std::isnan(tangent)) return 180;
  const double half = t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
  double degrees = 2 * half / radians_per_degree;
  if (std::abs(tangent) > 1) degrees = std::copysign(180, tangent) - degrees;
  for (int i = 0; i < 2; ++i) {
    const SineCosine<double> at = quick_sine_cosine(degrees);
    degrees += (angle.sine * at.cosine - angle.cosine * at.sine) / radians_per_degree;
  }
  return degrees;
}

Turned quick_turned(double x, double y, double degrees) {
  const SineCosine<double> at = quick_sine_cosine(std::fmod(degrees, 360));
  return {x * at.cosine + y * at.sine, y * at.cosine - x * at.sine};
}

}  // namespace foresee
