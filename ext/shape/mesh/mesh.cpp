#include "shape/mesh/mesh.h"

#include "base/float_environment.h"
#include "shape/outline/outline_rotation.h"

namespace foresee {

Extents<3> Mesh::extents() const {
  const Vec<3> first = place_of(corners_[0]);
  Extents<3> around{first, first};
  for (const SpaceCorner& corner : corners_) {
    around.lower = around.lower.min(place_of(corner)), around.upper = around.upper.max(place_of(corner));
  }
  return around;
}

Mesh turned(const Mesh& mesh, double heading) {
  const FloatEnvironment environment;
  Turn turn(heading);
  std::vector<SpaceCorner> corners;
  corners.reserve(mesh.corners().size());
  for (const SpaceCorner& corner : mesh.corners()) {
    const Corner there = finite_turn(turn, {corner.x, corner.y}, heading);
    corners.push_back({there.x, there.y, corner.z});
  }
  return mesh.with_corners(std::move(corners));
}

}  // namespace foresee
