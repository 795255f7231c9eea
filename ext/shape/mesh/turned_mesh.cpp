#include "shape/mesh/turned_mesh.h"

#include "base/float_environment.h"
#include "shape/outline/outline_rotation.h"

namespace foresee {

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
