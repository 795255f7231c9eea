#include "numbers/algebraic_root.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/interval_newton.h"
#include "numbers/quadratic_root.h"

namespace foresee {
namespace {

/// The sign of x - r for the polynomial's root r, number `which`, from the signs at x of the polynomial and
/// its slope.
int side_of_root(LazyPolynomial& polynomial, int which, int sign, auto&& sign_of_slope) {
  const int lead = polynomial.lead();
  sign *= lead;
  if (polynomial.degree() == 1) return sign;
  if (sign < 0) return -which;  // between the roots
  const int slope = lead * sign_of_slope();
  if (sign > 0 || which == 0) return slope;
  return slope == which ? 0 : slope;
}

/// For rounding, infinity counts as 2^1024.
Dyadic as_bound(double value) {
  if (std::isfinite(value)) return Dyadic(value);
  return value > 0 ? Dyadic::power_of_two(1024) : -Dyadic::power_of_two(1024);
}

/// The number with the fewest bits between the two. Requires: 0 < low < high.
Dyadic simplest_between(const Dyadic& low, const Dyadic& high) {
  const int unit = std::min(low.exponent(), high.exponent());
  const auto in_units = [unit](const Dyadic& x) { return Integer(x.mantissa() << (x.exponent() - unit)); };
  // The multiple of the largest power of two in (below, last]: it ends where their leading bits differ.
  const Integer below = in_units(low), last = in_units(high);
  const int cut = bit_length(below ^ last) - 1;
  return {last >> cut, unit + cut};
}

/// Whether the root is a root of `divisor` too. Requires: it is a simple root of a polynomial that `divisor`
/// divides.
bool has_root_at(const Polynomial& divisor, const AlgebraicRoot& root) {
  return sign_at(divisor, root.bracket->low) * sign_at(divisor, root.bracket->high) <= 0;
}

}  // namespace

Midrad AlgebraicRoot::enclosure(int bits) {
  if (known) return {*known, bits};
  if (!bracket) bracket = std::make_unique<Bracket>(Bracket{at.low().dyadic(), at.high().dyadic(), 0, 0});
  Bracket& b = *bracket;
  if (b.bits < bits) {
    b.bits = bits;
    if (polynomial->degree() > 2) {
      narrow(bits);
    } else {
      const Midrad root = by_formula(bits);
      b.low = root.low(), b.high = root.high();
    }
  }
  return Midrad::hull(b.low, b.high, bits);
}

void AlgebraicRoot::recognize() {
  Bracket& b = *bracket;
  if (!(b.low < b.high)) return;
  const int digits = b.high.magnitude() - (b.high - b.low).magnitude();
  if (b.low.sign() <= 0 || digits <= 0) return;
  const Dyadic simplest = simplest_between(b.low, b.high);
  if (2 * bit_length(simplest.mantissa()) > digits || polynomial->sign_at(simplest) != 0) return;
  b.low = b.high = simplest;
  at = Midrad128(simplest), known = &b.low;
}

void AlgebraicRoot::narrow(int bits) {
  Bracket& b = *bracket;
  const int enough = b.high.sign() == 0 ? 0 : b.high.magnitude() - bits;
  const auto wide = [enough](const Dyadic& low, const Dyadic& high) {
    const Dyadic width = high - low;
    return width.sign() > 0 && width.magnitude() > enough;
  };
  if (!wide(b.low, b.high)) return;
  const auto p = polynomial->enclosure(bits);
  const int degree = polynomial->degree();
  // Measured from the nearer end, which may be next to the root of another polynomial, few digits suffice.
  const bool from_low = value_at(p, degree, Midrad(half_of(b.low + b.high), bits)).sign() != b.sign_low;
  const Dyadic origin = from_low ? b.low : b.high;
  auto local = around(p, degree, Midrad(origin, bits));
  if (!from_low) local[1] = -local[1], local[3] = -local[3];
  Dyadic near, far = b.high - b.low;
  for (int length = 128; length < bits && wide(near, far); length *= 2) {
    Coefficients<Midrad> cut;
    std::transform(local.begin(), local.end(), cut.begin(),
                   [&](const Midrad& c) { return c.cut_to(length); });
    const IntervalNewton<Midrad> n(cut, degree, near, far, from_low ? b.sign_low : -b.sign_low, length);
    near = n.low, far = n.high;
  }
  b.low = from_low ? origin + near : origin - far;
  b.high = from_low ? origin + far : origin - near;
}

Midrad AlgebraicRoot::by_formula(int bits) const {
  const auto c = polynomial->enclosure(bits);
  if (polynomial->degree() == 1) return -c[0] / c[1];
  if (which == 0) return -c[1] / c[2].scaled(1);
  const Midrad d = c[1] * c[1] - (c[0] * c[2]).scaled(2);
  if (d.sign() == unknown_sign) return {at, bits};
  return root_of_quadratic(c, product_of_root(c, d), which);
}

int compare(AlgebraicRoot& x, const Dyadic& y) {
  if (x.known) return (*x.known - y).sign();
  LazyPolynomial& polynomial = *x.polynomial;
  if (polynomial.degree() > 2) {
    if (y < x.bracket->low) return 1;
    if (x.bracket->high < y) return -1;
    const int sign = polynomial.sign_at(y);
    return sign == x.bracket->sign_low ? 1 : -sign * sign;
  }
  return -side_of_root(polynomial, x.which, polynomial.sign_at(y),
                       [&] { return polynomial.slope().sign_at(y); });
}

namespace {
/// Compares roots of two polynomials that differ by a constant, up to their sign, as those of opposite faces
/// do. If both open upwards, the higher polynomial has its roots nearer to the turning point. Empty for other
/// polynomials.
std::optional<int> compare_by_constant(const AlgebraicRoot& x, const AlgebraicRoot& y) {
  const Polynomial &p = x.polynomial->exact(), &q = y.polynomial->exact();
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

/// Compares roots at different times: narrows both until their intervals are disjoint.
int compare_by_length(AlgebraicRoot& x, AlgebraicRoot& y) {
  for (int bits = first_length;; bits *= 2) {
    const int sign = (x.enclosure(bits) - y.enclosure(bits)).sign();
    if (sign != unknown_sign) return sign;
  }
}
}  // namespace

int compare(AlgebraicRoot& x, AlgebraicRoot& y) {
  if (&x == &y) return 0;
  const int rough = (x.at - y.at).sign();
  if (rough != unknown_sign) return rough;
  if (y.known) return compare(x, *y.known);
  if (x.known) return -compare(y, *x.known);
  if (x.polynomial->degree() > y.polynomial->degree()) return -compare(y, x);
  if (y.polynomial->degree() <= 2) {
    if (const auto order = compare_by_constant(x, y)) return *order;
    if (surely_coprime(x.polynomial->exact(), y.polynomial->exact())) return compare_by_length(x, y);
    return side_of_root(*y.polynomial, y.which, y.polynomial->sign_at(x),
                        [&] { return y.polynomial->slope().sign_at(x); });
  }
  // Copies, because the bracket may be narrowed meanwhile.
  const Dyadic low = y.bracket->low, high = y.bracket->high;
  if (compare(x, low) < 0) return -1;
  if (compare(x, high) > 0) return 1;
  const int sign = y.polynomial->sign_at(x);
  return sign == y.bracket->sign_low ? -1 : sign * sign;
}

double rounded(AlgebraicRoot& root, const Dyadic& offset) {
  const Midrad128 time = root.at + Midrad128(offset);
  double low = time.low().rounded(), high = time.high().rounded();
  for (int bits = first_length; low != high && std::nextafter(low, high) != high; bits *= 2) {
    const Midrad enclosure = root.enclosure(bits);
    low = rounded(enclosure.low() + offset), high = rounded(enclosure.high() + offset);
  }
  if (low == high) return low;
  const Dyadic tie = half_of(as_bound(low) + as_bound(high));
  const int side = compare(root, tie - offset);
  return side == 0 ? rounded(tie) : side < 0 ? low : high;
}

const Polynomial& LazyPolynomial::exact() {
  if (!exact_)
    exact_ = std::make_unique<Polynomial>(parent_ ? derivative(parent_->exact())
                                                  : source_->exact_polynomial(number_));
  return *exact_;
}

void LazyPolynomial::sharpen() {
  const Polynomial& p = exact();
  degree_ = p.degree;
  for (int k = 0; k <= max_degree; ++k) rough_[k] = k <= degree_ ? Midrad128(p.c[k]) : Midrad128();
}

std::array<Midrad, LazyPolynomial::max_degree + 1> LazyPolynomial::enclosure(int bits) {
  std::array<Midrad, max_degree + 1> c;
  for (int k = 0; k <= exact().degree; ++k) c[k] = Midrad(exact().c[k], bits);
  return c;
}

int LazyPolynomial::degree() {
  if (degree_ <= max_degree) return degree_;
  int degree = max_degree;
  while (degree >= 0 && rough_[degree].sign() == 0) --degree;
  if (degree >= 0 && rough_[degree].sign() == unknown_sign)
    sharpen();
  else
    degree_ = degree;
  return degree_;
}

LazyPolynomial& LazyPolynomial::slope() {
  if (!slope_) {
    RoughCoefficients c;
    for (int k = 1; k <= degree(); ++k) c[k - 1] = rough_[k] * Midrad128(k);
    slope_ = std::make_unique<LazyPolynomial>(c, *source_, number_);
    slope_->parent_ = this;
  }
  return *slope_;
}

AlgebraicRoot& LazyPolynomial::add_root(int which, const Midrad128& at) {
  AlgebraicRoot& root = roots_[root_count_++];
  root.at = at, root.polynomial = this, root.which = which;
  return root;
}

AlgebraicRoot& LazyPolynomial::add_root(const Dyadic& low, const Dyadic& high, int sign_low) {
  AlgebraicRoot& root = add_root(0, Midrad128::hull(Midrad128(low), Midrad128(high)));
  root.bracket = std::make_unique<AlgebraicRoot::Bracket>(AlgebraicRoot::Bracket{low, high, sign_low, 0});
  return root;
}

Midrad128 LazyPolynomial::value_at(const Midrad128& tau) const {
  return foresee::value_at(rough_, degree_ <= max_degree ? degree_ : max_degree, tau);
}

namespace {
/// Near a turning point, where the slope almost vanishes, an enclosure of half the length suffices.
Midrad value_within(const Coefficients<Midrad>& p, int degree, const Midrad& x, int bits) {
  const Midrad middle(x.middle(), bits);
  return value_at(around(p, degree, middle), degree, x - middle);
}
}  // namespace

int LazyPolynomial::sign_at(AlgebraicRoot& root) {
  if (root.polynomial == this) return 0;
  if (root.known) return sign_at(*root.known);
  int sign = value_at(root.at).sign();
  if (sign != unknown_sign) return sign;
  const Polynomial &p = root.polynomial->exact(), &q = exact();
  if (!surely_coprime(p, q)) {
    if (p.degree <= 2) return sign_at_root(q, p, root.which);
    if (has_root_at(common_divisor(p, q), root)) return 0;
  }
  const bool turns = root.polynomial->parent_ == this;
  for (int bits = first_length; sign == unknown_sign; bits *= 2)
    sign = value_within(enclosure(bits), q.degree, root.enclosure(turns ? bits / 2 : bits), bits).sign();
  return sign;
}

int LazyPolynomial::sign_at(const Dyadic& tau) {
  int sign = value_at(Midrad128(tau)).sign();
  for (int bits = first_length; sign == unknown_sign; bits *= 2)
    sign = foresee::value_at(enclosure(bits), exact().degree, Midrad(tau, bits)).sign();
  return sign;
}

}  // namespace foresee
