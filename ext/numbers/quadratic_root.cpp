#include "numbers/quadratic_root.h"

namespace foresee {
namespace {

/// The sign of q at top / bottom.
int sign_at_ratio(const Polynomial& q, Dyadic top, Dyadic bottom) {
  if (bottom.sign() < 0) top = -top, bottom = -bottom;
  Dyadic value = q.c[q.degree], power(1.0);
  for (int k = q.degree - 1; k >= 0; --k) {
    power = power * bottom;
    value = value * top + q.c[k] * power;
  }
  return value.sign();
}

}  // namespace

int sign_at_root(const Polynomial& q, const Polynomial& p, int which) {
  if (q.degree < 0) return 0;
  if (p.degree == 1) return sign_at_ratio(q, -p.c[0], p.c[1]);
  if (which == 0) return sign_at_ratio(q, -p.c[1], p.c[2].scaled(1));
  const bool flip = p.c[2].sign() < 0;
  const Dyadic a = flip ? -p.c[2] : p.c[2], b = flip ? -p.c[1] : p.c[1], c = flip ? -p.c[0] : p.c[0];
  Polynomial rest = q;
  for (int k = q.degree; k >= 2; --k) {
    const Dyadic top = rest.c[k];
    for (int i = 0; i < k; ++i) rest.c[i] = rest.c[i] * a;
    rest.c[k - 1] = rest.c[k - 1] - top * b;
    rest.c[k - 2] = rest.c[k - 2] - top * c;
  }
  // 2 a q(r) = alpha + beta sqrt D
  const Dyadic alpha = (a * rest.c[0]).scaled(1) - rest.c[1] * b;
  const int sign_alpha = alpha.sign(), sign_beta = which * rest.c[1].sign();
  if (sign_beta == 0 || sign_alpha == sign_beta) return sign_alpha;
  if (sign_alpha == 0) return sign_beta;
  const int order = (alpha * alpha - rest.c[1] * rest.c[1] * discriminant(p)).sign();
  return order > 0 ? sign_alpha : order < 0 ? sign_beta : 0;
}

}  // namespace foresee
