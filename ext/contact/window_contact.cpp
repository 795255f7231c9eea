#include "contact/window_contact.h"

#include "contact/set/shape_pairs.h"

namespace foresee::contact {

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
  const int degree = degree_of(objects.layout.law);
  const Shape shape = objects.layout.shape;
  if (shape == Shape::cylinder) return make_set_contact(setup, window_cylinder_set(setup), degree);
  const bool round = shape == Shape::ball && objects.layout.axes > 1;
  return make_set_contact(setup, round ? window_ball_set(setup) : window_box_set(setup), degree);
}

}  // namespace foresee::contact
