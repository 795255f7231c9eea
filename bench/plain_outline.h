// First contact of two outlines by a textbook in plain double: every corner of each against every edge of the
// other, one division each. At the start, if their boxes intersect, it tests whether a corner is inside or
// edges cross.
#pragma once

#include <algorithm>
#include <span>

#include "shape/outline/outline.h"

namespace foresee::bench {

/// Rings at rest, and rings that are at x, y at first and move; a point is a ring of one.
struct PlainOutlines {
  std::span<const Corner> a, b;
  double x, y, vx, vy, h;
};

/// The first time at which a corner of `corners`, moved by (x, y) + t (vx, vy), meets an edge of `ring`, if
/// that is before `first`.
inline double first_meeting(std::span<const Corner> ring, std::span<const Corner> corners, double x, double y,
                            double vx, double vy, double first) {
  for (std::size_t i = ring.size() - 1, j = 0; j < ring.size(); i = j++) {
    const double ex = ring[j].x - ring[i].x, ey = ring[j].y - ring[i].y, turn = vx * ey - vy * ex;
    if (turn == 0) continue;
    for (const Corner& c : corners) {
      const double gx = ring[i].x - (c.x + x), gy = ring[i].y - (c.y + y);
      const double t = (gx * ey - gy * ex) / turn, along = (gx * vy - gy * vx) / turn;
      if (t >= 0 && t < first && along >= 0 && along <= 1) first = t;
    }
  }
  return first;
}

/// Whether a place is within a ring.
inline bool is_within(std::span<const Corner> ring, double x, double y) {
  bool within = false;
  for (std::size_t i = ring.size() - 1, j = 0; j < ring.size(); i = j++)
    if ((ring[i].y > y) != (ring[j].y > y) &&
        x < ring[i].x + (y - ring[i].y) * (ring[j].x - ring[i].x) / (ring[j].y - ring[i].y))
      within = !within;
  return within;
}

/// Whether edges of `b`, moved by (x, y), cross edges of `a`.
inline bool any_crossing(std::span<const Corner> a, std::span<const Corner> b, double x, double y) {
  const auto side = [](const Corner& p, const Corner& q, const Corner& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  for (std::size_t i = b.size() - 1, j = 0; j < b.size(); i = j++) {
    const Corner from{b[i].x + x, b[i].y + y}, to{b[j].x + x, b[j].y + y};
    for (std::size_t k = a.size() - 1, l = 0; l < a.size(); k = l++)
      if (side(a[k], a[l], from) * side(a[k], a[l], to) < 0 &&
          side(from, to, a[k]) * side(from, to, a[l]) < 0)
        return true;
  }
  return false;
}

inline bool boxes_meet(std::span<const Corner> a, std::span<const Corner> b, double x, double y) {
  const auto apart = [&](auto&& less, auto&& coordinate, double shift) {
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), less);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), less);
    return coordinate(*b_low) + shift > coordinate(*a_high) ||
           coordinate(*b_high) + shift < coordinate(*a_low);
  };
  const auto x_of = [](const Corner& c) { return c.x; };
  const auto y_of = [](const Corner& c) { return c.y; };
  return !apart([](const Corner& p, const Corner& q) { return p.x < q.x; }, x_of, x) &&
         !apart([](const Corner& p, const Corner& q) { return p.y < q.y; }, y_of, y);
}

/// Whether they touch at the start.
inline bool touch_at_once(const PlainOutlines& p) {
  if (p.b.size() == 1) return is_within(p.a, p.b[0].x + p.x, p.b[0].y + p.y);
  return boxes_meet(p.a, p.b, p.x, p.y) &&
         (is_within(p.a, p.b[0].x + p.x, p.b[0].y + p.y) || is_within(p.b, p.a[0].x - p.x, p.a[0].y - p.y) ||
          any_crossing(p.a, p.b, p.x, p.y));
}

/// -1: never. `all`: every corner is tested even if they touch at the start, as the end of a contact
/// requires.
inline double first_touch(const PlainOutlines& p, bool all) {
  const bool at_once = touch_at_once(p);
  if (at_once && !all) return 0;
  const double never = 2 * p.h;
  double first = first_meeting(p.a, p.b, p.x, p.y, p.vx, p.vy, never);
  if (p.b.size() > 1) first = first_meeting(p.b, p.a, -p.x, -p.y, -p.vx, -p.vy, first);
  return at_once ? 0 : first <= p.h ? first : -1;
}

}  // namespace foresee::bench
