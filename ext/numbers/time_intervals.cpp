#include "numbers/time_intervals.h"

#include <algorithm>

#include "numbers/interval_newton.h"
#include "numbers/quadratic_root.h"

namespace foresee {
namespace {

/// Times in increasing order, each with the polynomial's sign: roots lie at them or between neighbours.
struct Waypoints {
  struct Waypoint {
    AlgebraicRoot* root;
    int sign;
  };
  std::array<Waypoint, 2 * LazyPolynomial::max_degree + 1> list;
  int count = 0;

  void add(AlgebraicRoot* root, int sign) { list[count++] = {root, sign}; }
};

/// The sign of the discriminant `d`. If 128 bits do not decide, `d` comes from the exact coefficients, and the
/// enclosures of the coefficients are sharpened.
int discriminant_of(LazyPolynomial& polynomial, Midrad128& d) {
  const auto& c = polynomial.rough();
  d = c[1] * c[1] - (c[0] * c[2]).scaled(2);
  if (d.sign() == unknown_sign || (c[1].sign() == unknown_sign && d.sign() > 0)) {
    polynomial.sharpen();
    d = Midrad128(discriminant(polynomial.exact()));
  }
  return d.sign();
}

/// All real roots of degree 1 and 2, in order.
Roots roots_by_formula(LazyPolynomial& polynomial) {
  Roots roots;
  const int degree = polynomial.degree();
  if (degree < 1) return roots;
  if (degree == 1) {
    roots.list[roots.count++] = &polynomial.add_root(0, -polynomial.rough()[0] / polynomial.rough()[1]);
    return roots;
  }
  Midrad128 d;
  const int sign = discriminant_of(polynomial, d);
  const auto& c = polynomial.rough();
  if (sign < 0) return roots;
  if (sign == 0) {
    roots.list[roots.count++] = &polynomial.add_root(0, -c[1] / c[2].scaled(1));
    return roots;
  }
  const Midrad128 product = product_of_root(c, d);
  for (int which : {-1, 1})
    roots.list[roots.count++] = &polynomial.add_root(which, root_of_quadratic(c, product, which));
  return roots;
}

TimeIntervals clipped(std::initializer_list<TimeInterval> intervals, const QueriedInterval& queried) {
  TimeIntervals kept;
  for (TimeInterval s : intervals) {
    if (s.first != &queried.begin && compare(*s.first, queried.begin) < 0) s.first = &queried.begin;
    if (s.last != &queried.end && compare(*s.last, queried.end) > 0) s.last = &queried.end;
    if (compare(*s.first, *s.last) <= 0) kept.push_back(s);
  }
  return kept;
}

TimeIntervals inside_by_formula(LazyPolynomial& polynomial, const QueriedInterval& queried) {
  const Roots roots = roots_by_formula(polynomial);
  AlgebraicRoot *const begin = &queried.begin, *const end = &queried.end;
  const int lead = polynomial.lead();
  if (roots.count == 0) return lead <= 0 ? clipped({{begin, end}}, queried) : TimeIntervals{};
  AlgebraicRoot *const one = roots.list[0], *const other = roots.list[roots.count - 1];
  if (polynomial.degree() == 1)
    return clipped({lead > 0 ? TimeInterval{begin, one} : TimeInterval{one, end}}, queried);
  if (lead > 0) return clipped({{one, other}}, queried);
  if (one == other) return clipped({{begin, end}}, queried);
  return clipped({{begin, one}, {other, end}}, queried);
}

/// The only root between two neighbours at which the signs differ.
AlgebraicRoot& root_between(LazyPolynomial& polynomial, AlgebraicRoot& before, AlgebraicRoot& after,
                            int sign_before) {
  const Midrad128 low = before.at.high(), high = after.at.low();
  if ((high - low).sign() == 1 && polynomial.value_at(low).sign() == sign_before &&
      polynomial.value_at(high).sign() == -sign_before) {
    const IntervalNewton<Midrad128> narrow(polynomial.rough(), polynomial.degree(), low, high, sign_before,
                                           128);
    AlgebraicRoot& root = polynomial.add_root(narrow.low.dyadic(), narrow.high.dyadic(), sign_before);
    root.recognize();
    return root;
  }
  // The root is so near to a neighbour that 128 bits do not separate them.
  for (int bits = first_length;; bits *= 2) {
    const Dyadic left = before.enclosure(bits).high(), right = after.enclosure(bits).low();
    const auto sign_at = [&](const Dyadic& x) {
      return value_at(polynomial.enclosure(bits), polynomial.degree(), Midrad(x, bits)).sign();
    };
    if (!(left < right) || sign_at(left) != sign_before || sign_at(right) != -sign_before) continue;
    AlgebraicRoot& root = polynomial.add_root(left, right, sign_before);
    root.enclosure(first_length);
    root.recognize();
    return root;
  }
}

Waypoints waypoints_of(LazyPolynomial& polynomial, const QueriedInterval& queried);

}  // namespace

Roots zeros_within(LazyPolynomial& polynomial, const QueriedInterval& queried) {
  Roots zeros;
  if (polynomial.degree() <= 2) {
    const Roots all = roots_by_formula(polynomial);
    for (int i = 0; i < all.count; ++i)
      if (compare(*all.list[i], queried.begin) > 0 && compare(*all.list[i], queried.end) < 0)
        zeros.list[zeros.count++] = all.list[i];
    return zeros;
  }
  const Waypoints waypoints = waypoints_of(polynomial, queried);
  for (int i = 1; i + 1 < waypoints.count; ++i)
    if (waypoints.list[i].sign == 0) zeros.list[zeros.count++] = waypoints.list[i].root;
  return zeros;
}

namespace {

/// The ends of the interval, the zeros of the slope, and the roots between them.
Waypoints waypoints_of(LazyPolynomial& polynomial, const QueriedInterval& queried) {
  const Roots turns = zeros_within(polynomial.slope(), queried);
  Waypoints waypoints;
  waypoints.add(&queried.begin, polynomial.sign_at(queried.begin));
  for (int i = 0; i <= turns.count; ++i) {
    AlgebraicRoot& next = i < turns.count ? *turns.list[i] : queried.end;
    const auto last = waypoints.list[waypoints.count - 1];
    const int sign = polynomial.sign_at(next);
    if (last.sign * sign < 0) waypoints.add(&root_between(polynomial, *last.root, next, last.sign), 0);
    waypoints.add(&next, sign);
  }
  return waypoints;
}

/// 12 C(i, k) / C(n, k): converts powers of y on [0, 1] to the Bernstein basis, times 12.
constexpr int bernstein_weight(int n, int i, int k) {
  constexpr int choose[5][5] = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  return 12 * choose[i][k] / choose[n][k];
}

/// The common sign of the Bernstein coefficients, and so of the polynomial on the whole interval; 0 if they
/// have none.
int constant_sign(LazyPolynomial& polynomial, const QueriedInterval& queried) {
  const int n = polynomial.degree();
  const Midrad128 width = queried.end.at - queried.begin.at;
  std::array<Midrad128, LazyPolynomial::max_degree + 1> d = polynomial.rough();
  for (int k = 0; k < n; ++k)
    for (int i = n - 1; i >= k; --i) d[i] = d[i] + queried.begin.at * d[i + 1];
  Midrad128 scale = width;
  for (int k = 1; k <= n; ++k, scale = scale * width) d[k] = d[k] * scale;
  int all = 0;
  for (int i = 0; i <= n; ++i) {
    Midrad128 b;
    for (int k = 0; k <= i; ++k) b = b + d[k] * Midrad128(bernstein_weight(n, i, k));
    const int sign = b.sign();
    if (sign == 0 || sign == unknown_sign || (all != 0 && sign != all)) return 0;
    all = sign;
  }
  return all;
}

}  // namespace

TimeIntervals sublevel_intervals(LazyPolynomial& polynomial, const QueriedInterval& queried) {
  if (polynomial.degree() <= 2) return inside_by_formula(polynomial, queried);
  TimeIntervals intervals;
  const int constant = constant_sign(polynomial, queried);
  if (constant < 0) intervals.push_back({&queried.begin, &queried.end});
  if (constant != 0) return intervals;
  const Waypoints waypoints = waypoints_of(polynomial, queried);
  // There is no root between two neighbours, so the polynomial is at most 0 between them if it is at both.
  for (int i = 0; i < waypoints.count; ++i) {
    if (waypoints.list[i].sign > 0) continue;
    int last = i;
    while (last + 1 < waypoints.count && waypoints.list[last + 1].sign <= 0) ++last;
    intervals.push_back({waypoints.list[i].root, waypoints.list[last].root});
    i = last;
  }
  return intervals;
}

TimeIntervals complement(const TimeIntervals& inside, const QueriedInterval& queried) {
  TimeIntervals gaps;
  AlgebraicRoot* first = &queried.begin;
  for (const TimeInterval& interval : inside) {
    if (interval.first != &queried.begin) gaps.push_back({first, interval.first});
    first = interval.last;
  }
  if (first != &queried.end) gaps.push_back({first, &queried.end});
  return gaps;
}

TimeIntervals common(const TimeIntervals& a, const TimeIntervals& b) {
  TimeIntervals both;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const TimeInterval &s = a[i], &other = b[j];
    AlgebraicRoot* const first = compare(*s.first, *other.first) >= 0 ? s.first : other.first;
    const bool s_ends = compare(*s.last, *other.last) <= 0;
    AlgebraicRoot* const last = s_ends ? s.last : other.last;
    if (compare(*first, *last) <= 0) both.push_back({first, last});
    ++(s_ends ? i : j);
  }
  return both;
}

}  // namespace foresee
