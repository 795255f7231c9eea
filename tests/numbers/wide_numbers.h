// Roots to 1,500 bits, as a judge: polynomials of small whole coefficients differ from 0 at a root of each
// other by far more than 2^-1000, or not at all.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "numbers/polynomial.h"
#include "numbers/rationals.h"

namespace foresee::judge {

using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<1500, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

inline Wide wide(const Dyadic& number) {
  return ldexp(Wide(Whole(number.mantissa())), number.exponent());
}
/// Without what is below 2^-1450.
inline Rational rational(const Wide& value) {
  return Rational(ldexp(value, 1450).convert_to<Whole>()) * power_of_two(-1450);
}
inline Wide value_at(const Polynomial& p, const Wide& x) {
  Wide value = 0;
  for (int k = p.degree; k >= 0; --k) value = value * x + wide(p.c[k]);
  return value;
}
/// -1, 0, 1; what is nearer to 0 than 2^-1000 is 0.
inline int sign_of(const Wide& value) {
  return abs(value) < ldexp(Wide(1), -1000) ? 0 : value < 0 ? -1 : 1;
}
/// The lesser (-1), the greater (1) or the only root (0) of degree 1 or 2.
inline Wide root_of(const Polynomial& p, int which) {
  const Wide c = wide(p.c[0]), b = wide(p.c[1]), a = wide(p.c[2]);
  if (p.degree == 1) return -c / b;
  const Wide d = which == 0 ? Wide(0) : Wide(sqrt(b * b - 4 * a * c));
  return (-b + (a > 0 ? which : -which) * d) / (2 * a);
}

}  // namespace foresee::judge
