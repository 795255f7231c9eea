// Where does a mesh lie that is turned? As a flat outline does (outline/outline_rotation.h), in x and y; z stays.
//
//   Mesh rotated = turned(building, 37.5);         // degrees clockwise from the y axis, around the z axis
//
// Cost: a microsecond a mesh, some 40 ns a corner.
#pragma once

#include "shape/mesh/mesh.h"

namespace foresee {

/// The same triangles between the turned corners. Throws Error where a corner is beyond the largest double.
/// Whether its triangles are some still, mesh_check.h tells. Requires: -360 <= heading <= 360.
Mesh turned(const Mesh& mesh, double heading);

}  // namespace foresee
