#include "shape/mesh/bounding_discs.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

using Node = BoxTree<3>::Node;

double dot(const Vec<3>& a, const Vec<3>& b) {
  return (a * b).sum();
}
Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::array<float, 3> floats_of(const Vec<3>& a) {
  return {static_cast<float>(a[0]), static_cast<float>(a[1]), static_cast<float>(a[2])};
}
Vec<3> doubles_of(const std::array<float, 3>& a) {
  return Vec<3>(a[0], a[1], a[2]);
}

/// The reach of the corners below a node.
struct Reach {
  double low = 0, high = 0;  ///< along the normal
  double square = 0;         ///< of the distance from the line along the normal
};

/// The sum of the normals below each node, weighted by area. Normals are flipped where they would cancel,
/// because triangles may run either way round.
std::vector<Vec<3>> normals_of(const BoxTree<3>& tree, std::span<const Triangle> triangles,
                               std::span<const SpaceCorner> corners) {
  const std::size_t count = triangles.size();
  std::vector<Vec<3>> normals(2 * count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec<3> from = place_of(corners[triangles[i][0]]);
    normals[tree.leaf(i)] =
        cross(place_of(corners[triangles[i][1]]) - from, place_of(corners[triangles[i][2]]) - from);
  }
  for (std::size_t node = count - 1; node-- > 0;) {
    const Vec<3>&one = normals[2 * node + 1], &other = normals[2 * node + 2];
    normals[node] = dot(one, other) < 0 ? Vec<3>(one - other) : Vec<3>(one + other);
  }
  return normals;
}

}  // namespace

BoundingDiscs::BoundingDiscs(const BoxTree<3>& tree, std::span<const Triangle> triangles,
                             std::span<const SpaceCorner> corners) {
  const Box<3>& all = tree.box(BoxTree<3>::root);
  const double size = all.lower.abs().max(all.upper.abs()).sum();
  if (!(size > 0x1p-60 && size < 0x1p60)) return;
  slack_ = 0x1p-19 * size;
  const std::vector<Vec<3>> normals = normals_of(tree, triangles, corners);
  discs_.resize(normals.size());
  for (Node node = 0; node < discs_.size(); ++node) {
    const double length = std::sqrt(dot(normals[node], normals[node]));
    const bool is_some = length > 0x1p-200;
    discs_[node].normal = floats_of(is_some ? Vec<3>(normals[node] / length) : Vec<3>(0, 0, 1));
    discs_[node].middle = floats_of(tree.box(node).lower / 2 + tree.box(node).upper / 2);
  }
  std::vector<Reach> reaches(discs_.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t corner : triangles[i])
      for (std::size_t node = tree.leaf(i) + 1; node > 0; node /= 2) {  // and all its ancestors
        const BoundingDisc& disc = discs_[node - 1];
        Reach& reach = reaches[node - 1];
        const Vec<3> gap = place_of(corners[corner]) - doubles_of(disc.middle);
        const double along = dot(gap, doubles_of(disc.normal));
        reach.low = std::min(reach.low, along), reach.high = std::max(reach.high, along);
        reach.square = std::max(reach.square, dot(gap, gap) - (1 - 0x1p-20) * (along * along));
      }
  for (std::size_t node = 0; node < discs_.size(); ++node) {
    BoundingDisc& disc = discs_[node];
    const auto& [low, high, square] = reaches[node];
    disc.middle = floats_of(doubles_of(disc.middle) + (low + high) / 2 * doubles_of(disc.normal));
    disc.half = static_cast<float>((high - low) / 2 + slack_);
    // The slack also covers two squares that cancel: their roots are at most the size of the mesh.
    disc.radius = static_cast<float>(std::sqrt(std::max(square, 0.0) + slack_ * slack_) + slack_);
  }
  take_boxes(tree);
}

void BoundingDiscs::take_boxes(const BoxTree<3>& tree) {
  for (std::size_t node = 0; node < discs_.size(); ++node) {
    const Box<3>& box = tree.box(static_cast<Node>(node));
    discs_[node].lower = floats_of(box.lower - slack_ / 8),
    discs_[node].upper = floats_of(box.upper + slack_ / 8);
    discs_[node].size = static_cast<float>((box.upper - box.lower).sum());
  }
}

BoundingDiscs::BoundingDiscs(const BoundingDiscs& known, std::span<const SpaceCorner> corners,
                             const BoxTree<3>& tree, std::span<const SpaceCorner> turned) {
  const auto from_axis = [](const SpaceCorner& c) { return c.x * c.x + c.y * c.y; };
  const auto farthest = std::max_element(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
    return from_axis(a) < from_axis(b);
  });
  if (!known.are_there() || !(from_axis(*farthest) > 0x1p-900)) return;
  const SpaceCorner &from = *farthest, &to = turned[static_cast<std::size_t>(farthest - corners.begin())];
  const double cosine = (from.x * to.x + from.y * to.y) / from_axis(from);
  const double sine = (from.y * to.x - from.x * to.y) / from_axis(from);
  const auto turn = [&](std::array<float, 3>& a) {
    a = floats_of({a[0] * cosine + a[1] * sine, a[1] * cosine - a[0] * sine, a[2]});
  };
  slack_ = known.slack_;
  discs_ = known.discs_;
  for (BoundingDisc& disc : discs_) {
    turn(disc.middle), turn(disc.normal);
    disc.half = static_cast<float>(disc.half + slack_);
    disc.radius = static_cast<float>(disc.radius + slack_);
  }
  take_boxes(tree);
}

}  // namespace foresee
