#include "shape/mesh/triangle_tree.h"

#include <algorithm>
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

/// A corner or an edge of one triangle.
struct Side {
  std::uint32_t from, to, place;  ///< place: 3 * triangle + number of the side

  friend auto operator<=>(const Side&, const Side&) = default;
};

/// Assigns each corner or edge to the first triangle that has it.
void own_first(std::vector<Side>& sides, int first_bit, std::vector<std::uint8_t>& owned) {
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && sides[i].from == sides[i - 1].from && sides[i].to == sides[i - 1].to) continue;
    owned[sides[i].place / 3] |= static_cast<std::uint8_t>(1 << (first_bit + sides[i].place % 3));
  }
}

std::vector<std::uint8_t> owned_of(std::span<const Triangle> triangles) {
  std::vector<std::uint8_t> owned(triangles.size());
  std::vector<Side> corners, edges;
  corners.reserve(3 * triangles.size()), edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t here = triangles[t][i], next = triangles[t][(i + 1) % 3];
      corners.push_back({here, here, 3 * t + i});
      edges.push_back({std::min(here, next), std::max(here, next), 3 * t + i});
    }
  own_first(corners, 0, owned);
  own_first(edges, 3, owned);
  return owned;
}

std::vector<std::uint32_t> part_corners_of(std::span<const Triangle> triangles, std::size_t corners) {
  Parts parts(corners);
  for (const Triangle& triangle : triangles)
    parts.join(triangle[0], triangle[1]), parts.join(triangle[0], triangle[2]);
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

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh)
    : corners_(mesh.corners().begin(), mesh.corners().end()), solid_(mesh.is_solid()) {
  std::vector<Box<3>> boxes;
  boxes.reserve(mesh.triangles().size());
  for (const Triangle& triangle : mesh.triangles()) boxes.push_back(box_around(triangle, corners_));
  auto links = std::make_shared<Links>();
  for (const std::uint32_t t : tree_order<3>(boxes)) links->triangles.push_back(mesh.triangles()[t]);
  links->owned = owned_of(links->triangles);
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
