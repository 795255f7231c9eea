// A mesh of its own: triangles in space, a surface or a solid; with r it is grown on all sides. What has no
// mesh is what its radius says: a point or a ball.
//
// A row knows the number of its mesh and the smallest box around it as it lies (mesh/turned_mesh.h), so that
// who only needs boxes looks no mesh up.
#pragma once

#include "shape/size_column.h"
#include "shape/stored_bounds.h"

namespace foresee {

struct MeshShape {
  static constexpr Shape shape = Shape::mesh;
  static constexpr SizeColumn sizes[] = {radius_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    return extents_of_bounds<D, 3>(numbers, at);
  }
  /// None: nothing need be inside a surface.
  template <int D>
  static Extents<D> core(const double* /*numbers*/, const Offsets& /*at*/) {
    return no_extents<D>();
  }
};

}  // namespace foresee
