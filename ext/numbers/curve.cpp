#include "numbers/curve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/interval_newton.h"
#include "numbers/quadratic_formula.h"
#include "numbers/quadratic_root.h"

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

/// As rounding has it, infinity stands for 2^1024.
Dyadic as_bound(double value) {
  if (std::isfinite(value)) return Dyadic(value);
  return value > 0 ? Dyadic::power_of_two(1024) : -Dyadic::power_of_two(1024);
}

/// The number of the fewest bits between the two. Requires: 0 < low < high.
Dyadic simplest_between(const Dyadic& low, const Dyadic& high) {
  const int unit = std::min(low.exponent(), high.exponent());
  const auto in_units = [unit](const Dyadic& x) { return Integer(x.mantissa() << (x.exponent() - unit)); };
  // Of (below, last] the multiple of the greatest power of two: where their leading bits part.
  const Integer below = in_units(low), last = in_units(high);
  const int cut = length_of(below ^ last) - 1;
  return {last >> cut, unit + cut};
}

/// Is the event, a simple root of a polynomial that `divisor` divides, a root of it too?
bool has_root_at(const Polynomial& divisor, const Event& event) {
  return sign_at(divisor, event.bracket->low) * sign_at(divisor, event.bracket->high) <= 0;
}

}  // namespace

Midrad Event::enclosure(int bits) {
  if (known) return {*known, bits};
  if (!bracket) bracket = std::make_unique<Bracket>(Bracket{at.low().dyadic(), at.high().dyadic(), 0, 0});
  Bracket& b = *bracket;
  if (b.bits < bits) {
    b.bits = bits;
    if (curve->degree() > 2) {
      narrow(bits);
    } else {
      const Midrad root = by_formula(bits);
      b.low = root.low(), b.high = root.high();
    }
  }
  return Midrad::hull(b.low, b.high, bits);
}

void Event::recognize() {
  Bracket& b = *bracket;
  if (!(b.low < b.high)) return;
  const int digits = b.high.magnitude() - (b.high - b.low).magnitude();
  if (b.low.sign() <= 0 || digits <= 0) return;
  const Dyadic simplest = simplest_between(b.low, b.high);
  if (2 * length_of(simplest.mantissa()) > digits || curve->sign_at(simplest) != 0) return;
  b.low = b.high = simplest;
  at = Midrad128(simplest), known = &b.low;
}

void Event::narrow(int bits) {
  Bracket& b = *bracket;
  const int enough = b.high.sign() == 0 ? 0 : b.high.magnitude() - bits;
  const auto wide = [enough](const Dyadic& low, const Dyadic& high) {
    const Dyadic width = high - low;
    return width.sign() > 0 && width.magnitude() > enough;
  };
  if (!wide(b.low, b.high)) return;
  const auto p = curve->enclosure(bits);
  const int degree = curve->degree();
  // Seen from the nearer end, which may be next to the root of another curve, a few digits tell.
  const bool from_low = value_at(p, degree, Midrad(half_of(b.low + b.high), bits)).sign() != b.sign_low;
  const Dyadic origin = from_low ? b.low : b.high;
  auto local = around(p, degree, Midrad(origin, bits));
  if (!from_low) local[1] = -local[1], local[3] = -local[3];
  Dyadic near, far = b.high - b.low;
  for (int length = 128; length < bits && wide(near, far); length *= 2) {
    Powers<Midrad> cut;
    std::transform(local.begin(), local.end(), cut.begin(),
                   [&](const Midrad& c) { return c.cut_to(length); });
    const IntervalNewton<Midrad> n(cut, degree, near, far, from_low ? b.sign_low : -b.sign_low, length);
    near = n.low, far = n.high;
  }
  b.low = from_low ? origin + near : origin - far;
  b.high = from_low ? origin + far : origin - near;
}

Midrad Event::by_formula(int bits) const {
  const auto c = curve->enclosure(bits);
  if (curve->degree() == 1) return -c[0] / c[1];
  if (which == 0) return -c[1] / c[2].scaled(1);
  const Midrad d = c[1] * c[1] - (c[0] * c[2]).scaled(2);
  if (d.sign() == unknown_sign) return {at, bits};
  return root_of_quadratic(c, product_of_root(c, d), which);
}

int compare(Event& x, const Dyadic& y) {
  if (x.known) return (*x.known - y).sign();
  Curve& curve = *x.curve;
  if (curve.degree() > 2) {
    if (y < x.bracket->low) return 1;
    if (x.bracket->high < y) return -1;
    const int sign = curve.sign_at(y);
    return sign == x.bracket->sign_low ? 1 : -sign * sign;
  }
  return -side_of_root(curve, x.which, curve.sign_at(y), [&] { return curve.slope().sign_at(y); });
}

