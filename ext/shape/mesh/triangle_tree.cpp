#include "shape/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foresee {
namespace {

/// Union-find over corners: connected components of the mesh. Each corner names another of its component, or
/// itself.
class Parts {
 public:
  explicit Parts(std::size_t corners) : next_(corners) { std::iota(next_.begin(), next_.end(), 0); }

  std::uint32_t first_of(std::uint32_t corner) {
    while (next_[corner] != corner) corner = next_[corner] = next_[next_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) { next_[first_of(b)] = first_of(a); }

 private:
  std::vector<std::uint32_t> next_;
};

/// A bit for each corner and edge of each triangle that owns it: the first triangle that has it.
std::vector<std::uint8_t> owned_of(std::span<const Triangle> triangles, std::size_t corners) {
  std::vector<std::uint8_t> owned(triangles.size());
  const auto own = [&](std::size_t t, std::size_t bit) { owned[t] |= static_cast<std::uint8_t>(1 << bit); };
  std::vector<bool> is_owned(corners);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_owned[triangles[t][i]]) own(t, i);
      is_owned[triangles[t][i]] = true;
    }
  const std::vector<NamedEdge> edges = sorted_edges(triangles);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (i == 0 || !edges[i].joins_same(edges[i - 1])) own(edges[i].place / 3, 3 + edges[i].place % 3);
  return owned;
}

std::vector<std::uint32_t> part_corners_of(std::span<const Triangle> triangles, std::size_t corners) {
  Parts parts(corners);
  for (const Triangle& triangle : triangles) {
    parts.join(triangle[0], triangle[1]);
    parts.join(triangle[0], triangle[2]);
  }
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t corner = 0; corner < corners; ++corner)
    if (parts.first_of(corner) == corner) firsts.push_back(corner);
  return firsts;
}

Box<3> box_around(const Triangle& triangle, std::span<const SpaceCorner> corners) {
  Box<3> box = Box<3>::empty();
  for (const std::uint32_t i : triangle)
    box.lower = box.lower.min(place_of(corners[i])), box.upper = box.upper.max(place_of(corners[i]));
  return box;
}

BoxTree<3> tree_of(std::span<const Triangle> triangles, std::span<const SpaceCorner> corners) {
  std::vector<Box<3>> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles) boxes.push_back(box_around(triangle, corners));
  return BoxTree<3>(boxes);
}

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
    turn(disc.middle);
    turn(disc.normal);
    disc.half = static_cast<float>(disc.half + slack_);
    disc.radius = static_cast<float>(disc.radius + slack_);
  }
  take_boxes(tree);
}

TriangleTree::TriangleTree(const Mesh& mesh)
    : corners_(mesh.corners().begin(), mesh.corners().end()), solid_(mesh.is_solid()) {
  std::vector<Box<3>> boxes;
  boxes.reserve(mesh.triangles().size());
  for (const Triangle& triangle : mesh.triangles()) boxes.push_back(box_around(triangle, corners_));
  auto links = std::make_shared<Links>();
  for (const std::uint32_t t : tree_order<3>(boxes)) links->triangles.push_back(mesh.triangles()[t]);
  links->owned = owned_of(links->triangles, corners_.size());
  links->part_corners = part_corners_of(links->triangles, corners_.size());
  tree_ = tree_of(links->triangles, corners_);
  discs_ = BoundingDiscs(tree_, links->triangles, corners_);
  links_ = std::move(links);
}

TriangleTree::TriangleTree(const TriangleTree& known, const Mesh& turned)
    : links_(known.links_),
      corners_(turned.corners().begin(), turned.corners().end()),
      tree_(tree_of(links_->triangles, corners_)),
      discs_(known.discs_, known.corners_, tree_, corners_),
      solid_(known.solid_) {}

}  // namespace foresee
