#include "contact/mesh/space_constraint.h"

#include "contact/minkowski/relative_motion.h"
#include "numbers/dyadic.h"

namespace foresee {
namespace {

constexpr SpaceCorner origin{0, 0, 0}, units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Component a[i] b[j] - a[j] b[i] of a cross product, with all digits of both products.
Bounded close_minor(const Components<DoubleDouble>& a, const Components<DoubleDouble>& b, std::size_t i,
                    std::size_t j) {
  const DoubleDouble left = a[i] * b[j], right = a[j] * b[i], minor = left - right;
  const auto is_there = [&](std::size_t m, std::size_t n) { return a[m].high != 0 && b[n].high != 0; };
  if (!is_there(i, j) && !is_there(j, i)) return {};
  const double lost = 0x1p-98 * (std::abs(left.high) + std::abs(right.high)) + 0x1p-1060;
  return {minor.high, std::abs(minor.low) + lost};
}

Components<Bounded> close_cross_product(const EdgeVector& u, const EdgeVector& v) {
  Components<Bounded> cross =
      cross_product(gap_between<Bounded>(*u.to, *u.from), gap_between<Bounded>(*v.to, *v.from));
  const auto is_close = [](const Bounded& c) { return c.error <= 0x1p-44 * std::abs(c.value); };
  if (is_close(cross[0]) && is_close(cross[1]) && is_close(cross[2])) return cross;
  const Components<DoubleDouble> a = gap_between<DoubleDouble>(*u.to, *u.from);
  const Components<DoubleDouble> b = gap_between<DoubleDouble>(*v.to, *v.from);
  for (std::size_t j = 0; j < 3; ++j)
    if (!is_close(cross[j])) cross[j] = close_minor(a, b, (j + 1) % 3, (j + 2) % 3);
  return cross;
}

}  // namespace

SpacePiece::SpacePiece(const TriangleTree& triangles, std::size_t triangle)
    : triangles_(&triangles), triangle_(triangle) {
  for (int i = 0; i < 3; ++i)
    edge_vectors_[static_cast<std::size_t>(i)] = {&corner(i), &corner(i == 2 ? 0 : i + 1)};
}

SpacePiece::SpacePiece(const SpaceCorner* corners)
    : box_(corners),
      flat_((corners[0].x == corners[7].x) | (corners[0].y == corners[7].y) << 1 |
            (corners[0].z == corners[7].z) << 2),
      edge_vectors_{{{&origin, &units[0]}, {&origin, &units[1]}, {&origin, &units[2]}}} {}

std::array<int, 2> SpacePiece::edge(int i) const {
  if (!is_box()) return {i, i == 2 ? 0 : i + 1};
  // Along each axis there are four edges, which start at the corners without that axis's bit.
  const int axis = i / 4, one = (axis + 1) % 3, other = (axis + 2) % 3;
  const int from = (i % 2) << one | (i / 2 % 2) << other;
  return {from, from | 1 << axis};
}

void SpacePieces::take_box(const Box<3>& box) {
  form_ = nullptr, box_ = box;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const auto at = [&](int axis) { return (i >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis]; };
    corners_[i] = {at(0), at(1), at(2)};
  }
}

Components<Bounded> close_direction_of(const SpaceAxis& axis) {
  if (axis.factors == 1) return direction_of<Bounded>(axis);
  const Components<Bounded> normal = close_cross_product(axis.u, axis.v);
  if (axis.factors == 2) return normal;
  return cross_product(normal, gap_between<Bounded>(*axis.w.to, *axis.w.from));
}

std::array<std::optional<double>, 3> steady_axes_of(const Setup& setup, const double* row_a,
                                                    const double* row_b) {
  std::array<std::optional<double>, 3> steady;
  const double t_a = value_or(row_a, setup.a.at.t, 0), t_b = value_or(row_b, setup.b.at.t, 0);
  for (int j = 0; j < 3; ++j) {
    const AxisMotion<double> a = axis_motion(setup.a, row_a, j), b = axis_motion(setup.b, row_b, j);
    if (a.v != b.v || a.a != b.a || (t_a != t_b && a.a != 0)) continue;
    if (t_a == t_b || a.v == 0) {
      const DoubleDouble d = difference(b.x, a.x);
      if (d.low == 0) steady[static_cast<std::size_t>(j)] = d.high;
    } else {
      const Dyadic d = Dyadic(b.x) - Dyadic(a.x) + Dyadic(a.v) * (Dyadic(t_a) - Dyadic(t_b));
      const double near = rounded(d);
      if (std::isfinite(near) && Dyadic(near) == d) steady[static_cast<std::size_t>(j)] = near;
    }
  }
  return steady;
}

}  // namespace foresee
