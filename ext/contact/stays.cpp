#include "contact/stays.h"

#include <algorithm>

#include "contact/quadratic_root.h"

namespace foresee {
namespace {

/// What roots and the moments between them are found among: in order of time, each with the curve's sign.
struct Waypoints {
  struct Waypoint {
    Event* event;
    int sign;
  };
  std::array<Waypoint, 2 * Curve::most + 1> list;
  int count = 0;

  void add(Event* event, int sign) { list[count++] = {event, sign}; }
};

struct Events {
  std::array<Event*, Curve::most> list;
  int count = 0;
};

/// Sign of the discriminant; the coefficients or `discriminant` are made sharper where that takes integers.
int discriminant_of(Curve& curve, Wide& d) {
  const auto& c = curve.rough();
  d = c[1] * c[1] - (c[0] * c[2]).scaled(2);
  if (d.sign() == unknown_sign || (c[1].sign() == unknown_sign && d.sign() > 0)) {
    curve.sharpen();
    d = Wide(Dyadic(discriminant(curve.exact()), 0));
  }
  return d.sign();
}

/// All real roots of degree 1 and 2, in order.
Events roots_by_formula(Curve& curve) {
  Events roots;
  const int degree = curve.degree();
  if (degree < 1) return roots;
  if (degree == 1) {
    roots.list[roots.count++] = &curve.add_root(0, -curve.rough()[0] / curve.rough()[1]);
    return roots;
  }
  Wide d;
  const int sign = discriminant_of(curve, d);
  const auto& c = curve.rough();
  if (sign < 0) return roots;
  if (sign == 0) {
    roots.list[roots.count++] = &curve.add_root(0, -c[1] / c[2].scaled(1));
    return roots;
  }
  // -b and the root of D with one sign: nothing cancels. That is the lesser root if b / a > 0.
  const Wide root = sqrt(d);
  const bool positive = c[1].side() >= 0;
  const Wide sum = half_of(positive ? -c[1] - root : root - c[1]);
  const Wide one = sum / c[2], other = c[0] / sum;
  const bool lesser = positive == (curve.lead() > 0);
  roots.list[0] = &curve.add_root(-1, lesser ? one : other);
  roots.list[1] = &curve.add_root(1, lesser ? other : one);
  roots.count = 2;
  return roots;
}

Stays clipped(std::initializer_list<Stay> stays, const Asked& asked) {
  Stays kept;
  for (Stay s : stays) {
    if (s.first != &asked.begin && compare(*s.first, asked.begin) < 0) s.first = &asked.begin;
    if (s.last != &asked.end && compare(*s.last, asked.end) > 0) s.last = &asked.end;
    if (compare(*s.first, *s.last) <= 0) kept.add(s.first, s.last);
  }
  return kept;
}

Stays inside_by_formula(Curve& curve, const Asked& asked) {
  const Events roots = roots_by_formula(curve);
  Event *const begin = &asked.begin, *const end = &asked.end;
  const int lead = curve.lead();
  if (roots.count == 0) return lead <= 0 ? clipped({{begin, end}}, asked) : Stays{};
  Event *const one = roots.list[0], *const other = roots.list[roots.count - 1];
  if (curve.degree() == 1) return clipped({lead > 0 ? Stay{begin, one} : Stay{one, end}}, asked);
  if (lead > 0) return clipped({{one, other}}, asked);
  if (one == other) return clipped({{begin, end}}, asked);
  return clipped({{begin, one}, {other, end}}, asked);
}

/// Strictly between two numbers: their middle, or the middle of the exponents where these are far apart.
/// Requires: 0 <= low < high, both exact.
Wide between(const Wide& low, const Wide& high, int round) {
  if (low.sign() == 0) return high.scaled(-(1 << std::min(round, 12)));
  const int least = low.magnitude(), most = high.magnitude();
  if (most - least >= 2) return Wide(1.0).scaled(least + (most - least + 1) / 2);
  return half_of(low + high).middle();
}

bool less(const Wide& a, const Wide& b) {
  return (b - a).sign() == 1;
}

/// A bracket of one simple root that closes in on it as far as 128 bits can tell its signs.
class Narrowing {
 public:
  Narrowing(Curve& curve, const Wide& low, const Wide& high, int sign_low)
      : curve_(curve), low_(low), high_(high), sign_low_(sign_low) {}

