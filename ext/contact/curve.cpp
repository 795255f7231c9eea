#include "contact/curve.h"

#include <bit>
#include <cmath>
#include <limits>

#include "contact/quadratic_root.h"

namespace foresee {
namespace {

/// The sign of x - r from the signs at x of the curve and its slope; r is the curve's root `which`.
int side_of_root(Curve& curve, int which, int sign, auto&& sign_of_slope) {
  const int lead = curve.lead();
  sign *= lead;
  if (curve.degree() == 1) return sign;
  if (sign < 0) return -which;  // between the roots
  const int slope = lead * sign_of_slope();
  if (sign > 0 || which == 0) return slope;
  return slope == which ? 0 : slope;
}

/// Doubles in their order as whole numbers.
std::int64_t place_of(double value) {
  const auto pattern = std::bit_cast<std::int64_t>(value + 0.0);
  return pattern >= 0 ? pattern : std::numeric_limits<std::int64_t>::min() - pattern;
}
double double_at(std::int64_t place) {
  return std::bit_cast<double>(place >= 0 ? place : std::numeric_limits<std::int64_t>::min() - place);
}

/// As rounding has it, infinity stands for 2^1024.
Dyadic as_bound(double value) {
  if (std::isfinite(value)) return Dyadic(value);
  return value > 0 ? Dyadic::power_of_two(1024) : -Dyadic::power_of_two(1024);
}

}  // namespace

Root& Event::root() {
  if (!narrowed) narrowed = std::make_unique<Root>(curve->exact(), low.dyadic(), high.dyadic(), sign_low);
  return *narrowed;
}

int compare(Event& x, const Dyadic& y) {
  if (x.known) return (*x.known - y).sign();
  Curve& curve = *x.curve;
  if (curve.degree() > 2) return x.root().compare(y);
  return -side_of_root(curve, x.which, curve.sign_at(y), [&] { return curve.slope().sign_at(y); });
}

int compare(Event& x, Event& y) {
  if (&x == &y) return 0;
  const int rough = (x.at - y.at).sign();
  if (rough != unknown_sign) return rough;
  if (y.known) return compare(x, *y.known);
  if (x.known) return -compare(y, *x.known);
  if (y.curve->degree() <= 2)
    return side_of_root(*y.curve, y.which, y.curve->sign_at(x), [&] { return y.curve->slope().sign_at(x); });
  if (x.curve->degree() <= 2) return -compare(y, x);
  const Dyadic low = y.root().low(), high = y.root().high();
  const int after_low = compare(x, low);
  if (after_low <= 0 || low == high) return after_low;
  if (compare(x, high) >= 0) return 1;
  const int sign = y.curve->sign_at(x);
  return sign == y.sign_low ? -1 : sign == 0 ? 0 : 1;
}

double rounded(Event& event, const Dyadic& offset) {
  const Wide moment = event.at + Wide(offset);
  std::int64_t low = place_of(moment.low().rounded()), high = place_of(moment.high().rounded());
  // The answer is one of [low, high]; where they differ, exact comparisons narrow them.
  while (low < high - 1) {
    const std::int64_t middle = low / 2 + high / 2 + (low % 2 + high % 2) / 2;
    const int side = compare(event, Dyadic(double_at(middle)) - offset);
    if (side == 0) return double_at(middle);
    (side > 0 ? low : high) = middle;
  }
  if (low == high) return double_at(low);
  const Dyadic tie = half_of(as_bound(double_at(low)) + as_bound(double_at(high)));
  const int side = compare(event, tie - offset);
  return side == 0 ? rounded(tie) : double_at(side < 0 ? low : high);
}

const Polynomial& Curve::exact() {
  if (!exact_)
    exact_ =
        std::make_unique<Polynomial>(parent_ ? derivative(parent_->exact()) : source_->polynomial(number_));
  return *exact_;
}

void Curve::sharpen() {
  const Polynomial& p = exact();
  degree_ = p.degree;
  for (int k = 0; k <= most; ++k) rough_[k] = k <= degree_ ? Wide(Dyadic(p.c[k], 0)) : Wide();
}

int Curve::degree() {
  if (degree_ <= most) return degree_;
  int degree = most;
  while (degree >= 0 && rough_[degree].sign() == 0) --degree;
  if (degree >= 0 && rough_[degree].sign() == unknown_sign)
    sharpen();
  else
    degree_ = degree;
  return degree_;
}

Curve& Curve::slope() {
  if (!slope_) {
    Coefficients c;
    for (int k = 1; k <= degree(); ++k) c[k - 1] = rough_[k] * Wide(k);
    slope_ = std::make_unique<Curve>(c, *source_, number_);
    slope_->parent_ = this;
  }
  return *slope_;
}

Event& Curve::add_root(int which, const Wide& at) {
  Event& event = roots_[root_count_++];
  event.at = at, event.curve = this, event.which = which;
  return event;
}

Event& Curve::add_root(const Wide& low, const Wide& high, int sign_low) {
  Event& event = add_root(0, Wide::hull(low, high));
  event.low = low, event.high = high, event.sign_low = sign_low;
  return event;
}

Event& Curve::add_root(Root&& root, int sign_low) {
  Event& event = add_root(Wide(root.low()).low(), Wide(root.high()).high(), sign_low);
  event.narrowed = std::make_unique<Root>(std::move(root));
  return event;
}

Wide Curve::value_at(const Wide& tau) const {
  const int highest = degree_ <= most ? degree_ : most;
  if (highest < 0) return {};
  Wide value = rough_[highest];
  for (int k = highest - 1; k >= 0; --k) value = value * tau + rough_[k];
  return value;
}

int Curve::sign_at(Event& event) {
  if (event.curve == this) return 0;
  const int sign = value_at(event.at).sign();
  if (sign != unknown_sign) return sign;
  if (event.known) return foresee::sign_at(exact(), *event.known);
  if (event.curve->degree() <= 2) return sign_at_root(exact(), event.curve->exact(), event.which);
  return event.root().sign_of(exact());
}

int Curve::sign_at(const Dyadic& tau) {
  const int sign = value_at(Wide(tau)).sign();
  return sign != unknown_sign ? sign : foresee::sign_at(exact(), tau);
}

}  // namespace foresee
