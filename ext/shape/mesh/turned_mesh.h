// Rotates a mesh about the z axis, with correctly rounded coordinates (outline/outline_rotation.h).
//
//   Mesh rotated = turned(building, 37.5);         // degrees clockwise from the y axis, around the z axis
//
// Cost: a microsecond per mesh, some 40 ns per corner.
#pragma once

#include "shape/mesh/mesh.h"

namespace foresee {

/// The same triangles between the rotated corners. Throws Error if a corner is beyond the largest double. The
/// result may be invalid: check it (mesh_check.h). Requires: -360 <= heading <= 360.
Mesh turned(const Mesh& mesh, double heading);

}  // namespace foresee
