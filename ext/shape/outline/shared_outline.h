// An outline that many rows share, with its convex pieces and its rotations, which are checked on demand.
//
//   const auto hull = std::make_shared<const SharedOutline>(read_outline(text));
//   hull->pieces();                      // cut at the first call, by whichever thread comes first
//   hull->rotated(37.5)               // throws if the rotated outline is not valid
//
// Immutable: several threads and statements may hold one.
#pragma once

#include <mutex>

#include "shape/outline/convex_pieces.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"
#include "shape/shared_form.h"

namespace foresee {

class SharedOutline final : public Form {
 public:
  using Pieces = ConvexPieces;
  /// Requires: a valid outline (validity.h).
  explicit SharedOutline(Outline outline) : outline_(std::move(outline)) {}
  /// A zone: the outline on the plane, and its corners in longitude and latitude as they were written.
  SharedOutline(Outline outline, Outline degrees)
      : outline_(std::move(outline)), degrees_(std::move(degrees)) {}

  const Outline& outline() const { return outline_; }
  /// Of a zone; without parts for other outlines.
  const Outline& degrees() const { return degrees_; }
  const ConvexPieces& pieces() const {
    std::call_once(cut_, [this] { pieces_ = convex_pieces(outline_); });
    return pieces_;
  }
  /// The outline rotated by `heading` degrees (outline_rotation.h). Throws Error if the result is not a valid
  /// outline, or beyond the largest double. Requires: -360 <= heading <= 360.
  Outline rotated(double heading) const;
  ConvexPieces rotated_pieces(double heading) const { return turned_pieces(pieces(), rotated(heading)); }

  Shape shape() const override { return Shape::outline; }
  std::size_t corners() const override { return outline_.corners().size() + degrees_.corners().size(); }
  std::string text() const override { return write_outline(degrees_.parts() > 0 ? degrees_ : outline_); }
  Extents<3> extents(double heading) const override {
    const Extents<2> flat = rotated(heading).extents();
    Extents<3> around = Extents<3>::none();
    for (int j = 0; j < 2; ++j) around.lower[j] = flat.lower[j], around.upper[j] = flat.upper[j];
    return around;
  }

 private:
  Outline outline_, degrees_;
  mutable std::once_flag cut_, checked_;
  mutable ConvexPieces pieces_;
  mutable std::optional<Flaw> edge_touch_;
};

}  // namespace foresee
