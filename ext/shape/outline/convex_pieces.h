// Convex decomposition of an outline into pieces, between which contact is decided.
//
//   const ConvexPieces pieces = convex_pieces(outline);            // once per outline
//   const ConvexPieces rotated = turned_pieces(pieces, turned(outline, 37.5));
//   for (std::size_t p = 0; p < pieces.count(); ++p)
//     pieces.corners(p), pieces.inner(p), pieces.bounds(p);
//
// Every piece is a counterclockwise ring of at least three corners that turns left or goes straight on at
// each corner, by exact signs. Pieces meet only at their boundaries, and their union is exactly the region;
// every corner is one of the outline's. An edge of a piece is inner if it is a cut: a path that leaves the
// piece through it enters another piece. Readers of pieces need no special cases for holes, parts, or rings
// that touch.
//
// One sweep triangulates (S. Hertel, K. Mehlhorn, "Fast triangulation of the plane with respect to simple
// polygons", Information and Control 64, 1985). Then each cut between two pieces with a convex union is
// removed, which gives at most four times the minimal number of pieces. Cost: n log n, about half a
// microsecond per corner; turned_pieces() takes a tenth of that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "shape/outline/box_tree.h"
#include "shape/outline/outline.h"

namespace foresee {

class ConvexPieces {
 public:
  /// The corners of each piece, by index: the same for all headings of an outline.
  struct Cut {
    std::vector<std::uint32_t> corners;  ///< of all pieces, by their indices in the outline
    std::vector<std::uint8_t> inner;     ///< whether the edge from each corner to the next is a cut
    std::vector<std::uint32_t> ends;     ///< end index of each piece in `corners`
    std::vector<bool> counterclockwise;  ///< per ring of the outline
    std::size_t outline_corners = 0;     ///< number of corners of the outline
  };

  ConvexPieces() = default;
  /// Requires: `cut` has indices of `corners`, and its pieces are in an order for a tree.
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
  /// In bytes, without the cut.
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

/// The pieces of `turned`, the outline of `pieces` after a rotation. Requires: it is valid. The same cut is
/// used if every piece is still convex and every ring keeps its direction. Then the pieces have winding
/// number 1 around each point of the region and 0 elsewhere, because the rings, whose sum they are, do.
/// Otherwise rounding has moved a corner across an edge, and the outline is cut again.
ConvexPieces turned_pieces(const ConvexPieces& pieces, const Outline& turned);

/// The side of a triangle from a corner to the next.
struct TriangleSide {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t corner;       ///< index in the outline, of this corner or of an equal one
  std::uint32_t twin = none;  ///< the side of the triangle beyond; none: the side lies on the outline
};

/// Triangulation of an outline by one plane sweep: sides 3 t, 3 t + 1 and 3 t + 2 are those of triangle t,
/// counterclockwise. It adds no corner, and no triangle is flat. Cost: n log n, some 300 ns per corner. Requires: a
/// valid outline (validity.h).
std::vector<TriangleSide> triangulation(const Outline& outline);

}  // namespace foresee
