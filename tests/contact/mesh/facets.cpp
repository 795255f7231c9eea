#include "contact/mesh/facets.h"

#include <algorithm>

namespace foresee::contact::oracle {
namespace {

/// A number that changes steadily: value + s slope.
struct Steady {
  Whole value, slope;
};

/// When value + s slope is 0. Requires: a slope.
Fraction zero_of(const Whole& value, const Whole& slope) {
  return slope > 0 ? Fraction{-value, slope} : Fraction{value, -slope};
}

/// Cuts a span to when low <= number <= high; false if nothing is left.
bool cut(Span& span, const Steady& number, const Whole& low, const Whole& high) {
  if (number.slope == 0) return low <= number.value && number.value <= high;
  Fraction first = zero_of(number.value - low, number.slope);
  Fraction last = zero_of(number.value - high, number.slope);
  if (number.slope < 0) std::swap(first, last);
  if (span.begin < first) span.begin = std::move(first);
  if (last < span.end) span.end = std::move(last);
  return !(span.end < span.begin);
}

bool cut_to_zero(Span& span, const Arrow& value, const Arrow& slope) {
  return cut(span, {value.x, slope.x}, 0, 0) && cut(span, {value.y, slope.y}, 0, 0) &&
         cut(span, {value.z, slope.z}, 0, 0);
}

bool is_zero(const Arrow& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

Arrow edge_of(const Facet& facet, std::size_t i) {
  return facet[(i + 1) % 3] - facet[i];
}

/// A place as seen from a triangle, gap from its first corner: gap = u e1 + w e2 + h normal, all but h times
/// the square of the normal.
struct Seen {
  Arrow e1, e2, normal;
  Whole squared;

  explicit Seen(const Facet& facet)
      : e1(facet[1] - facet[0]),
        e2(facet[2] - facet[0]),
        normal(cross(e1, e2)),
        squared(dot(normal, normal)) {}
  Whole u(const Arrow& gap) const { return dot(cross(gap, e2), normal); }
  Whole w(const Arrow& gap) const { return dot(cross(e1, gap), normal); }
};

void widen(std::optional<Span>& all, const std::optional<Span>& span) {
  if (!span) return;
  if (!all) {
    all = span;
    return;
  }
  if (span->begin < all->begin) all->begin = span->begin;
  if (all->end < span->end) all->end = span->end;
}

const Span once{{0, 1}, {0, 1}};

bool is_near(const Arrow& corner, const Facet& facet, const Whole& squared) {
  const Seen seen(facet);
  const Arrow gap = corner - facet[0];
  const Whole u = seen.u(gap), w = seen.w(gap), high = dot(gap, seen.normal);
  return seen.squared != 0 && u >= 0 && w >= 0 && u + w <= seen.squared &&
         high * high <= squared * seen.squared;
}

bool is_near(const Arrow& corner, const Arrow& q, const Arrow& f, const Whole& squared) {
  Arrow gap = corner - q;
  const Whole along = dot(gap, f), length = dot(f, f);
  if (along > 0 && along < length) {
    const Arrow beside = cross(gap, f);
    return dot(beside, beside) <= squared * length;
  }
  if (along > 0) gap = gap - f;
  return dot(gap, gap) <= squared;
}

/// Edge on edge, where both are nearest each other between their ends.
bool are_near(const Arrow& p, const Arrow& e, const Arrow& q, const Arrow& f, const Whole& squared) {
  const Arrow gap = q - p, turn = cross(e, f);
  const Whole length = dot(turn, turn);
  const Whole along_e = dot(cross(gap, f), turn), along_f = dot(cross(gap, e), turn), high = dot(gap, turn);
  return length != 0 && along_e >= 0 && along_e <= length && along_f >= 0 && along_f <= length &&
         high * high <= squared * length;
}

}  // namespace

Arrow operator+(const Arrow& a, const Arrow& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Arrow operator-(const Arrow& a, const Arrow& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Arrow operator*(const Whole& factor, const Arrow& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
Arrow cross(const Arrow& a, const Arrow& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Whole dot(const Arrow& a, const Arrow& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Arrow normal_of(const Facet& facet) {
  return cross(facet[1] - facet[0], facet[2] - facet[0]);
}

unsigned side_of(const Facet& plane, const Facet& other, const Whole& squared) {
  const Arrow normal = normal_of(plane);
  const Whole level = dot(normal, plane[0]), reach = squared == 0 ? squared : squared * dot(normal, normal);
  unsigned side = 3;
  for (const Arrow& corner : other) {
    const Whole high = dot(normal, corner) - level;
    if (high == 0 || (reach > 0 && high * high <= reach)) return 0;
    side &= high > 0 ? 1 : 2;
  }
  return side;
}

std::optional<Span> corner_meets(const Arrow& corner, const Arrow& velocity, const Facet& facet, Span asked) {
  const Seen seen(facet);
  if (seen.squared == 0) return {};
  const Arrow gap = corner - facet[0];
  if (!cut(asked, {dot(gap, seen.normal), dot(velocity, seen.normal)}, 0, 0)) return {};
  const Steady u{seen.u(gap), seen.u(velocity)}, w{seen.w(gap), seen.w(velocity)};
  if (!cut(asked, u, 0, seen.squared) || !cut(asked, w, 0, seen.squared)) return {};
  if (!cut(asked, {u.value + w.value, u.slope + w.slope}, 0, seen.squared)) return {};
  return asked;
}

std::optional<Span> edge_meets(const Arrow& p, const Arrow& e, const Arrow& q, const Arrow& f,
                               const Arrow& velocity, Span asked) {
  const Arrow gap = q - p, turn = cross(e, f);
  const Whole squared = dot(turn, turn);
  if (squared != 0) {
    if (!cut(asked, {dot(gap, turn), dot(velocity, turn)}, 0, 0)) return {};
    const Steady along_e{dot(cross(gap, f), turn), dot(cross(velocity, f), turn)};
    const Steady along_f{dot(cross(gap, e), turn), dot(cross(velocity, e), turn)};
    if (cut(asked, along_e, 0, squared) && cut(asked, along_f, 0, squared)) return asked;
    return {};
  }
  // Parallel: in one line, and overlapping in it. An edge without length is a point.
  const Arrow& line = is_zero(e) ? f : e;
  if (is_zero(line)) return cut_to_zero(asked, gap, velocity) ? std::optional(asked) : std::nullopt;
  if (!cut_to_zero(asked, cross(gap, line), cross(velocity, line))) return {};
  const Whole zero, reach_e = dot(e, line), reach_f = dot(f, line);
  const Whole low = std::min(zero, reach_e) - std::max(zero, reach_f);
  const Whole high = std::max(zero, reach_e) - std::min(zero, reach_f);
  if (cut(asked, {dot(gap, line), dot(velocity, line)}, low, high)) return asked;
  return {};
}

std::optional<Span> features_meet(const Facet& a, const Facet& b, const Arrow& velocity, const Span& asked) {
  const Arrow back = Whole(-1) * velocity;
  std::optional<Span> all;
  for (const Arrow& corner : a) widen(all, corner_meets(corner, back, b, asked));
  for (const Arrow& corner : b) widen(all, corner_meets(corner, velocity, a, asked));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      widen(all, edge_meets(a[i], edge_of(a, i), b[j], edge_of(b, j), velocity, asked));
  return all;
}

bool touch(const Facet& a, const Facet& b) {
  // An edge meets a triangle if its first corner would on the way to the second.
  const Span edge{{0, 1}, {1, 1}};
  for (std::size_t i = 0; i < 3; ++i)
    if (corner_meets(a[i], edge_of(a, i), b, edge) || corner_meets(b[i], edge_of(b, i), a, edge)) return true;
  if (!is_zero(normal_of(a)) && !is_zero(normal_of(b))) return false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (edge_meets(a[i], edge_of(a, i), b[j], edge_of(b, j), {0, 0, 0}, once)) return true;
  return false;
}

bool are_near(const Facet& a, const Facet& b, const Whole& squared) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_near(a[i], b, squared) || is_near(b[i], a, squared)) return true;
    for (std::size_t j = 0; j < 3; ++j) {
      const Arrow e = edge_of(a, i), f = edge_of(b, j);
      if (is_near(a[i], b[j], f, squared) || is_near(b[j], a[i], e, squared)) return true;
      if (are_near(a[i], e, b[j], f, squared)) return true;
    }
  }
  return false;
}

std::optional<int> crossings(const Arrow& corner, const Arrow& ray, const Facet& facet) {
  const Seen seen(facet);
  const Arrow gap = corner - facet[0];
  const Whole high = dot(gap, seen.normal), slope = dot(ray, seen.normal);
  if (slope == 0) return high == 0 ? std::nullopt : std::optional(0);
  if (high == 0 || (high > 0) == (slope > 0)) return 0;
  // Where the ray meets the plane, times the slope: gap slope - ray high.
  const Arrow there = slope * gap - high * ray;
  const int sign = slope.sign();
  const Whole u = sign * seen.u(there), w = sign * seen.w(there);
  const Whole rest = sign * slope * seen.squared - u - w;
  if (u < 0 || w < 0 || rest < 0) return 0;
  if (u == 0 || w == 0 || rest == 0) return std::nullopt;
  return 1;
}

}  // namespace foresee::contact::oracle
