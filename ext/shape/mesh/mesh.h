// What is a shape in space around the position of its object? Triangles between corners: a surface, or the
// solid that a closed surface encloses.
//
//   Mesh roof(Mesh::Kind::surface, false, {{0, 0, 3}, {4, 0, 3}, {0, 5, 4}}, {{0, 1, 2}});
//
// Triangles may run either way round, touch and cross. A solid is what an odd number of its triangles lie
// around: with its surface, which is closed as each of its edges is one of exactly two triangles. The
// position need not lie within. A mesh holds what was written and never changes: many rows and statements
// share one. Whether its triangles are some, and whether it is closed, says mesh_check.h; all else here may
// rely on it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/box.h"

namespace foresee {

/// Finite, and never -0.
struct SpaceCorner {
  double x, y, z;

  friend bool operator==(const SpaceCorner&, const SpaceCorner&) = default;
};

inline Vec<3> place_of(const SpaceCorner& corner) {
  return Vec<3>(corner.x, corner.y, corner.z);
}

/// Places of its corners among those of the mesh.
using Triangle = std::array<std::uint32_t, 3>;

/// As many triangles a mesh may have.
constexpr std::size_t max_triangles = 65536;

class Mesh {
 public:
  enum class Kind : std::uint8_t {
    surface,  ///< TIN Z: what is below it does not touch it
    solid,    ///< POLYHEDRALSURFACE Z: closed
    parts     ///< MULTIPOLYGON Z: a solid if it is closed, else a surface
  };

  Mesh() = default;
  /// `closed`: each edge is one of exactly two triangles. Requires: each corner is of a triangle, and there
  /// is a triangle. No corner comes twice, unless a turn has made two one (mesh_check.h).
  Mesh(Kind kind, bool closed, std::vector<SpaceCorner> corners, std::vector<Triangle> triangles)
      : kind_(kind), closed_(closed), corners_(std::move(corners)), triangles_(std::move(triangles)) {}

  Kind kind() const { return kind_; }
  bool is_solid() const { return closed_ && kind_ != Kind::surface; }
  std::span<const SpaceCorner> corners() const { return corners_; }
  std::span<const Triangle> triangles() const { return triangles_; }
  /// The same triangles between other corners, as many.
  Mesh with_corners(std::vector<SpaceCorner> corners) const {
    return Mesh(kind_, closed_, std::move(corners), triangles_);
  }
  /// The smallest box around it, seen from the position.
  Extents<3> extents() const;

  friend bool operator==(const Mesh&, const Mesh&) = default;

 private:
  Kind kind_ = Kind::surface;
  bool closed_ = false;
  std::vector<SpaceCorner> corners_;
  std::vector<Triangle> triangles_;
};

}  // namespace foresee
