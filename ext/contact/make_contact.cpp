// The table of docs/semantics.md#contact, which distance a pair of shapes has, as one decision per statement.
#include "base/error.h"
#include "contact/contact.h"
#include "contact/mesh_contact.h"
#include "contact/outline_contact.h"
#include "contact/set/shape_pairs.h"
#include "contact/typed_contact.h"

namespace foresee {
namespace {

/// A ball-shaped table whose radii are all 0 and stay so holds points: where nothing is round and nothing is
/// within a distance, the cheaper distance per axis gives the same answers.
bool is_ball_of_size(const Bodies& bodies) {
  if (bodies.layout.shape != Shape::ball) return false;
  for (std::size_t i = 0; i < bodies.count; ++i)
    if (value_or(bodies.row(i), bodies.at.r, 0) > 0 || value_or(bodies.row(i), bodies.at.growth, 0) > 0)
      return true;
  return false;
}

/// Whether a distance is measured from its faces; from the centre otherwise.
bool is_box(const Bodies& bodies) {
  switch (bodies.layout.shape) {
    case Shape::box:
      return true;
    case Shape::point:
    case Shape::ball:
    case Shape::cylinder:
    case Shape::outline:
    case Shape::mesh:
      return false;
  }
  throw Error("contact of a shape that this version does not know");
}

bool has(const Bodies& a, const Bodies& b, Shape shape) {
  return a.layout.shape == shape || b.layout.shape == shape;
}

void require_cylinders_or_points(const Bodies& a, const Bodies& b) {
  if (a.layout.axes != 3)
    throw Error("within_z is for tables with x, y and z; leave it out here (within covers every axis)");
  if (has(a, b, Shape::mesh))
    throw Error("within_z is not for meshes: leave it out; within covers every axis");
  if (!has(a, b, Shape::point) && !has(a, b, Shape::cylinder) && !has(a, b, Shape::outline))
    throw Error(
        "within_z needs points, cylinders (r with hz) or prisms (shape with hz) on one side; between balls "
        "or boxes leave it out: within covers every axis");
}

const char* plural_of(Shape shape) {
  return shape == Shape::cylinder ? "cylinders" : shape == Shape::outline ? "prisms" : nullptr;
}

/// By declarations alone: no answer may be an error for some rows, ids or methods only.
void require_no_ball_with_cylinder(const Bodies& a, const Bodies& b, const std::string& name_a,
                                   const std::string& name_b) {
  if (!has(a, b, Shape::ball)) return;
  const bool ball_a = a.layout.shape == Shape::ball;
  const std::string& ball = ball_a ? name_a : name_b;
  const std::string& upright = ball_a ? name_b : name_a;
  const char* const other = plural_of((ball_a ? b : a).layout.shape);
  throw Error("no distance is defined between " + upright + " (" +
              (other ? other : "points, which within_z makes cylinders") + ") and " + ball +
              " (balls): declare hz in " + ball + " to make them cylinders" +
              (other ? "" : ", or leave out within_z"));
}

std::unique_ptr<Contact> make_contact_of_outlines(const Bodies& a, const Bodies& b,
                                                  const ContactQuestion& question, const std::string& name_a,
                                                  const std::string& name_b) {
  for (const Bodies* side : {&a, &b})
    if (is_box(*side) && grows(side->layout))
      throw Error("no distance is defined between outlines and boxes that grow: declare r and growth in " +
                  (side == &a ? name_a : name_b) + " in place of hx and hy");
  const bool prisms = a.layout.axes == 3;
  if (prisms) require_no_ball_with_cylinder(a, b, name_a, name_b);
  const Setup setup{a, b, question.horizon, question.within,
                    prisms ? question.within_z.value_or(0) : question.within};
  const auto outlines = [&](const Bodies& bodies) -> const OutlineRows* {
    if (question.rectangles_for_outlines || bodies.layout.shape != Shape::outline) return nullptr;
    if (!bodies.outlines && bodies.count > 0) throw Error("nobody knows the outlines of these rows");
    return bodies.outlines;
  };
  return make_outline_contact(setup, {outlines(a), outlines(b)},
                              std::max(degree_of(a.layout.law), degree_of(b.layout.law)));
}

void require_no_upright_with_mesh(const Bodies& a, const Bodies& b, const std::string& name_a,
                                  const std::string& name_b) {
  const bool mesh_a = a.layout.shape == Shape::mesh;
  const Shape other = (mesh_a ? b : a).layout.shape;
  if (other != Shape::cylinder && other != Shape::outline) return;
  const std::string& mesh = mesh_a ? name_a : name_b;
  const std::string& upright = mesh_a ? name_b : name_a;
  throw Error("no distance is defined between " + mesh + " (meshes) and " + upright + " (" +
              plural_of(other) + "): leave hz out of " + upright +
              (other == Shape::outline ? " and declare meshes" : " to make them balls"));
}

std::unique_ptr<Contact> make_contact_of_meshes(const Bodies& a, const Bodies& b,
                                                const ContactQuestion& question, const std::string& name_a,
                                                const std::string& name_b) {
  require_no_upright_with_mesh(a, b, name_a, name_b);
  for (const Bodies* side : {&a, &b})
    if (grows(side->layout))
      throw Error("no distance is defined between meshes and what grows: leave growth out of " +
                  (side == &a ? name_a : name_b) + ", or write within");
  const Setup setup{a, b, question.horizon, question.within, question.within};
  const auto meshes = [&](const Bodies& bodies) -> const MeshRows* {
    if (question.rectangles_for_outlines || bodies.layout.shape != Shape::mesh) return nullptr;
    if (!bodies.meshes && bodies.count > 0) throw Error("nobody knows the meshes of these rows");
    return bodies.meshes;
  };
  return make_mesh_contact(setup, {meshes(a), meshes(b)},
                           std::max(degree_of(a.layout.law), degree_of(b.layout.law)));
}

}  // namespace

std::unique_ptr<Contact> make_contact(const Bodies& a, const Bodies& b, const ContactQuestion& question,
                                      const std::string& name_a, const std::string& name_b) {
  if (question.within_z) require_cylinders_or_points(a, b);
  if (has(a, b, Shape::mesh)) return make_contact_of_meshes(a, b, question, name_a, name_b);
  if (has(a, b, Shape::outline)) return make_contact_of_outlines(a, b, question, name_a, name_b);
  const double within = question.within;
  const int degree = std::max(degree_of(a.layout.law), degree_of(b.layout.law));
  const bool box_a = is_box(a), box_b = is_box(b), box = box_a || box_b;
  if (has(a, b, Shape::cylinder) || question.within_z) {
    require_no_ball_with_cylinder(a, b, name_a, name_b);
    const Setup upright{a, b, question.horizon, within, question.within_z.value_or(0)};
    return make_set_contact(upright, box ? cylinder_box_set(upright) : cylinder_cylinder_set(upright),
                            degree);
  }
  const Setup setup{a, b, question.horizon, within, within};
  const bool round = is_ball_of_size(a) || is_ball_of_size(b) || within > 0;
  // Per axis: boxes among themselves, anything in one dimension, and where nothing is round.
  if ((box_a && box_b) || a.layout.axes == 1 || !round)
    return grows(a.layout) || grows(b.layout) ? make_set_contact(setup, box_box_set(setup), degree)
                                              : make_box_contact(setup, degree);
  return make_set_contact(setup, box ? box_ball_set(setup) : ball_ball_set(setup), degree);
}

}  // namespace foresee
