#include "contact/window_contact.h"

#include "base/error.h"
#include "contact/mesh_contact.h"
#include "contact/outline_contact.h"
#include "contact/set/shape_pairs.h"
#include "contact/typed_contact.h"

namespace foresee {
namespace {

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
