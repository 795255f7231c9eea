#include "contact/mesh/space_sum.h"

#include "numbers/dyadic.h"
#include "shape/outline/outline.h"

namespace foresee {
namespace {

/// The sign, or 2 if it is unknown. Bit 0 is set if it is certainly not 0.
int sign_bits(const Bounded& c) {
  const double error = c.error * (1 + 0x1p-40);
  if (c.value > error) return 1;
  if (c.value < -error) return -1;
  return c.value == 0 && c.error == 0 ? 0 : 2;
}

/// The exact sign of component j of u x v.
int minor_sign(const EdgeVector& u, const EdgeVector& v, int j) {
  const auto seen = [j](const SpaceCorner& corner) {
    const Components<double> at{corner.x, corner.y, corner.z};
    return Corner{at[static_cast<std::size_t>((j + 1) % 3)], at[static_cast<std::size_t>((j + 2) % 3)]};
  };
  return turn_sign(seen(*u.from), seen(*u.to), seen(*v.from), seen(*v.to));
}

/// The corners of a piece that are farthest along an axis and against it.
class Extremes {
 public:
  Extremes(const SpacePiece& piece, const SpaceAxis& axis, const Components<Bounded>& direction)
      : piece_(piece), axis_(axis), direction_(direction) {
    if (piece.is_box())
      take_of_box();
    else if (!is_own_normal())
      take_of_triangle();
  }

  const SpaceCorner& farthest() const { return piece_.corner(farthest_); }
  const SpaceCorner& nearest() const { return piece_.corner(nearest_); }

 private:
  void take_of_box() {
    for (int j = 0; j < 3; ++j) {
      const int bit = 1 << j;
      if ((piece_.flat() & bit) != 0) continue;
      const int sign = component_sign(j);
      if (sign > 0) farthest_ |= bit;
      if (sign < 0) nearest_ |= bit;
    }
  }
  void take_of_triangle() {
    for (const int i : {1, 2}) {
      if (sign_from(farthest_, i) > 0) farthest_ = i;
      if (sign_from(nearest_, i) < 0) nearest_ = i;
    }
  }

  /// Whether the axis is the normal of this triangle: all its corners are at the same distance then.
  bool is_own_normal() const {
    const auto is_edge_vector = [this](const EdgeVector& run, std::size_t i) {
      return run.from == piece_.edge_vectors()[i].from && run.to == piece_.edge_vectors()[i].to;
    };
    return axis_.factors == 2 && is_edge_vector(axis_.u, 0) && is_edge_vector(axis_.v, 1);
  }

  /// Requires: the axis is an edge vector or the cross product of two.
  int component_sign(int j) const {
    const int sign = sign_bits(direction_[static_cast<std::size_t>(j)]);
    return sign != 2 ? sign : minor_sign(axis_.u, axis_.v, j);
  }

  /// 1 if corner i is farther along the axis than another, -1 if it is less far, else 0.
  int sign_from(int other, int i) const {
    const SpaceCorner &from = piece_.corner(other), &to = piece_.corner(i);
    if (is_perpendicular_factor(from, to)) return 0;
    const int sign = sign_bits(dot(direction_, gap_between<Bounded>(to, from)));
    return sign != 2 ? sign : exact_sign_from(from, to);
  }

  /// Whether the edge between two corners is a factor of the axis, and so perpendicular to it.
  bool is_perpendicular_factor(const SpaceCorner& from, const SpaceCorner& to) const {
    const auto is_along = [&](const EdgeVector& run) {
      return (run.from == &from && run.to == &to) || (run.from == &to && run.to == &from);
    };
    if (axis_.factors == 2) return is_along(axis_.u) || is_along(axis_.v);
    return axis_.factors == 3 && is_along(axis_.w);
  }

  [[gnu::noinline]] int exact_sign_from(const SpaceCorner& from, const SpaceCorner& to) const {
    return dot(direction_of<Dyadic>(axis_), gap_between<Dyadic>(to, from)).sign();
  }

