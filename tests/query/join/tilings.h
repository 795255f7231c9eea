// Random tilings: rectangles that cover the plane without overlap, cut at critical places.
#pragma once

#include <cmath>
#include <vector>

#include "query/sweep/sweep.h"
#include "query/tile/tile.h"
#include "scenes.h"

namespace foresee::testing {

/// The intervals in x and y by which tiles decide; y is empty on one axis.
struct FlatBox {
  double lower[2] = {0, 0}, upper[2] = {0, 0};
};

template <int D>
std::vector<FlatBox> flat_boxes(const Bodies& bodies, const Horizon& horizon, double within) {
  std::vector<FlatBox> boxes;
  for (std::size_t i = 0; i < bodies.count; ++i) {
    const Box<D> box = swept_box<D>(bodies, i, horizon, sweep_margin<D>(within, {}));
    FlatBox& flat = boxes.emplace_back();
    for (int axis = 0; axis < std::min(D, 2); ++axis)
      flat.lower[axis] = box.lower[axis], flat.upper[axis] = box.upper[axis];
  }
  return boxes;
}

/// A place to cut at: a corner, one of its neighbours, or anywhere between two low ends.
inline double cut_of(const std::vector<FlatBox>& boxes, int axis, Random& random) {
  const FlatBox &box = boxes[random.below(boxes.size())], &other = boxes[random.below(boxes.size())];
  const double corner = random.below(3) ? box.lower[axis] : box.upper[axis];
  switch (random.below(5)) {
    case 0:
      return std::nextafter(corner, HUGE_VAL);
    case 1:
      return std::nextafter(corner, -HUGE_VAL);
    case 2:
      return box.lower[axis] / 2 + other.lower[axis] / 2;
    default:
      return corner;
  }
}

inline std::vector<Tile> random_tiling(const std::vector<FlatBox>& boxes, int axes, std::size_t cuts,
                                       Random& random) {
  std::vector<Tile> tiles(1);
  while (cuts-- > 0) {
    Tile& tile = tiles[random.below(tiles.size())];
    const int axis = axes == 1 ? 0 : static_cast<int>(random.below(2));
    const double cut = cut_of(boxes, axis, random);
    double Tile::*const from = axis == 0 ? &Tile::x0 : &Tile::y0;
    double Tile::*const to = axis == 0 ? &Tile::x1 : &Tile::y1;
    if (!std::isfinite(cut) || !(tile.*from < cut && cut < tile.*to)) continue;
    Tile behind = tile;
    tile.*to = cut, behind.*from = cut;
    tiles.push_back(behind);
  }
  return tiles;
}

}  // namespace foresee::testing
