// Contact of objects with a moving window: the second public interface of the module, with one window in
// place of the first table.
//
//   WindowFaces faces;                                           // open to all sides
//   faces.lower[0] = 0, faces.upper[0] = 100, faces.velocity[0] = 1;
//   MovingWindow window(faces, ships.layout, 600);               // for tables of this layout, now
//   auto contact = make_window_contact(window, ships, {.now = 600, .h = 300});
//   contact->decide(pairs, hits);                                // pairs (0, row of the object)
//
// A window is a closed box whose faces move together from `now` on; an infinite face does not bound it.
// Touching counts. Boxes and points are compared axis by axis. Discs and balls have the Euclidean distance
// from the window to their surface. Cylinders and outlines have that distance in x and y, and are compared
// along z separately. A zone is a window with an outline: its distance in x and y is Euclidean for all
// shapes.
//
// Decision and times are exact, as between two objects. A window is never converted to a centre and half
// extents, which doubles might not represent.
#pragma once

#include <array>

#include "contact/contact.h"
#include "contact/setup.h"
#include "shape/form_rows.h"
#include "shape/outline/shared_outline.h"

namespace foresee {

/// A window as a body of a contact: a point at the reference of its faces, or at the origin for contact of
/// outlines or meshes. With a zone the window is the inside of that outline, in absolute coordinates at
/// `now`, between the faces across z; the other faces must be infinite.
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
  std::array<double, 7> row_{};
  Bodies bodies_;
};

/// The contact of a window and a table. Throws Error for balls on three axes and a zone with faces across z,
/// which have no distance. Requires: the window is made for this layout and for horizon.now; window and
/// objects outlive the contact.
std::unique_ptr<Contact> make_window_contact(const MovingWindow& window, const Bodies& objects,
                                             const Horizon& horizon);

}  // namespace foresee
