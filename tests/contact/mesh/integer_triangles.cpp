#include "contact/mesh/integer_triangles.h"

#include <algorithm>

namespace foresee::oracle {
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
  const Arrow gap = corner - facet.corners[0];
  const Whole u = dot(gap, facet.to_u), w = dot(gap, facet.to_w), high = dot(gap, facet.normal);
  return facet.squared != 0 && u >= 0 && w >= 0 && u + w <= facet.squared &&
         high * high <= squared * facet.squared;
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
  const Whole length = dot(turn, turn), high = dot(gap, turn);
  const Whole along_e = dot(gap, cross(f, turn)), along_f = dot(gap, cross(e, turn));
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
Facet::Facet(const std::array<Arrow, 3>& corners)
    : corners(corners),
      edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]},
      normal(cross(edges[2], edges[0])),
      to_u(cross(normal, edges[2])),
      to_w(cross(normal, edges[0])),
      squared(dot(normal, normal)) {}

unsigned side_of(const Facet& plane, const Facet& other, const Whole& squared) {
  const Whole level = dot(plane.normal, plane.corners[0]), reach = squared * plane.squared;
  unsigned side = 3;
  for (const Arrow& corner : other.corners) {
    const Whole high = dot(plane.normal, corner) - level;
    if (high == 0 || (reach > 0 && high * high <= reach)) return 0;
    side &= high > 0 ? 1 : 2;
  }
  return side;
}

std::optional<Span> corner_meets(const Arrow& corner, const Arrow& velocity, const Facet& facet,
                                 Span queried) {
  if (facet.squared == 0) return {};
  const Arrow gap = corner - facet.corners[0];
  if (!cut(queried, {dot(gap, facet.normal), dot(velocity, facet.normal)}, 0, 0)) return {};
  const Steady u{dot(gap, facet.to_u), dot(velocity, facet.to_u)};
  if (!cut(queried, u, 0, facet.squared)) return {};
  const Steady w{dot(gap, facet.to_w), dot(velocity, facet.to_w)};
  if (!cut(queried, w, 0, facet.squared)) return {};
  if (!cut(queried, {u.value + w.value, u.slope + w.slope}, 0, facet.squared)) return {};
  return queried;
}

std::optional<Span> edge_meets(const Arrow& p, const Arrow& e, const Arrow& q, const Arrow& f,
                               const Arrow& velocity, Span queried) {
  const Arrow gap = q - p, turn = cross(e, f);
  const Whole squared = dot(turn, turn);
  if (squared != 0) {
    if (!cut(queried, {dot(gap, turn), dot(velocity, turn)}, 0, 0)) return {};
    const Arrow to_e = cross(f, turn), to_f = cross(e, turn);
    if (!cut(queried, {dot(gap, to_e), dot(velocity, to_e)}, 0, squared)) return {};
    if (!cut(queried, {dot(gap, to_f), dot(velocity, to_f)}, 0, squared)) return {};
    return queried;
  }
  // Parallel: in one line, and overlapping in it. An edge without length is a point.
  const Arrow& line = is_zero(e) ? f : e;
  if (is_zero(line)) return cut_to_zero(queried, gap, velocity) ? std::optional(queried) : std::nullopt;
  if (!cut_to_zero(queried, cross(gap, line), cross(velocity, line))) return {};
  const Whole zero, reach_e = dot(e, line), reach_f = dot(f, line);
  const Whole low = std::min(zero, reach_e) - std::max(zero, reach_f);
  const Whole high = std::max(zero, reach_e) - std::min(zero, reach_f);
  if (cut(queried, {dot(gap, line), dot(velocity, line)}, low, high)) return queried;
  return {};
}

std::optional<Span> features_meet(const Facet& a, const Facet& b, const Arrow& velocity,
                                  const Span& queried) {
  const Arrow back = Whole(-1) * velocity;
  std::optional<Span> all;
  for (std::size_t i = 0; i < 3; ++i) {
    widen(all, corner_meets(a.corners[i], back, b, queried));
    widen(all, corner_meets(b.corners[i], velocity, a, queried));
    for (std::size_t j = 0; j < 3; ++j)
      widen(all, edge_meets(a.corners[i], a.edges[i], b.corners[j], b.edges[j], velocity, queried));
  }
  return all;
}

bool touch(const Facet& a, const Facet& b) {
  // An edge meets a triangle if its first corner would on the way to the second.
  const Span edge{{0, 1}, {1, 1}};
  for (std::size_t i = 0; i < 3; ++i)
    if (corner_meets(a.corners[i], a.edges[i], b, edge) || corner_meets(b.corners[i], b.edges[i], a, edge))
      return true;
  if (a.squared != 0 && b.squared != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (edge_meets(a.corners[i], a.edges[i], b.corners[j], b.edges[j], {0, 0, 0}, once)) return true;
  return false;
}

bool are_near(const Facet& a, const Facet& b, const Whole& squared) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Arrow &p = a.corners[i], &e = a.edges[i];
    if (is_near(p, b, squared) || is_near(b.corners[i], a, squared)) return true;
    for (std::size_t j = 0; j < 3; ++j) {
      const Arrow &q = b.corners[j], &f = b.edges[j];
      if (is_near(p, q, f, squared) || is_near(q, p, e, squared) || are_near(p, e, q, f, squared))
        return true;
    }
  }
  return false;
}

std::optional<int> crossings(const Arrow& corner, const Arrow& ray, const Facet& facet) {
  const Arrow gap = corner - facet.corners[0];
  const Whole high = dot(gap, facet.normal), slope = dot(ray, facet.normal);
  if (slope == 0) return high == 0 ? std::nullopt : std::optional(0);
  if (high == 0 || (high > 0) == (slope > 0)) return 0;
  // Where the ray meets the plane, times the slope: gap slope - ray high.
  const Arrow there = slope * gap - high * ray;
  const int sign = slope.sign();
  const Whole u = sign * dot(there, facet.to_u), w = sign * dot(there, facet.to_w);
  const Whole rest = sign * slope * facet.squared - u - w;
  if (u < 0 || w < 0 || rest < 0) return 0;
  if (u == 0 || w == 0 || rest == 0) return std::nullopt;
  return 1;
}

}  // namespace foresee::oracle
