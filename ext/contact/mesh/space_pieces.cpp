#include "contact/mesh/space_pieces.h"

namespace foresee {
namespace {

constexpr SpaceCorner origin{0, 0, 0}, units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

}  // namespace

SpacePiece::SpacePiece(const TriangleTree& triangles, std::size_t triangle)
    : triangles_(&triangles), triangle_(triangle) {
  for (int i = 0; i < 3; ++i)
    edge_vectors_[static_cast<std::size_t>(i)] = {&corner(i), &corner(i == 2 ? 0 : i + 1)};
}

SpacePiece::SpacePiece(const SpaceCorner* corners)
    : box_(corners),
      flat_((corners[0].x == corners[7].x) | (corners[0].y == corners[7].y) << 1 |
            (corners[0].z == corners[7].z) << 2),
      edge_vectors_{{{&origin, &units[0]}, {&origin, &units[1]}, {&origin, &units[2]}}} {}

std::array<int, 2> SpacePiece::edge(int i) const {
  if (!is_box()) return {i, i == 2 ? 0 : i + 1};
  // Along each axis there are four edges, which start at the corners without that axis's bit.
  const int axis = i / 4, one = (axis + 1) % 3, other = (axis + 2) % 3;
  const int from = (i % 2) << one | (i / 2 % 2) << other;
  return {from, from | 1 << axis};
}

void SpacePieces::take_box(const Box<3>& box) {
  triangles_ = nullptr, box_ = box;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const auto at = [&](int axis) { return (i >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis]; };
    corners_[i] = {at(0), at(1), at(2)};
  }
}

}  // namespace foresee