  Event& event() {
    close_in();
    return curve_.add_root(low_, high_, sign_low_);
  }

 private:
  /// Newton's steps, kept inside the bracket; where one leaves it or does not help, the middle.
  void close_in() {
    int round = 0;
    while (low_.sign() == 0 || high_.magnitude() - low_.magnitude() >= 2) {
      const Wide x = between(low_, high_, round++);
      if (!look_at(x)) return pinch(x, x.magnitude() - most_digits);
    }
    Wide x = between(low_, high_, round);
    for (int step = 0; step < 200; ++step) {
      const Wide value = curve_.value_at(x), steep = curve_.slope().value_at(x);
      if (!narrow(x, value)) return pinch(x, x.magnitude() - most_digits);
      const int slope_sign = steep.sign();
      Wide next = between(low_, high_, round);
      if (slope_sign != 0 && slope_sign != unknown_sign && step % 8 != 7) {
        const Wide move = (value / steep).middle();
        if (move.side() == 0 || move.magnitude() < x.magnitude() - most_digits)
          return pinch(x, x.magnitude() - most_digits);
        const Wide newton = (x - move).middle();
        if (less(low_, newton) && less(newton, high_)) next = newton;
      }
      if (!less(low_, next) || !less(next, high_)) return;
      x = next;
    }
  }

  /// Looks on both sides of x, at ever greater distance until the signs are certain.
  void pinch(const Wide& x, int magnitude) {
    for (int attempt = 0; attempt < 10; ++attempt, magnitude += 8) {
      const Wide away = Wide(1.0).scaled(magnitude);
      const Wide left = (x - away).middle(), right = (x + away).middle();
      if (less(low_, left)) look_at(left);
      if (less(right, high_)) look_at(right);
      if (less(high_ - low_, away.scaled(2))) return;
    }
  }

  bool look_at(const Wide& x) { return narrow(x, curve_.value_at(x)); }
  /// False if the sign is not certain, or 0.
  bool narrow(const Wide& x, const Wide& value) {
    const int sign = value.sign();
    if (sign == 0 || sign == unknown_sign) return false;
    (sign == sign_low_ ? low_ : high_) = x;
    return true;
  }

  static constexpr int most_digits = 112;

  Curve& curve_;
  Wide low_, high_;
  int sign_low_;
};

/// Exact bounds of an event that can be narrowed as far as one likes.
class Bounds {
 public:
  explicit Bounds(Event& event) : event_(event) {
    low = event.known ? *event.known : event.at.low().dyadic();
    high = event.known ? *event.known : event.at.high().dyadic();
    if (low.sign() < 0) low = Dyadic();  // no moment is before now
  }

  void narrow() {
    if (low == high) return;
    if (event_.curve->degree() > 2) {
      event_.root().narrow(round_++);
      low = event_.root().low(), high = event_.root().high();
      return;
    }
    const Dyadic middle = half_of(low + high);
    const int side = compare(event_, middle);
    if (side >= 0) low = middle;
    if (side <= 0) high = middle;
  }

  Dyadic low, high;

