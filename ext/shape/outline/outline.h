// What is a flat shape around the position of its object? Parts, each a ring of corners that encloses it and
// rings that are its holes.
//
//   Outline hull;                                          // POLYGON((-8 -90, 8 -90, 0 90, -8 -90))
//   hull.begin_part();
//   for (const Corner& corner : {Corner{-8, -90}, Corner{8, -90}, Corner{0, 90}}) hull.add(corner);
//   hull.ring(0).size() == 3                               // the first corner does not come again at the end
//   hull.extents().lower[1] == -90
//
// The region is closed: rings and what they enclose, without what holes enclose, but with the holes' rings.
// Rings may run either way round. The position need not lie within, nor in the middle. An outline is made
// ring by ring and then only read: many rows and statements share one.
//
// An outline holds what was written. Whether its rings are rings, and lie as rings must, says validity.h; all
// else here may rely on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/box.h"

namespace foresee {

/// Finite, and never -0.
struct Corner {
  double x, y;

  friend bool operator==(const Corner&, const Corner&) = default;
};

/// As many corners an outline may have, closing ones not counted.
constexpr std::size_t max_corners = 65536;

class Outline {
 public:
  /// The next ring encloses a new part; it has begun.
  void begin_part();
  /// A hole of the last part begins.
  void begin_hole();
  /// The next corner of the last ring. One that repeats the corner before it is dropped.
  void add(const Corner& corner);
  /// Drops the last corner of the last ring if it repeats the first. Whether it did.
  bool close_ring();

  /// All corners, ring after ring.
  std::span<const Corner> corners() const { return corners_; }
  std::size_t rings() const { return ring_ends_.size(); }
  std::size_t parts() const { return part_starts_.size(); }
  std::span<const Corner> ring(std::size_t r) const {
    return corners().subspan(ring_start(r), ring_ends_[r] - ring_start(r));
  }
  /// Where the corners of ring r begin among all.
  std::size_t ring_start(std::size_t r) const { return r == 0 ? 0 : ring_ends_[r - 1]; }
  /// The rings of part p are those from the first of this part to the first of the next; the first encloses
  /// it.
  std::size_t part_start(std::size_t p) const { return p == parts() ? rings() : part_starts_[p]; }

  /// The smallest box around it, seen from the position. Requires: a corner.
  Extents<2> extents() const;

  friend bool operator==(const Outline&, const Outline&) = default;

 private:
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> ring_ends_;    ///< where the corners of each ring end
  std::vector<std::uint32_t> part_starts_;  ///< the first ring of each part
};

}  // namespace foresee
