// When does an object touch a moving window? The second door of the room: one window instead of one side's
// bodies.
//
//   WindowFaces faces;                                           // nothing bounds it
//   faces.lower[0] = 0, faces.upper[0] = 100, faces.velocity[0] = 1;
//   MovingWindow window(faces, ships.layout, 600);               // whom it meets, now
//   auto contact = make_window_contact(window, ships, {.now = 600, .h = 300});
//   contact->decide(pairs, hits);                                // pairs (0, row of the object)
//
// A window is a closed box whose faces move together from `now` on; an infinite face is no bound. Touching
// counts. Boxes and points are compared axis by axis; discs and balls by the Euclidean distance from the
// window to the surface; cylinders and outlines so in x and y, and along z apart. A zone, a window with an
// outline, is Euclidean against everything in x and y. Decision and times are exact, as
// between two objects: a window is never turned into a centre and half extents, which doubles might not hold.
#pragma once

#include <array>

#include "contact/contact.h"
#include "contact/set/window_faces.h"
#include "shape/outline/outline_rows.h"
#include "shape/outline/shared_outline.h"

namespace foresee {

/// A window as a body that contact can be asked about: a point at the reference of its faces, or at the
/// origin where contact is that of outlines or meshes. With a zone the window is what lies within that
/// outline, in absolute coordinates at `now`, and between its own faces across z; the others must be
/// infinite.
class MovingWindow {
 public:
  MovingWindow(const WindowFaces& faces, const Layout& objects, double now,
               std::shared_ptr<const SharedOutline> zone = nullptr);
  MovingWindow(const MovingWindow&) = delete;
  MovingWindow& operator=(const MovingWindow&) = delete;

  const WindowFaces& faces() const { return faces_; }
  const Bodies& bodies() const { return bodies_; }
  bool has_zone() const { return zone_.outline != nullptr; }

 private:
  /// The one row of a zone.
  struct Zone final : OutlineRows {
    const ConvexPieces* pieces(std::size_t, ScratchPieces<ConvexPieces>&) const override {
      return &outline->pieces();
    }
    std::shared_ptr<const SharedOutline> outline;
  };

  WindowFaces faces_;
  Zone zone_;
  bool from_origin_;
  std::array<double, 7> row_{};
  Bodies bodies_;
};

/// Requires: the window is made for this layout and for horizon.now. Throws Error for balls on three axes and
/// a zone with faces across z: no distance is defined there. Window and objects must outlive the contact.
std::unique_ptr<Contact> make_window_contact(const MovingWindow& window, const Bodies& objects,
                                             const Horizon& horizon);

}  // namespace foresee
