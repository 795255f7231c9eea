#include "contact/pair_rule.h"

#include <algorithm>

#include "base/error.h"
#include "shape/shapes.h"

namespace foresee {

/// What a shape contributes to the distance of a pair.
struct ShapeRule {
  bool faces = false;    ///< flat faces on every axis: two of these are compared per axis
  bool round = false;    ///< a radius
  bool upright = false;  ///< compared along z alone
  PieceKind pieces = PieceKind::none;
};

namespace {

// A new Shape must not compile before it has a distance: a missing one would be a wrong proof.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"
ShapeRule rule_of(Shape shape, int axes) {
  switch (shape) {
    case Shape::point:
      return {};
    case Shape::box:
      return {.faces = true};
    case Shape::ball:
      return {.round = true};
    case Shape::cylinder:
      return {.round = true, .upright = true};
    case Shape::outline:
      return {.round = true, .upright = axes == 3, .pieces = PieceKind::planar};
    case Shape::mesh:
      return {.round = true, .pieces = PieceKind::spatial};
  }
  throw Error("contact of a shape that this version does not know");
}
#pragma GCC diagnostic pop

const char* plural_of(Shape shape) {
  return shape == Shape::cylinder ? "cylinders" : shape == Shape::outline ? "prisms" : nullptr;
}

bool has(const Layout& a, const Layout& b, Shape shape) {
  return a.shape == shape || b.shape == shape;
}

void require_cylinders_or_points(const Layout& a, const Layout& b) {
  if (a.axes != 3)
    throw Error("within_z is for tables with x, y and z; leave it out here (within covers every axis)");
  if (has(a, b, Shape::mesh))
    throw Error("within_z is not for meshes: leave it out; within covers every axis");
  if (!has(a, b, Shape::point) && !has(a, b, Shape::cylinder) && !has(a, b, Shape::outline))
    throw Error(
        "within_z needs points, cylinders (r with hz) or prisms (shape with hz) on one side; else leave it "
        "out: within covers every axis");
}

void require_no_ball_with_upright(const Layout& a, const Layout& b, const std::string& name_a,
                                  const std::string& name_b) {
  if (!has(a, b, Shape::ball)) return;
  const bool ball_a = a.shape == Shape::ball;
  const std::string& ball = ball_a ? name_a : name_b;
  const std::string& upright = ball_a ? name_b : name_a;
  const char* const other = plural_of((ball_a ? b : a).shape);
  throw Error("no distance is defined between " + upright + " (" +
              (other ? other : "points, cylinders by within_z") + ") and " + ball +
              " (balls): declare hz in " + ball +
              (other ? " to make them cylinders" : ", or leave out within_z"));
}

void require_distance_of_outlines(const Layout& a, const Layout& b, const std::string& name_a,
                                  const std::string& name_b) {
  for (const Layout* side : {&a, &b})
    if (side->shape == Shape::box && grows(*side))
      throw Error("no distance is defined between outlines and boxes that grow: declare r and growth in " +
                  (side == &a ? name_a : name_b) + " in place of hx and hy");
  if (a.axes == 3) require_no_ball_with_upright(a, b, name_a, name_b);
}

void require_distance_of_meshes(const Layout& a, const Layout& b, const std::string& name_a,
                                const std::string& name_b) {
  const bool mesh_a = a.shape == Shape::mesh;
  const Shape other = (mesh_a ? b : a).shape;
  if (other == Shape::cylinder || other == Shape::outline) {
    const std::string& mesh = mesh_a ? name_a : name_b;
    const std::string& upright = mesh_a ? name_b : name_a;
    throw Error("no distance is defined between " + mesh + " (meshes) and " + upright + " (" +
                plural_of(other) + "): leave hz out of " + upright +
                (other == Shape::outline ? " and declare meshes" : " to make them balls"));
  }
  for (const Layout* side : {&a, &b})
    if (grows(*side))
      throw Error("no distance is defined between meshes and what grows: leave growth out of " +
                  (side == &a ? name_a : name_b) + ", or write within");
}

}  // namespace

/// One table, or a window.
struct PairRule::Side {
  Side(const Layout& layout) : Side(layout, rule_of(layout.shape, layout.axes)) {}
  Side(const Layout& layout, const ShapeRule& rule)
      : layout(layout), at(row_offsets(layout)), rule(rule), has_half(at.half != Offsets::absent) {}

