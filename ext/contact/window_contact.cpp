#include "contact/window_contact.h"

#include "base/error.h"
#include "contact/set/shape_pairs.h"
#include "contact/typed_contact.h"

namespace foresee::contact {
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
  }
  throw Error("contact of a window and a shape that this version does not know");
}

}  // namespace

MovingWindow::MovingWindow(const WindowFaces& faces, int axes, double now) : faces_(faces) {
  const Layout layout{.axes = axes, .law = Law::uniform, .shape = Shape::point, .has_t = true};
  bodies_ = Bodies(layout, row_.data(), 1);
  row_[static_cast<std::size_t>(bodies_.at.t)] = now;
  for (int axis = 0; axis < axes; ++axis) {
    row_[static_cast<std::size_t>(bodies_.at.x + axis)] = faces.reference(axis);
    row_[static_cast<std::size_t>(bodies_.at.v + axis)] = faces.velocity[static_cast<std::size_t>(axis)];
  }
}

std::unique_ptr<Contact> make_window_contact(const MovingWindow& window, const Bodies& objects,
                                             const Horizon& horizon) {
  const Setup setup{.a = window.bodies(), .b = objects, .horizon = horizon, .window = &window.faces()};
  return make_set_contact(setup, window_set(setup), degree_of(objects.layout.law));
}

}  // namespace foresee::contact
