// Tile of a partitioned join: a rectangle that owns pairs by their reference point, so tiles run separately.
//
//   const Tile tile{.x0 = 0, .x1 = 10, .y0 = 0, .y1 = 10};
//   tile.marks(box)  // of one object; a pair whose marks, or-ed, are Tile::owned is the tile's
//
// The reference point of a pair is the low corner of the intersection of its boxes (query/sweep) in x and y:
// the greater of both low ends. A tile owns the pair if that lies in [x0, x1) x [y0, y1). Comparisons of
// doubles are exact and tiles are half-open, so of tiles that cover the plane without overlap exactly one
// owns a pair.
//
// A tile needs the objects whose closed boxes intersect it. Both objects of an owned pair are among them,
// since their boxes share the reference point. Proof in docs/explanation/tiles.md. After Tsitsigkos, Lampropoulos,
// Bouros, Mamoulis, Terrovitis: A Two-layer Partitioning for Non-point Spatial Data (ICDE 2021).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "index/candidates.h"
#include "motion/axis_aligned_box.h"

namespace foresee {

/// A set of bits that describes one object relative to a tile.
using TileMarks = std::uint8_t;

struct Tile {
  static constexpr TileMarks starts_in_x = 1;  ///< its low end is >= x0
  static constexpr TileMarks starts_in_y = 2;
  static constexpr TileMarks unneeded = 4;
  static constexpr TileMarks owned = starts_in_x | starts_in_y;

  // Infinite: no bound, so that the outermost tiles own infinite corners too.
  double x0 = -std::numeric_limits<double>::infinity(), x1 = std::numeric_limits<double>::infinity();
  double y0 = -std::numeric_limits<double>::infinity(), y1 = std::numeric_limits<double>::infinity();

  friend bool operator==(const Tile&, const Tile&) = default;

  /// The marks of an object with this box; an object with an empty box is not needed.
  template <int D>
  TileMarks marks(const Box<D>& box) const {
    bool meets = box.lower[0] < x1 && box.upper[0] >= x0, in_y = true;
    if constexpr (D > 1) {
      meets &= box.lower[1] < y1 && box.upper[1] >= y0;
      in_y = box.lower[1] >= y0;
    }
    return static_cast<TileMarks>((box.lower[0] >= x0 ? starts_in_x : 0) | (in_y ? starts_in_y : 0) |
                                  (meets ? 0 : unneeded));
  }

  /// The closed tile: the box of every needed object intersects it.
  template <int D>
  Box<D> closed() const {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Box<D> box{Vec<D>::constant(-inf), Vec<D>::constant(inf)};
    box.lower[0] = x0, box.upper[0] = x1;
    if constexpr (D > 1) box.lower[1] = y0, box.upper[1] = y1;
    return box;
  }
};

// Filter of candidates by the tile that owns them: one byte per object, one operation per candidate.
//
//   auto candidates = owned_candidates(make_gpcd_grid<2>(boxes, nullptr, interrupt), ownership);
//
// Guarantee: returns exactly the inner candidates that the tile owns, in their order.

/// Marks of the objects of both sides, by row number.
struct Ownership {
  std::vector<TileMarks> a, b;             ///< b: empty where both sides are one scene
  std::size_t needed_a = 0, needed_b = 0;  ///< number of needed objects
};

std::unique_ptr<Candidates> owned_candidates(std::unique_ptr<Candidates> all,
                                             std::shared_ptr<const Ownership> ownership);
std::unique_ptr<DividedCandidates> owned_candidates(std::unique_ptr<DividedCandidates> all,
                                                    std::shared_ptr<const Ownership> ownership);

}  // namespace foresee
