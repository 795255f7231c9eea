// When does an object touch a moving window? The second door of the room: one window instead of one side's
// bodies.
//
//   WindowFaces faces;                                           // nothing bounds it
//   faces.lower[0] = 0, faces.upper[0] = 100, faces.velocity[0] = 1;
//   MovingWindow window(faces, 2, 600);                          // axes, now
//   auto contact = make_window_contact(window, ships, {.now = 600, .h = 300});
//   contact->decide(pairs, hits);                                // pairs (0, row of the object)
//
// A window is a closed box whose faces move together from `now` on; an infinite face is no bound. Touching
// counts. Boxes and points are compared axis by axis; discs and balls by the Euclidean distance from the
// window to the surface; cylinders so in x and y, and along z apart. Decision and times are exact, as
// between two objects: a window is never turned into a centre and half extents, which doubles might not hold.
#pragma once

#include <array>

#include "contact/contact.h"
#include "contact/set/window_faces.h"

namespace foresee::contact {

/// A window as a body that contact can be asked about: a point at the reference of its faces.
class MovingWindow {
 public:
  MovingWindow(const WindowFaces& faces, int axes, double now);
  MovingWindow(const MovingWindow&) = delete;
  MovingWindow& operator=(const MovingWindow&) = delete;

  const WindowFaces& faces() const { return faces_; }
  const Bodies& bodies() const { return bodies_; }

 private:
  WindowFaces faces_;
  std::array<double, 7> row_{};
  Bodies bodies_;
};

/// Requires: as many axes; the window is made for horizon.now. Window and objects must outlive the contact.
std::unique_ptr<Contact> make_window_contact(const MovingWindow& window, const Bodies& objects,
                                             const Horizon& horizon);

}  // namespace foresee::contact
