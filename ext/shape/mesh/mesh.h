// Triangle mesh around an object's position: a surface, or the solid that a closed surface encloses.
//
//   Mesh roof(Mesh::Kind::surface, false, {{0, 0, 3}, {4, 0, 3}, {0, 5, 4}}, {{0, 1, 2}});
//
// Triangles may run either way round, touch and intersect. A surface is closed if each edge belongs to
// exactly two triangles. The solid is the set of points that an odd number of its triangles enclose, and
// includes its surface (even-odd rule). The position need not lie within.
//
// A mesh holds what was written and is immutable: many rows and statements share one. mesh_check.h checks
// that the triangles have an area and that a solid is closed; all else here may rely on it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/axis_aligned_box.h"

namespace foresee {

/// Finite, and never -0.
struct SpaceCorner {
  double x, y, z;

  friend bool operator==(const SpaceCorner&, const SpaceCorner&) = default;
};

inline Vec<3> place_of(const SpaceCorner& corner) {
  return Vec<3>(corner.x, corner.y, corner.z);
}

/// Indices of its corners among those of the mesh.
using Triangle = std::array<std::uint32_t, 3>;

/// The maximum number of triangles of a mesh.
constexpr std::size_t max_triangles = 65536;

class Mesh {
 public:
  enum class Kind : std::uint8_t {
    surface,  ///< TIN Z: has no inside; an object below it does not touch it
    solid,    ///< POLYHEDRALSURFACE Z: closed
    parts     ///< MULTIPOLYGON Z: a solid if it is closed, else a surface
  };

  Mesh() = default;
  /// `closed`: each edge belongs to exactly two triangles. Requires: at least one triangle; each corner
  /// belongs to one. No two corners are equal, unless a rotation has merged them (mesh_check.h).
  Mesh(Kind kind, bool closed, std::vector<SpaceCorner> corners, std::vector<Triangle> triangles)
      : kind_(kind), closed_(closed), corners_(std::move(corners)), triangles_(std::move(triangles)) {}

  Kind kind() const { return kind_; }
  bool is_solid() const { return closed_ && kind_ != Kind::surface; }
  std::span<const SpaceCorner> corners() const { return corners_; }
  std::span<const Triangle> triangles() const { return triangles_; }
  /// The same triangles with new coordinates of the corners. Requires: as many corners.
  Mesh with_corners(std::vector<SpaceCorner> corners) const {
    return Mesh(kind_, closed_, std::move(corners), triangles_);
  }
  /// The bounding box relative to the position.
  Extents<3> extents() const;

  friend bool operator==(const Mesh&, const Mesh&) = default;

 private:
  Kind kind_ = Kind::surface;
  bool closed_ = false;
  std::vector<SpaceCorner> corners_;
  std::vector<Triangle> triangles_;
};

// Rotates a mesh about the z axis, with correctly rounded coordinates (outline/outline_rotation.h).
//
//   Mesh rotated = turned(building, 37.5);         // degrees clockwise from the y axis, around the z axis
//
// Cost: a microsecond per mesh, some 40 ns per corner.

/// The same triangles between the rotated corners. Throws Error if a corner is beyond the largest double. The
/// result may be invalid: check it (mesh_check.h). Requires: -360 <= heading <= 360.
Mesh turned(const Mesh& mesh, double heading);

}  // namespace foresee