  const SpacePiece& piece_;
  const SpaceAxis& axis_;
  const Components<Bounded>& direction_;
  int farthest_ = 0, nearest_ = 0;
};

bool are_surely_not_parallel(const Components<Bounded>& cross) {
  const auto is_there = [](const Bounded& c) { return (sign_bits(c) & 1) != 0; };
  return is_there(cross[0]) || is_there(cross[1]) || is_there(cross[2]);
}

}  // namespace

bool are_parallel(const EdgeVector& u, const EdgeVector& v) {
  return minor_sign(u, v, 0) == 0 && minor_sign(u, v, 1) == 0 && minor_sign(u, v, 2) == 0;
}

bool SpaceHull::make(const SpaceAxis& axis, SpacePlanes& planes) const {
  planes.direction = close_direction_of(axis);
  if (axis.factors == 2 && !are_surely_not_parallel(planes.direction) && are_parallel(axis.u, axis.v))
    return false;
  const Extremes a(a_, axis, planes.direction), b(b_, axis, planes.direction);
  planes.before = {.sign = -1, .feature = {axis, &a.nearest(), &b.farthest()}};
  planes.beyond = {.sign = 1, .feature = {axis, &a.farthest(), &b.nearest()}};
  const SpaceFeature &before = planes.before.feature, &beyond = planes.beyond.feature;
  planes.is_flat = before.p == beyond.p && before.q == beyond.q;
  return true;
}

RoundPart RoundParts::face_of_triangle(bool of_a, const SpaceCorner& seen_from) const {
  const SpacePiece& triangle = one(of_a);
  const EdgeVector &u = triangle.edge_vectors()[0], &v = triangle.edge_vectors()[1];
  RoundPart part{.round =
                     constraint(of_a, Kind::slab, 1, {.factors = 2, .u = u, .v = v}, *u.from, seen_from)};
  // The cross product of the normal and an edge points inward.
  for (const EdgeVector& run : triangle.edge_vectors())
    add(part, constraint(of_a, Kind::half_space, -1, {.factors = 3, .u = u, .v = v, .w = run}, *run.from,
                         seen_from));
  return part;
}

RoundPart RoundParts::face_of_box(bool of_a, int i, const SpaceCorner& seen_from) const {
  const SpacePiece& box = one(of_a);
  const SpaceCorner &lower = box.corner(0), &upper = box.corner(7);
  const auto across = [&box](int axis) {
    return SpaceAxis{.factors = 1, .u = box.edge_vectors()[static_cast<std::size_t>(axis)]};
  };
  RoundPart part{.round = constraint(of_a, Kind::slab, 1, across(i % 3), i < 3 ? lower : upper, seen_from)};
  for (const int axis : {(i + 1) % 3, (i + 2) % 3}) {
    add(part, constraint(of_a, Kind::half_space, -1, across(axis), lower, seen_from));
    add(part, constraint(of_a, Kind::half_space, 1, across(axis), upper, seen_from));
  }
  return part;
}

RoundPart RoundParts::edge(bool of_a, int i, const SpaceCorner& seen_from) const {
  const SpacePiece& piece = one(of_a);
  const auto [from, to] = piece.edge(i);
  const SpaceAxis along{.factors = 1, .u = piece.vector_of_edge(i)};
  RoundPart part{.round = constraint(of_a, Kind::tube, 1, along, piece.corner(from), seen_from)};
  add(part, constraint(of_a, Kind::half_space, -1, along, piece.corner(from), seen_from));
  add(part, constraint(of_a, Kind::half_space, 1, along, piece.corner(to), seen_from));
  return part;
}

/// Let n = u x v and g = d - (p - q) = s u - t v + r n. Then s has the sign of g (v x n), and t has that of
/// g (u x n): the planes bound both.
RoundPart RoundParts::edges(int i, int k) const {
  const auto [p_from, p_to] = a_.edge(i);
  const auto [q_from, q_to] = b_.edge(k);
  const EdgeVector &u = a_.vector_of_edge(i), &v = b_.vector_of_edge(k);
  const SpaceCorner &p = a_.corner(p_from), &p_end = a_.corner(p_to);
  const SpaceCorner &q = b_.corner(q_from), &q_end = b_.corner(q_to);
  const SpaceAxis beside_a{.factors = 3, .u = u, .v = v, .w = v},
      beside_b{.factors = 3, .u = u, .v = v, .w = u};
  RoundPart part{.round = {Kind::slab, 1, {{.factors = 2, .u = u, .v = v}, &p, &q}}};
  add(part, {Kind::half_space, 1, {beside_a, &p, &q}});
  add(part, {Kind::half_space, -1, {beside_a, &p_end, &q}});
  add(part, {Kind::half_space, 1, {beside_b, &p, &q}});
  add(part, {Kind::half_space, -1, {beside_b, &p, &q_end}});
  return part;
}

}  // namespace foresee
