// Of which convex pieces is an outline the union? Contact is decided between these.
//
//   const ConvexPieces pieces = convex_pieces(outline);            // cut once an outline
//   const ConvexPieces rotated = turned_pieces(pieces, turned(outline, 37.5));
//   for (std::size_t p = 0; p < pieces.count(); ++p)
//     pieces.corners(p), pieces.inner(p), pieces.bounds(p);
//
// Every piece is a ring of three corners or more, counterclockwise, that turns left or goes straight on at
// each: by exact signs. Pieces meet only at their boundaries, and together they are the region, no more and
// no less: every corner is one of the outline's. An edge of a piece is inner where it is a cut: what leaves
// the piece through it is in another one. Holes, parts, and rings that touch need no care by who reads
// pieces.
//
// Cut by one sweep that triangulates (S. Hertel, K. Mehlhorn, "Fast triangulation of the plane with respect
// to simple polygons", Information and Control 64, 1985), then cuts are taken back while what they part is
// convex together, which leaves at most four times as few pieces as there can be. Cost: n log n, about half a
// microsecond a corner; turned_pieces() a tenth of that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shape/outline/box_tree.h"
#include "shape/outline/outline.h"

namespace foresee {

class ConvexPieces {
 public:
  /// Which corners make which pieces: the same for all headings of an outline.
  struct Cut {
    std::vector<std::uint32_t> corners;  ///< of all pieces, by their places in the outline
    std::vector<std::uint8_t> inner;     ///< whether the edge from each to the next of its piece is a cut
    std::vector<std::uint32_t> ends;     ///< where each piece ends among them
    std::vector<bool> counterclockwise;  ///< how the rings of the outline run
    std::size_t outline_corners = 0;     ///< as many has the outline
  };

  ConvexPieces() = default;
  /// Requires: the places in `cut` are of `corners`, and its pieces in an order for a tree.
  ConvexPieces(std::shared_ptr<const Cut> cut, std::span<const Corner> corners);

  std::size_t count() const { return cut_ ? cut_->ends.size() : 0; }
  std::span<const Corner> corners(std::size_t piece) const {
    return std::span(corners_).subspan(begin(piece), size(piece));
  }
  /// For each corner of the piece, 1 if the edge from it to the next is a cut, else 0.
  std::span<const std::uint8_t> inner(std::size_t piece) const {
    return std::span(cut_->inner).subspan(begin(piece), size(piece));
  }
  const Box<2>& bounds(std::size_t piece) const { return tree_.box(tree_.leaf(piece)); }
  /// Item p of the tree is piece p.
  const BoxTree<2>& tree() const { return tree_; }
  const std::shared_ptr<const Cut>& cut() const { return cut_; }
  /// Bytes, without the cut.
  std::size_t memory() const { return sizeof *this + corners_.size() * sizeof(Corner) + tree_.memory(); }

 private:
  std::size_t begin(std::size_t piece) const { return piece == 0 ? 0 : cut_->ends[piece - 1]; }
  std::size_t size(std::size_t piece) const { return cut_->ends[piece] - begin(piece); }

  std::shared_ptr<const Cut> cut_;
  std::vector<Corner> corners_;
  BoxTree<2> tree_;
};

/// Requires: a valid outline (validity.h).
ConvexPieces convex_pieces(const Outline& outline);

/// The pieces of `turned`, which is the outline of `pieces` turned and valid. Cut alike where every piece is
/// still convex and every ring still runs the same way round: then the pieces wind once round each point
/// within and round no other, as the rings do of which they are the sum. Else, as rounding has moved a corner
/// across an edge, cut anew.
ConvexPieces turned_pieces(const ConvexPieces& pieces, const Outline& turned);

}  // namespace foresee
