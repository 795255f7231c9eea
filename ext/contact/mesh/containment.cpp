#include "contact/mesh/containment.h"

#include <optional>

#include "contact/certified/uncertain_interval.h"
#include "contact/exact/exact_contact.h"
#include "contact/mesh/space_constraint.h"
#include "contact/minkowski/relative_motion.h"

namespace foresee {
namespace {

/// The position of b as seen from a at one time: enclosed at once, exact when it is first needed.
class Displacement {
 public:
  /// All arguments but `instant`, a time after now, must outlive this.
  Displacement(const Setup& setup, const double* row_a, const double* row_b, const CertainMotion<3>& relative,
               const Dyadic& instant)
      : setup_(setup), row_a_(row_a), row_b_(row_b), time_(instant) {
    const double tau = rounded(instant);
    const Bounded time{tau, unit_roundoff * std::abs(tau) + 0x1p-1070};
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& axis = relative.axis[j];
      near_[j] =
          Bounded{axis.x, axis.ex} + time * (Bounded{axis.v, axis.ev} + time * Bounded{axis.a, axis.ea});
      near_[j].error = near_[j].error_bound(relative.underflow);
    }
  }

  const Components<Bounded>& near() const { return near_; }
  const Components<Dyadic>& exact() {
    if (exact_) return *exact_;
    const auto x = relative_motion_of<Dyadic, 3>(setup_, row_a_, row_b_);
    exact_.emplace();
    for (std::size_t j = 0; j < 3; ++j) (*exact_)[j] = x[j][0] + time_ * (x[j][1] + time_ * x[j][2]);
    return *exact_;
  }

 private:
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const Dyadic time_;
  Components<Bounded> near_;
  std::optional<Components<Dyadic>> exact_;
};

/// A corner of one object as seen from the other, enclosed and exact: a corner of b for sign 1, of a for
/// sign -1.
class SeenCorner {
 public:
  SeenCorner(const SpaceCorner& corner, int sign, Displacement& d)
      : corner_(corner), sign_(sign), d_(d), near_(seen(d.near())) {
    for (Bounded& c : near_) c.error = c.error_bound(0x1p-1060);
  }

  const Components<Bounded>& near() const { return near_; }
  const Components<Dyadic>& exact() {
    if (!exact_) exact_ = seen(d_.exact());
    return *exact_;
  }

 private:
  template <class T>
  Components<T> seen(const Components<T>& d) const {
    const Components<T> place = components_of<T>(corner_);
    if (sign_ < 0) return difference_of(place, d);
    return {place[0] + d[0], place[1] + d[1], place[2] + d[2]};
  }

  const SpaceCorner& corner_;
  const int sign_;
  Displacement& d_;
  Components<Bounded> near_;
  std::optional<Components<Dyadic>> exact_;
};

/// The ray from a corner along x, and its crossings with the triangles of a solid.
class Ray {
 public:
  Ray(const TriangleTree& solid, SeenCorner& corner, Steps& steps)
      : solid_(solid), corner_(corner), steps_(steps) {}

  /// The number of triangles below a node that it crosses. Each node visited is a step.
  int crossings(BoxTree<3>::Node node) {
    steps_();
    if (!may_cross(solid_.tree().box(node))) return 0;
    if (solid_.tree().is_leaf(node)) return crosses(solid_.tree().item(node)) ? 1 : 0;
    return crossings(solid_.tree().left(node)) + crossings(solid_.tree().right(node));
  }

 private:
  bool may_cross(const Box<3>& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      const Bounded& c = corner_.near()[static_cast<std::size_t>(axis)];
      if (c.value - c.error > box.upper[axis]) return false;
      if (axis > 0 && c.value + c.error < box.lower[axis]) return false;  // the ray runs along x
    }
    return true;
  }

  bool crosses(std::size_t triangle) {
    const SpaceCorner* const corners[] = {&solid_.corner(triangle, 0), &solid_.corner(triangle, 1),
                                          &solid_.corner(triangle, 2)};
    const int turn_sign = side_of(*corners[0], *corners[1]);
    if (turn_sign == 0 || side_of(*corners[1], *corners[2]) != turn_sign ||
        side_of(*corners[2], *corners[0]) != turn_sign)
      return false;
    // `turn_sign` is the orientation of the triangle as seen along x, and the sign of its normal's x.
    return plane_sign(corners) * turn_sign < 0;
  }

  /// The side of an edge on which the ray passes, seen along x; 0 for an edge that is parallel to x.
  int side_of(const SpaceCorner& from, const SpaceCorner& to) {
    const int sign = sign_of([&]<class T>(const Components<T>& place) {
      const Components<T> run = gap_between<T>(to, from), gap = difference_of(place, components_of<T>(from));
      return run[1] * gap[2] - run[2] * gap[1];
    });
    if (sign != 0) return sign;
    if (to.z != from.z) return to.z > from.z ? -1 : 1;
    return to.y > from.y ? 1 : to.y < from.y ? -1 : 0;
  }

  /// The side of the triangle's plane on which the corner is: 1 where the normal points.
  int plane_sign(const SpaceCorner* const corners[3]) {
    const SpaceAxis normal{.factors = 2, .u = {corners[0], corners[1]}, .v = {corners[1], corners[2]}};
    return sign_of([&]<class T>(const Components<T>& place) {
      return dot(direction_of<T>(normal), difference_of(place, components_of<T>(*corners[0])));
    });
  }

  /// The sign of an expression of the corner's position.
  template <class Expression>
  int sign_of(const Expression& expression) {
    const int certain = certain_sign(with_lost(expression(corner_.near()), 0x1p-1060));
    return certain != 0 ? certain : expression(corner_.exact()).sign();
  }

  const TriangleTree& solid_;
  SeenCorner& corner_;
  Steps& steps_;
};

/// Whether a corner is inside a solid. On its surface the result is arbitrary.
bool is_enclosed(const TriangleTree& solid, SeenCorner& corner, Steps& steps) {
  return Ray(solid, corner, steps).crossings(BoxTree<3>::root) % 2 != 0;
}

/// Whether a connected component of one surface is inside a solid.
bool any_part_enclosed(const SpacePieces& parts, const TriangleTree& solid, int sign, Displacement& d,
                       Steps& steps) {
  for (std::size_t i = 0; i < parts.parts(); ++i) {
    SeenCorner corner(parts.part_corner(i), sign, d);
    if (is_enclosed(solid, corner, steps)) return true;
  }
  return false;
}

}  // namespace

bool Containment::at_start() {
  return may_be() && at(exact_lifetime_of(setup_, row_a_, row_b_).begin);
}

bool Containment::at(const Dyadic& time) {
  if (!may_be()) return false;
  Displacement d(setup_, row_a_, row_b_, relative_, time);
  return (a_.solid() && any_part_enclosed(b_, *a_.solid(), 1, d, steps_)) ||
         (b_.solid() && any_part_enclosed(a_, *b_.solid(), -1, d, steps_));
}

}  // namespace foresee
