#include "shape/outline/convex_pieces.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/float_environment.h"
#include "shape/outline/outline.h"

namespace foresee {

namespace {

void grow(Box<2>& box, const Corner& corner) {
  const Vec<2> at{corner.x, corner.y};
  box.lower = box.lower.min(at), box.upper = box.upper.max(at);
}

/// Rings of sides: triangles at first, which merge() joins to convex pieces.
class SideRings {
 public:
  SideRings(std::span<const Corner> corners, std::vector<TriangleSide> sides)
      : corners_(corners), sides_(std::move(sides)), next_(sides_.size()), last_(sides_.size()) {
    for (std::uint32_t first = 0; first < sides_.size(); first += 3)
      for (std::uint32_t i = 0; i < 3; ++i)
        next_[first + i] = first + (i + 1) % 3, last_[first + i] = first + (i + 2) % 3;
  }

  /// Removes each cut between two pieces whose union is convex. One test per cut is enough: pieces only grow,
  /// and a corner at which the union of two is not convex remains such a corner.
  void merge() {
    for (std::uint32_t side = 0; side < sides_.size(); ++side) {
      const std::uint32_t twin = sides_[side].twin;
      if (twin == TriangleSide::none || twin < side) continue;
      if (!convex_without(side, twin) || !convex_without(twin, side)) continue;
      splice(last_[side], next_[twin]);
      splice(last_[twin], next_[side]);
      next_[side] = next_[twin] = removed;
    }
  }

  /// The rings, in an order for a tree.
  ConvexPieces::Cut cut() const {
    std::vector<std::uint32_t> firsts;
    std::vector<Box<2>> boxes;
    std::vector<bool> seen(sides_.size());
    for (std::uint32_t first = 0; first < sides_.size(); ++first) {
      if (next_[first] == removed || seen[first]) continue;
      firsts.push_back(first);
      boxes.push_back(Box<2>::empty());
      for_ring(first, [&](std::uint32_t side) {
        seen[side] = true;
        grow(boxes.back(), corner(side));
      });
    }
    ConvexPieces::Cut made;
    for (const std::uint32_t ring : tree_order<2>(boxes)) {
      for_ring(firsts[ring], [&](std::uint32_t side) {
        made.corners.push_back(sides_[side].corner);
        made.inner.push_back(sides_[side].twin != TriangleSide::none);
      });
      made.ends.push_back(static_cast<std::uint32_t>(made.corners.size()));
    }
    return made;
  }

 private:
  static constexpr std::uint32_t removed = TriangleSide::none;

  const Corner& corner(std::uint32_t side) const { return corners_[sides_[side].corner]; }

  /// Whether the merged ring, without `side` and `twin`, turns left or goes straight on at the start of
  /// `side`.
  bool convex_without(std::uint32_t side, std::uint32_t twin) const {
    return orientation(corner(last_[side]), corner(side), corner(next_[next_[twin]])) >= 0;
  }

  void splice(std::uint32_t side, std::uint32_t next) { next_[side] = next, last_[next] = side; }

  template <class Use>
  void for_ring(std::uint32_t first, Use&& use) const {
    std::uint32_t side = first;
    do use(side), side = next_[side];
    while (side != first);
  }

  std::span<const Corner> corners_;
  std::vector<TriangleSide> sides_;
  std::vector<std::uint32_t> next_, last_;  ///< neighbours of each side in its ring
};

/// Whether each ring runs counterclockwise.
std::vector<bool> directions_of(const Outline& outline) {
  std::vector<bool> counterclockwise;
  for (std::size_t r = 0; r < outline.rings(); ++r)
    counterclockwise.push_back(is_counterclockwise(outline.ring(r)));
  return counterclockwise;
}

std::shared_ptr<const ConvexPieces::Cut> cut_of(const Outline& outline) {
  SideRings rings(outline.corners(), triangulation(outline));
  rings.merge();
  ConvexPieces::Cut cut = rings.cut();
  cut.counterclockwise = directions_of(outline);
  cut.outline_corners = outline.corners().size();
  return std::make_shared<const ConvexPieces::Cut>(std::move(cut));
}

/// The cut of a single convex ring: one piece, with its corners in reverse order if `reversed`.
std::shared_ptr<const ConvexPieces::Cut> uncut(std::size_t corners, bool reversed) {
  ConvexPieces::Cut made;
  made.corners.resize(corners);
  std::iota(made.corners.begin(), made.corners.end(), 0);
  if (reversed) std::reverse(made.corners.begin(), made.corners.end());
  made.inner.resize(corners);
  made.ends.push_back(static_cast<std::uint32_t>(corners));
  made.counterclockwise.push_back(!reversed);
  made.outline_corners = corners;
  return std::make_shared<const ConvexPieces::Cut>(std::move(made));
}

}  // namespace

ConvexPieces::ConvexPieces(std::shared_ptr<const Cut> cut, std::span<const Corner> corners)
    : cut_(std::move(cut)) {
  corners_.reserve(cut_->corners.size());
  for (const std::uint32_t corner : cut_->corners) corners_.push_back(corners[corner]);
  std::vector<Box<2>> boxes(count(), Box<2>::empty());
  for (std::size_t piece = 0; piece < count(); ++piece)
    for (const Corner& corner : this->corners(piece)) grow(boxes[piece], corner);
  tree_ = BoxTree<2>(boxes);
}

ConvexPieces convex_pieces(const Outline& outline) {
  const FloatEnvironment environment;
  const std::span<const Corner> corners = outline.corners();
  const int direction = outline.rings() == 1 ? convex_direction(corners) : 0;
  return {direction == 0 ? cut_of(outline) : uncut(corners.size(), direction < 0), corners};
}

ConvexPieces turned_pieces(const ConvexPieces& pieces, const Outline& turned) {
  const FloatEnvironment environment;
  const ConvexPieces::Cut& cut = *pieces.cut();
  if (cut.outline_corners == turned.corners().size() && cut.counterclockwise == directions_of(turned)) {
    ConvexPieces alike(pieces.cut(), turned.corners());
    std::size_t convex = 0;
    while (convex < alike.count() && convex_direction(alike.corners(convex)) > 0) ++convex;
    if (convex == alike.count()) return alike;
  }
  return convex_pieces(turned);
}

}  // namespace foresee