namespace {
/// The roots of two curves that differ by a constant, up to their sign, as the faces across one axis do: the
/// higher curve, if both are open upwards, has its roots nearer to the turn. Nothing if they are others.
std::optional<int> compare_by_constant(const Event& x, const Event& y) {
  const Polynomial &p = x.curve->exact(), &q = y.curve->exact();
  if (p.degree != q.degree) return {};
  const int lead = p.c[p.degree].sign();
  const bool mirrored = lead != q.c[q.degree].sign();
  const auto of_q = [&](int k) { return mirrored ? -q.c[k] : q.c[k]; };
  for (int k = 1; k <= p.degree; ++k)
    if (p.c[k] != of_q(k)) return {};
  const int higher = lead * (p.c[0] - of_q(0)).sign();
  if (p.degree == 1) return -higher;
  if (x.which != y.which) return x.which < y.which ? -1 : 1;
  return -x.which * higher;
}

/// Of different moments, narrowed until they are apart.
int compare_by_length(Event& x, Event& y) {
  for (int bits = first_length;; bits *= 2) {
    const int sign = (x.enclosure(bits) - y.enclosure(bits)).sign();
    if (sign != unknown_sign) return sign;
  }
}
}  // namespace

int compare(Event& x, Event& y) {
  if (&x == &y) return 0;
  const int rough = (x.at - y.at).sign();
  if (rough != unknown_sign) return rough;
  if (y.known) return compare(x, *y.known);
  if (x.known) return -compare(y, *x.known);
  if (x.curve->degree() > y.curve->degree()) return -compare(y, x);
  if (y.curve->degree() <= 2) {
    if (const auto order = compare_by_constant(x, y)) return *order;
    if (surely_coprime(x.curve->exact(), y.curve->exact())) return compare_by_length(x, y);
    return side_of_root(*y.curve, y.which, y.curve->sign_at(x), [&] { return y.curve->slope().sign_at(x); });
  }
  // Copies, as the bracket may be narrowed meanwhile.
  const Dyadic low = y.bracket->low, high = y.bracket->high;
  if (compare(x, low) < 0) return -1;
  if (compare(x, high) > 0) return 1;
  const int sign = y.curve->sign_at(x);
  return sign == y.bracket->sign_low ? -1 : sign * sign;
}

double rounded(Event& event, const Dyadic& offset) {
  const Midrad128 moment = event.at + Midrad128(offset);
  double low = moment.low().rounded(), high = moment.high().rounded();
  for (int bits = first_length; low != high && std::nextafter(low, high) != high; bits *= 2) {
    const Midrad enclosure = event.enclosure(bits);
    low = rounded(enclosure.low() + offset), high = rounded(enclosure.high() + offset);
  }
  if (low == high) return low;
  const Dyadic tie = half_of(as_bound(low) + as_bound(high));
  const int side = compare(event, tie - offset);
  return side == 0 ? rounded(tie) : side < 0 ? low : high;
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
  for (int k = 0; k <= most; ++k) rough_[k] = k <= degree_ ? Midrad128(p.c[k]) : Midrad128();
}

std::array<Midrad, Curve::most + 1> Curve::enclosure(int bits) {
  std::array<Midrad, most + 1> c;
  for (int k = 0; k <= exact().degree; ++k) c[k] = Midrad(exact().c[k], bits);
  return c;
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
    for (int k = 1; k <= degree(); ++k) c[k - 1] = rough_[k] * Midrad128(k);
    slope_ = std::make_unique<Curve>(c, *source_, number_);
    slope_->parent_ = this;
  }
  return *slope_;
}

Event& Curve::add_root(int which, const Midrad128& at) {
  Event& event = roots_[root_count_++];
  event.at = at, event.curve = this, event.which = which;
  return event;
}

Event& Curve::add_root(const Dyadic& low, const Dyadic& high, int sign_low) {
  Event& event = add_root(0, Midrad128::hull(Midrad128(low), Midrad128(high)));
  event.bracket = std::make_unique<Event::Bracket>(Event::Bracket{low, high, sign_low, 0});
  return event;
}

Midrad128 Curve::value_at(const Midrad128& tau) const {
  return foresee::value_at(rough_, degree_ <= most ? degree_ : most, tau);
}

namespace {
/// Near a turn, where the slope almost vanishes, an enclosure half as long will do.
Midrad value_within(const Powers<Midrad>& p, int degree, const Midrad& x, int bits) {
  const Midrad middle(x.middle(), bits);
  return value_at(around(p, degree, middle), degree, x - middle);
}
}  // namespace

int Curve::sign_at(Event& event) {
  if (event.curve == this) return 0;
  if (event.known) return sign_at(*event.known);
  int sign = value_at(event.at).sign();
  if (sign != unknown_sign) return sign;
  const Polynomial &p = event.curve->exact(), &q = exact();
  if (!surely_coprime(p, q)) {
    if (p.degree <= 2) return sign_at_root(q, p, event.which);
    if (has_root_at(common_divisor(p, q), event)) return 0;
  }
  const bool turns = event.curve->parent_ == this;
  for (int bits = first_length; sign == unknown_sign; bits *= 2)
    sign = value_within(enclosure(bits), q.degree, event.enclosure(turns ? bits / 2 : bits), bits).sign();
  return sign;
}

int Curve::sign_at(const Dyadic& tau) {
  int sign = value_at(Midrad128(tau)).sign();
  for (int bits = first_length; sign == unknown_sign; bits *= 2)
    sign = foresee::value_at(enclosure(bits), exact().degree, Midrad(tau, bits)).sign();
  return sign;
}

}  // namespace foresee
