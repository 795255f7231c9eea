// make_contact() and make_window_contact(): select the distance of a pair of shapes, and the class that
// decides it, once per statement. The table of docs/explanation/semantics.md#contact lists the distances.
#include "base/error.h"
#include "contact/contact.h"
#include "contact/contact_factories.h"
#include "contact/set/shape_pairs.h"
#include "contact/window_contact.h"

namespace foresee {
namespace {

/// Whether a table of balls has one of radius above 0 now or later. Balls of radius 0 are points: if `within`
/// is 0, the cheaper distance per axis gives the same answers.
bool is_ball_of_size(const Bodies& bodies) {
  if (bodies.layout.shape != Shape::ball) return false;
  for (std::size_t i = 0; i < bodies.count; ++i)
    if (value_or(bodies.row(i), bodies.at.r, 0) > 0 || value_or(bodies.row(i), bodies.at.growth, 0) > 0)
      return true;
  return false;
}

/// Whether distances are measured from the faces of the shape; else from its centre.
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

/// Depends on the declarations alone: the error must not depend on rows, ids or methods.
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
    if (!bodies.outlines && bodies.count > 0) throw Error("the outlines of these rows are not loaded");
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
    if (!bodies.meshes && bodies.count > 0) throw Error("the meshes of these rows are not loaded");
    return bodies.meshes;
  };
  return make_mesh_contact(setup, {meshes(a), meshes(b)},
                           std::max(degree_of(a.layout.law), degree_of(b.layout.law)));
}

ContactSet window_set(const Setup& setup) {
  switch (setup.b.layout.shape) {
    case Shape::cylinder:
      return window_cylinder_set(setup);
    case Shape::ball:
      return setup.b.layout.axes > 1 ? window_ball_set(setup) : window_box_set(setup);
    case Shape::point:
    case Shape::box:
      return window_box_set(setup);
    case Shape::outline:
    case Shape::mesh:
      break;
  }
  throw Error("contact of a window and a shape that this version does not know");
}

void require_distance(const MovingWindow& zone, const Layout& objects) {
  const WindowFaces& faces = zone.faces();
  if (objects.shape == Shape::mesh)
    throw Error(
        "no distance is defined between meshes and a zone, which is flat: bound the window by x0, x1, y0, "
        "y1, "
        "z0 and z1, or declare hz in the table to make its shapes prisms");
  if (objects.shape == Shape::ball && objects.axes == 3 && (faces.has_lower(2) || faces.has_upper(2)))
    throw Error(
        "no distance is defined between balls and a zone with z0 or z1: leave these out, or declare hz "
        "in the table to make its balls cylinders");
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
  // Distance per axis: two boxes, all shapes on one axis, and pairs in which nothing is round.
  if ((box_a && box_b) || a.layout.axes == 1 || !round)
    return grows(a.layout) || grows(b.layout) ? make_set_contact(setup, box_box_set(setup), degree)
                                              : make_box_contact(setup, degree);
  return make_set_contact(setup, box ? box_ball_set(setup) : ball_ball_set(setup), degree);
}

MovingWindow::MovingWindow(const WindowFaces& faces, const Layout& objects, double now,
                           std::shared_ptr<const SharedOutline> zone)
    : faces_(faces) {
  const Layout layout{.axes = objects.axes, .law = Law::uniform, .shape = Shape::point, .has_t = true};
  bodies_ = Bodies(layout, row_.data(), 1);
  zone_.outline = std::move(zone);
  if (zone_.outline) bodies_.outlines = &zone_;
  from_origin_ = zone_.outline || objects.shape == Shape::outline || objects.shape == Shape::mesh;
  row_[static_cast<std::size_t>(bodies_.at.t)] = now;
  for (int axis = 0; axis < objects.axes; ++axis) {
    row_[static_cast<std::size_t>(bodies_.at.x + axis)] = from_origin_ ? 0 : faces.reference(axis);
    row_[static_cast<std::size_t>(bodies_.at.v + axis)] = faces.velocity[static_cast<std::size_t>(axis)];
  }
}

std::unique_ptr<Contact> make_window_contact(const MovingWindow& window, const Bodies& objects,
                                             const Horizon& horizon) {
  const Setup setup{.a = window.bodies(), .b = objects, .horizon = horizon, .window = &window.faces()};
  if (window.has_zone()) require_distance(window, objects.layout);
  if (objects.layout.shape == Shape::mesh)
    return make_mesh_contact(setup, {nullptr, objects.meshes}, degree_of(objects.layout.law));
  if (window.has_zone() || objects.layout.shape == Shape::outline) {
    return make_outline_contact(setup, {window.bodies().outlines, objects.outlines},
                                degree_of(objects.layout.law));
  }
  return make_set_contact(setup, window_set(setup), degree_of(objects.layout.law));
}

}  // namespace foresee
