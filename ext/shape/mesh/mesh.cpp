#include "shape/mesh/mesh.h"

namespace foresee {

Extents<3> Mesh::extents() const {
  const Vec<3> first = place_of(corners_[0]);
  Extents<3> around{first, first};
  for (const SpaceCorner& corner : corners_) {
    around.lower = around.lower.min(place_of(corner)), around.upper = around.upper.max(place_of(corner));
  }
  return around;
}

}  // namespace foresee
