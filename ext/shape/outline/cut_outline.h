// An outline that many rows share, and what is found of it once somebody asks: its convex pieces, and whether
// it may be turned.
//
//   const auto hull = std::make_shared<const CutOutline>(read_outline(text));
//   hull->pieces();                      // cut at the first call, by whichever thread comes first
//   hull->as_it_lies(37.5)               // throws where the outline, turned so, is none
//
// Never changes: several threads and statements may hold one.
#pragma once

#include <mutex>

#include "shape/outline/convex_pieces.h"
#include "shape/outline/turn.h"
#include "shape/outline/validity.h"

namespace foresee::shape {

class CutOutline {
 public:
  /// Requires: a valid outline (validity.h).
  explicit CutOutline(Outline outline) : outline_(std::move(outline)) {}

  const Outline& outline() const { return outline_; }
  const ConvexPieces& pieces() const {
    std::call_once(cut_, [this] { pieces_ = convex_pieces(outline_); });
    return pieces_;
  }
  /// Turned by `heading` degrees (turn.h). Throws Error if that is no outline, or beyond the largest double.
  /// Requires: -360 <= heading <= 360.
  Outline as_it_lies(double heading) const {
    if (heading == 0) return outline_;
    std::call_once(touched_, [this] { edge_touch_ = edge_touch_of(outline_); });
    Outline lies = turned(outline_, heading);
    check_turned(outline_, edge_touch_, lies, heading);
    return lies;
  }

 private:
  Outline outline_;
  mutable std::once_flag cut_, touched_;
  mutable ConvexPieces pieces_;
  mutable std::optional<Flaw> edge_touch_;
};

/// Who knows outlines by the numbers that rows have.
class OutlineSource {
 public:
  virtual ~OutlineSource() = default;
  /// Never null: throws where there is none of this number.
  virtual std::shared_ptr<const CutOutline> outline(std::int64_t number) = 0;
};

}  // namespace foresee::shape
