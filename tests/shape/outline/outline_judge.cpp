#include "shape/outline/outline_judge.h"

#include <algorithm>

namespace foresee {

namespace {

struct RationalEdge {
  RationalEdge(const RationalPoint& a, const RationalPoint& b)
      : a(a),
        b(b),
        low{std::min(a.x, b.x), std::min(a.y, b.y)},
        high{std::max(a.x, b.x), std::max(a.y, b.y)} {}

  RationalPoint a, b, low, high;
};

bool near(const RationalEdge& e, const RationalEdge& f) {
  return e.low.x <= f.high.x && f.low.x <= e.high.x && e.low.y <= f.high.y && f.low.y <= e.high.y;
}

bool same(const RationalPoint& a, const RationalPoint& b) {
  return a.x == b.x && a.y == b.y;
}

bool on(const RationalPoint& point, const RationalEdge& edge) {
  return edge.low.x <= point.x && point.x <= edge.high.x && edge.low.y <= point.y && point.y <= edge.high.y &&
         side_of(edge.a, edge.b, point) == 0;
}

std::vector<RationalEdge> edges_of(const RationalRing& ring) {
  std::vector<RationalEdge> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  return edges;
}

bool cross(const RationalEdge& e, const RationalEdge& f) {
  return near(e, f) && side_of(e.a, e.b, f.a) * side_of(e.a, e.b, f.b) < 0 &&
         side_of(f.a, f.b, e.a) * side_of(f.a, f.b, e.b) < 0;
}

/// The ends of each edge that lie on the other, each point once.
std::vector<RationalPoint> touches(const RationalEdge& e, const RationalEdge& f) {
  std::vector<RationalPoint> points;
  if (!near(e, f)) return points;
  const auto add = [&](const RationalPoint& point) {
    if (std::none_of(points.begin(), points.end(), [&](const auto& other) { return same(point, other); }))
      points.push_back(point);
  };
  for (const RationalPoint& end : {e.a, e.b})
    if (on(end, f)) add(end);
  for (const RationalPoint& end : {f.a, f.b})
    if (on(end, e)) add(end);
  return points;
}

bool is_simple(const RationalRing& ring) {
  const std::vector<RationalEdge> edges = edges_of(ring);
  const std::size_t n = edges.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      if (cross(edges[i], edges[j]) || touches(edges[i], edges[j]).size() > (neighbours ? 1 : 0))
        return false;
    }
  return true;
}

/// Points of a ring strictly between its corners and its touches with another.
std::vector<RationalPoint> points_between(const RationalRing& ring, const RationalRing& other) {
  std::vector<RationalPoint> points;
  for (const RationalEdge& e : edges_of(ring)) {
    std::vector<RationalPoint> stops{e.a, e.b};
    for (const RationalEdge& f : edges_of(other))
      for (const RationalPoint& touch : touches(e, f)) stops.push_back(touch);
    std::sort(stops.begin(), stops.end(),
              [](const auto& p, const auto& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    for (std::size_t i = 0; i + 1 < stops.size(); ++i)
      if (!same(stops[i], stops[i + 1]))
        points.push_back({(stops[i].x + stops[i + 1].x) / 2, (stops[i].y + stops[i + 1].y) / 2});
  }
  return points;
}

enum class Relation { apart, within, crossing };

/// The relation of a simple ring to another.
Relation relation_of(const RationalRing& ring, const RationalRing& other) {
  for (const RationalEdge& e : edges_of(ring))
    for (const RationalEdge& f : edges_of(other))
      if (cross(e, f) || touches(e, f).size() > 1) return Relation::crossing;
  int inside = 0, outside = 0;
  for (const RationalPoint& point : points_between(ring, other))
    ++(where(point, other) == Where::inside ? inside : outside);
  return inside == 0 ? Relation::apart : outside == 0 ? Relation::within : Relation::crossing;
}

/// Of the rings a to b of an outline, the first is around the others, which are apart.
bool is_sound_part(const std::vector<RationalRing>& rings, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i)
    for (std::size_t j = begin; j < end; ++j) {
      if (i == j || i == begin) continue;
      if (relation_of(rings[i], rings[j]) != (j == begin ? Relation::within : Relation::apart)) return false;
    }
  return true;
}

}  // namespace

RationalPoint exact(const Corner& corner) {
  return {Rational(corner.x), Rational(corner.y)};
}

RationalRing exact(std::span<const Corner> ring) {
  RationalRing points;
  for (const Corner& corner : ring) points.push_back(exact(corner));
  return points;
}

int side_of(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
}

Rational twice_area(const RationalRing& ring) {
  Rational twice = 0;
  for (const RationalEdge& edge : edges_of(ring)) twice += edge.a.x * edge.b.y - edge.a.y * edge.b.x;
  return twice;
}

Rational twice_area(const Outline& outline) {
  Rational twice = 0;
  for (std::size_t part = 0; part < outline.parts(); ++part)
    for (std::size_t r = outline.part_start(part); r < outline.part_start(part + 1); ++r) {
      const Rational area = abs(twice_area(exact(outline.ring(r))));
      twice += r == outline.part_start(part) ? area : Rational(-area);
    }
  return twice;
}

Where where(const RationalPoint& point, const RationalRing& ring) {
  bool inside = false;
  for (const RationalEdge& edge : edges_of(ring)) {
    if (on(point, edge)) return Where::boundary;
    const bool upwards = edge.a.y < edge.b.y;
    const RationalPoint &low = upwards ? edge.a : edge.b, &high = upwards ? edge.b : edge.a;
    if (low.y <= point.y && point.y < high.y && side_of(low, high, point) > 0) inside = !inside;
  }
  return inside ? Where::inside : Where::outside;
}

Where where(const RationalPoint& point, const Outline& outline) {
  int around = 0;
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const Where here = where(point, exact(outline.ring(r)));
    if (here == Where::boundary) return Where::boundary;
    around += here == Where::inside;
  }
  return around % 2 == 1 ? Where::inside : Where::outside;
}

bool is_sound(const Outline& outline) {
  std::vector<RationalRing> rings;
  for (std::size_t r = 0; r < outline.rings(); ++r) rings.push_back(exact(outline.ring(r)));
  if (!std::all_of(rings.begin(), rings.end(), is_simple)) return false;
  for (std::size_t i = 0; i < rings.size(); ++i)
    for (std::size_t j = 0; j < rings.size(); ++j)
      if (i != j && relation_of(rings[i], rings[j]) == Relation::crossing) return false;
  for (std::size_t part = 0; part < outline.parts(); ++part) {
    const std::size_t begin = outline.part_start(part), end = outline.part_start(part + 1);
    if (!is_sound_part(rings, begin, end)) return false;
    // Another part lies apart, or within a hole.
    for (std::size_t other = 0; other < outline.parts(); ++other) {
      const RationalRing& ring = rings[outline.part_start(other)];
      if (other == part || relation_of(ring, rings[begin]) == Relation::apart) continue;
      if (std::none_of(rings.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
                       rings.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](const RationalRing& hole) { return relation_of(ring, hole) == Relation::within; }))
        return false;
    }
  }
  return true;
}

}  // namespace foresee
