#include "shape/outline/outline_rotation.h"

#include <cmath>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "shape/outline/shared_outline.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"

namespace foresee {

namespace {

/// The midpoint of a ball, with a relative error of at most 2^-105.
DoubleDouble in_two_doubles(const Midrad128& ball) {
  const double high = ball.rounded();
  return {high, (ball.middle() - Midrad128(high)).rounded()};
}

}  // namespace

Turn::Turn(double heading) {
  int quotient = 0;
  degrees_ = std::remquo(heading, 90, &quotient);  // exact
  right_angles_ = quotient & 3;
  if (degrees_ == 0) return;
  const SineCosine<Midrad128> balls = sine_cosine(degrees_);
  close_ = {in_two_doubles(balls.sine), in_two_doubles(balls.cosine)};
}

Corner Turn::operator()(const Corner& corner) {
  const double x = right_angles_ % 2 == 0 ? corner.x : corner.y;
  const double y = right_angles_ % 2 == 0 ? corner.y : -corner.x;
  const double side = right_angles_ < 2 ? 1 : -1;
  if (degrees_ == 0) return {side * x + 0.0, side * y + 0.0};  // -0 becomes 0
  return {rounded_sum(side * x, side * y), rounded_sum(side * y, -side * x)};
}

double Turn::rounded_sum(double a, double b) {
  const DoubleDouble &c = close_.cosine, &s = close_.sine;
  const DoubleDouble ac = product(a, c.high), bs = product(b, s.high);
  const double size = std::abs(ac.high) + std::abs(bs.high);
  const DoubleDouble rough = sum(ac.high, bs.high);
  const double rest = rough.low + (ac.low + bs.low + (a * c.low + b * s.low));
  // The relative error of sine and cosine is 2^-100, that of the roundings here 2^-102 of the size, unless a
  // sine or a product is so small that it loses digits.
  const double error = 0x1p-98 * size;
  const double low = rough.high + (rest - error), high = rough.high + (rest + error);
  const bool all_digits = std::abs(degrees_) > 0x1p-900 && size > 0x1p-900 && size < 0x1p900;
  if (low == high && all_digits) return low;
  return rounded_sum_of_more_bits(a, b);
}

double Turn::rounded_sum_of_more_bits(double a, double b) {
  const double angle = std::abs(degrees_), b_side = degrees_ < 0 ? -b : b;
  if (a == 0 && b == 0) return 0;
  if (a == 0 && angle == 30) return rounded(Dyadic(b_side).scaled(-1)) + 0.0;
  const Dyadic diagonal = Dyadic(a) + Dyadic(b_side);
  if (angle == 45 && diagonal.sign() == 0) return 0;
  for (int bits = first_length;; bits *= 2) {
    if (!closer_ || bits > first_length) closer_ = sine_cosine(degrees_, bits);
    const Midrad whole =
        angle == 45 ? Midrad(diagonal, bits) * closer_->cosine
                    : Midrad(Dyadic(a), bits) * closer_->cosine + Midrad(Dyadic(b), bits) * closer_->sine;
    const double low = rounded(whole.low()), high = rounded(whole.high());
    if (low == high) return low + 0.0;  // -0 becomes 0
  }
}

Corner finite_turn(Turn& turn, const Corner& corner, double heading) {
  const Corner there = turn(corner);
  if (!std::isfinite(there.x) || !std::isfinite(there.y))
    throw Error("turned by " + shown(heading) + " degrees the corner (" + shown(corner) +
                ") is beyond the largest double");
  return there;
}

Outline turned(const Outline& outline, double heading) {
  const FloatEnvironment environment;
  Turn turn(heading);
  Outline turned_outline;
  for (std::size_t part = 0; part < outline.parts(); ++part)
    for (std::size_t r = outline.part_start(part); r < outline.part_start(part + 1); ++r) {
      r == outline.part_start(part) ? turned_outline.begin_part() : turned_outline.begin_hole();
      for (const Corner& corner : outline.ring(r)) turned_outline.add(finite_turn(turn, corner, heading));
      turned_outline.close_ring();
    }
  return turned_outline;
}

// Here and not inline: exact turns need Boost, which users of the core need not have.
Outline SharedOutline::rotated(double heading) const {
  if (heading == 0) return outline_;
  std::call_once(checked_, [this] { edge_touch_ = edge_touch_of(outline_); });
  Outline turned_outline = turned(outline_, heading);
  check_turned(outline_, edge_touch_, turned_outline, heading);
  return turned_outline;
}

}  // namespace foresee
