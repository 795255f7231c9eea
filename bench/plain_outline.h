// When do two outlines first touch? As a textbook has it, in plain double: every corner of each against every
// edge of the other, one division each; and at the beginning whether a corner is within.
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

/// The first moment at which a corner of `corners`, moved by (x, y) + t (vx, vy), meets an edge of `ring`, if
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

/// -1: never. `all`: also where they touch at the beginning, every corner is asked, as whoever wants to know
/// the end must.
inline double first_touch(const PlainOutlines& p, bool all) {
  const bool at_once = is_within(p.a, p.b[0].x + p.x, p.b[0].y + p.y) ||
                       (p.b.size() > 1 && is_within(p.b, p.a[0].x - p.x, p.a[0].y - p.y));
  if (at_once && !all) return 0;
  const double never = 2 * p.h;
  double first = first_meeting(p.a, p.b, p.x, p.y, p.vx, p.vy, never);
  if (p.b.size() > 1) first = first_meeting(p.b, p.a, -p.x, -p.y, -p.vx, -p.vy, first);
  return at_once ? 0 : first <= p.h ? first : -1;
}

}  // namespace foresee::bench