  int growth(int axis) const { return growth_place(layout.shape, at, axis); }

  const Layout layout;
  const Offsets at;
  const ShapeRule rule;
  const bool has_half;  ///< a box
};

PairRule::PairRule(const Layout& a, const Layout& b, double within, std::optional<double> within_z)
    : PairRule(Side(a), Side(b), within, within_z) {}

PairRule::PairRule(const Side& a, const Side& b, double within, std::optional<double> within_z)
    : pieces(std::max(a.rule.pieces, b.rule.pieces)),
      grows(foresee::grows(a.layout) || foresee::grows(b.layout)),
      t_a(a.at.t),
      t_b(b.at.t) {
  const int axes = a.layout.axes;
  if (a.rule.upright || b.rule.upright || within_z)
    distance = Distance::upright;
  else if (axes > 1 && !(a.rule.faces && b.rule.faces))
    distance = Distance::euclidean;

  const auto add = [](PairSize& size, bool of_a, int place, int growth) {
    (of_a ? size.a : size.b) = place, (of_a ? size.growth_a : size.growth_b) = growth;
  };
  for (const bool of_a : {true, false}) {
    const Side& side = of_a ? a : b;
    if (distance != Distance::per_axis && !side.has_half) add(radius, of_a, side.at.r, side.growth(0));
    for (int axis = 0; axis < axes; ++axis) {
      const bool is_height = distance == Distance::upright && axis == 2;
      if (pieces != PieceKind::none && !is_height) continue;
      if (side.has_half)  // boxes that are pieces do not grow
        add(extent[axis], of_a, side.at.half + axis,
            pieces == PieceKind::none ? side.growth(axis) : Offsets::absent);
      else if (is_height)
        add(extent[axis], of_a, side.at.hz, side.growth(axis));
      else if (axes == 1)  // a ball of one axis is an interval
        add(extent[axis], of_a, side.at.r, side.growth(axis));
    }
  }
  if (distance != Distance::per_axis) radius.limit = within;
  if (distance == Distance::upright) extent[2].limit = within_z.value_or(0);
  if (distance == Distance::per_axis)
    for (PairSize& size : extent) size.limit = within;
}

PairRule PairRule::of_window(const Layout& window, const Layout& objects, bool is_zone) {
  const ShapeRule faces = rule_of(is_zone ? Shape::outline : Shape::box, objects.axes);
  const PairRule rule(Side(window, faces), Side(objects), 0, {});
  const bool is_round = is_zone || rule_of(objects.shape, objects.axes).round;
  return is_round ? rule : rule.without_radius();
}

PairRule PairRule::without_radius() const {
  PairRule rule = *this;
  rule.distance = Distance::per_axis, rule.radius = {};
  return rule;
}

void require_distance(const Layout& a, const Layout& b, const std::optional<double>& within_z,
                      const std::string& name_a, const std::string& name_b) {
  if (within_z) require_cylinders_or_points(a, b);
  if (has(a, b, Shape::mesh)) return require_distance_of_meshes(a, b, name_a, name_b);
  if (has(a, b, Shape::outline)) return require_distance_of_outlines(a, b, name_a, name_b);
  if (has(a, b, Shape::cylinder) || within_z) require_no_ball_with_upright(a, b, name_a, name_b);
}

void require_distance_from_zone(const Layout& objects, bool zone_has_z) {
  if (objects.shape == Shape::mesh)
    throw Error(
        "no distance is defined between meshes and a zone, which is flat: write x0 to z1, or declare hz in "
        "the table to make prisms");
  if (objects.shape == Shape::ball && objects.axes == 3 && zone_has_z)
    throw Error(
        "no distance is defined between balls and a zone with z0 or z1: leave z0 and z1 out, or declare hz "
        "in the table to make its balls cylinders");
  if (objects.shape == Shape::box && grows(objects))
    throw Error(
        "no distance is defined between a zone and boxes that grow: write x0 to y1, or declare r in the "
        "table in place of hx and hy");
}

}  // namespace foresee