 private:
  Event& event_;
  int round_ = 0;
};

/// The only root between two neighbours at which the signs differ.
Event& root_between(Curve& curve, Event& before, Event& after, int sign_before) {
  const Wide low = before.at.high(), high = after.at.low();
  if (less(low, high) && curve.value_at(low).sign() == sign_before &&
      curve.value_at(high).sign() == -sign_before)
    return Narrowing(curve, low, high, sign_before).event();
  // So near to a neighbour that 128 bits do not tell them apart.
  Bounds left(before), right(after);
  while (!(left.high < right.low)) left.narrow(), right.narrow();
  while (curve.sign_at(left.high) != sign_before) left.narrow();
  while (curve.sign_at(right.low) != -sign_before) right.narrow();
  Root root(curve.exact(), left.high, right.low, sign_before);
  for (int round = 0; round < 200 && !root.exact(); ++round) {
    if (root.low().sign() != 0 && (root.high() - root.low()).magnitude() < root.low().magnitude() - 120)
      break;
    root.narrow(round);
  }
  return curve.add_root(std::move(root), sign_before);
}

Waypoints waypoints_of(Curve& curve, const Asked& asked);

/// Where a curve of any degree is 0, strictly within the moments asked about.
Events zeros_within(Curve& curve, const Asked& asked) {
  Events zeros;
  if (curve.degree() <= 2) {
    const Events all = roots_by_formula(curve);
    for (int i = 0; i < all.count; ++i)
      if (compare(*all.list[i], asked.begin) > 0 && compare(*all.list[i], asked.end) < 0)
        zeros.list[zeros.count++] = all.list[i];
    return zeros;
  }
  const Waypoints way = waypoints_of(curve, asked);
  for (int i = 1; i + 1 < way.count; ++i)
    if (way.list[i].sign == 0) zeros.list[zeros.count++] = way.list[i].event;
  return zeros;
}

/// The ends, the zeros of the slope, and between them the roots.
Waypoints waypoints_of(Curve& curve, const Asked& asked) {
  const Events turns = zeros_within(curve.slope(), asked);
  Waypoints way;
  way.add(&asked.begin, curve.sign_at(asked.begin));
  for (int i = 0; i <= turns.count; ++i) {
    Event& next = i < turns.count ? *turns.list[i] : asked.end;
    const auto last = way.list[way.count - 1];
    const int sign = curve.sign_at(next);
    if (last.sign * sign < 0) way.add(&root_between(curve, *last.event, next, last.sign), 0);
    way.add(&next, sign);
  }
  return way;
}

/// Never 0 on the whole of it, told from Bernstein's coefficients: their sign, or 0 where they do not tell.
int constant_sign(Curve& curve, const Asked& asked) {
  const int n = curve.degree();
  const Wide width = asked.end.at - asked.begin.at;
  std::array<Wide, Curve::most + 1> d = curve.rough();
  for (int k = 0; k < n; ++k)
    for (int i = n - 1; i >= k; --i) d[i] = d[i] + asked.begin.at * d[i + 1];
  Wide scale = width;
  for (int k = 1; k <= n; ++k, scale = scale * width) d[k] = d[k] * scale;
  int all = 0;
  for (int i = 0; i <= n; ++i) {
    Wide b;
    for (int k = 0; k <= i; ++k) b = b + d[k] * Wide(bernstein_weight(n, i, k));
    const int sign = b.sign();
    if (sign == 0 || sign == unknown_sign || (all != 0 && sign != all)) return 0;
    all = sign;
  }
  return all;
}

}  // namespace

Stays inside(Curve& curve, const Asked& asked) {
  if (curve.degree() <= 2) return inside_by_formula(curve, asked);
  Stays stays;
  const int constant = constant_sign(curve, asked);
  if (constant < 0) stays.add(&asked.begin, &asked.end);
  if (constant != 0) return stays;
  const Waypoints way = waypoints_of(curve, asked);
  // Between two neighbours there is no root, so the curve is at most 0 there if it is at both.
  for (int i = 0; i < way.count; ++i) {
    if (way.list[i].sign > 0) continue;
    int last = i;
    while (last + 1 < way.count && way.list[last + 1].sign <= 0) ++last;
    stays.add(way.list[i].event, way.list[last].event);
    i = last;
  }
  return stays;
}

Stays common(const Stays& a, const Stays& b) {
  Stays both;
  for (int i = 0, j = 0; i < a.count && j < b.count;) {
    const Stay &s = a.list[i], &other = b.list[j];
    Event* const first = compare(*s.first, *other.first) >= 0 ? s.first : other.first;
    const bool s_ends = compare(*s.last, *other.last) <= 0;
    Event* const last = s_ends ? s.last : other.last;
    if (compare(*first, *last) <= 0) both.add(first, last);
    ++(s_ends ? i : j);
  }
  return both;
}

}  // namespace foresee
