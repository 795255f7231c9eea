// Scenes of moving outlines, from fixed seeds: two fleets each, for the pairs of both that touch.
//
//   const OutlineScene scene = ships(400);                 // two fleets of 400
//   const std::vector<Pair> pairs = candidates(scene, 20000);
#pragma once

#include <vector>

#include "base/pair.h"
#include "shape/bodies.h"
#include "shape/form_rows.h"
#include "shape/outline/convex_pieces.h"

namespace foresee::bench {

/// Objects that move uniformly, each with an outline; or points.
struct OutlineFleet final : OutlineRows {
  std::vector<double> rows;
  std::vector<Outline> outlines;
  std::vector<ConvexPieces> cut;

  const ConvexPieces* pieces(std::size_t row, ScratchPieces<ConvexPieces>&) const override {
    return cut.empty() ? nullptr : &cut[row];
  }
  Bodies bodies() const { return {{.axes = 2, .law = Law::uniform}, rows.data(), rows.size() / 4}; }
};

struct OutlineScene {
  const char* name;
  OutlineFleet a, b;
  double h;
  double within = 0;
};

/// Hulls of 5 to 11 corners, some of which lie inward, along random courses: 60 to 300 m over 600 s.
OutlineScene ships(std::size_t count);
/// Stars of 100 corners over 60 s.
OutlineScene stars(std::size_t count);
/// One such star, and points.
OutlineScene points_and_a_star(std::size_t count);

/// The pairs whose swept boxes intersect, at most `max_pairs`.
std::vector<Pair> candidates(const OutlineScene& scene, std::size_t max_pairs);

}  // namespace foresee::bench
