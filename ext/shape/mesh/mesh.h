// Triangle mesh around an object's position: a surface, or the solid that a closed surface encloses.
//
//   Mesh roof(Mesh::Kind::surface, false, {{0, 0, 3}, {4, 0, 3}, {0, 5, 4}}, {{0, 1, 2}});
//
// Triangles may run either way round, touch and intersect. A surface is closed if each edge belongs to
// exactly two triangles. The solid is the set of points that an odd number of its triangles enclose, and
// includes its surface (even-odd rule). The position need not lie within.
//
//   Mesh tent = welded(Mesh::Kind::surface, {{0, 0, 0}, {4, 0, 0}, {2, 5, 3},
//                                            {4, 0, 0}, {0, 0, 0}, {2, -5, 3}});
//   check_mesh(tent);                          // throws Error: "face 2 (0 0 0, 1 0 0, 2 0 0) has no area: …"
//   Mesh rotated = turned(tent, 37.5);         // degrees clockwise from the y axis, around the z axis
//   check_turned(tent, rotated, 37.5);
//
// A mesh holds what was written and is immutable: many rows and statements share one. check_mesh() checks
// that the triangles have an area and that a solid is closed; all else here may rely on it.
#pragma once

#include <array>
#include <compare>
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
  /// belongs to one. No two corners are equal, unless a rotation has merged them (check_turned).
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

/// An edge of one triangle.
struct NamedEdge {
  std::uint32_t lower, upper, place;  ///< the two corners; place: 3 * triangle + number of the edge

  bool joins_same(const NamedEdge& other) const { return lower == other.lower && upper == other.upper; }
  friend auto operator<=>(const NamedEdge&, const NamedEdge&) = default;
};

/// The edges of all triangles, sorted: those that join the same corners follow each other by place.
std::vector<NamedEdge> sorted_edges(std::span<const Triangle> triangles);

/// Welds a triangle soup into a mesh: equal corners become one, so that the triangles are connected. Corners are
/// numbered in the order of their first use, so that equal triangles in the same order give equal meshes.
/// `corners`: three per triangle; -0 becomes 0. Requires: finite numbers, at least one triangle. Cost: n log n,
/// some 200 ns per triangle.
Mesh welded(Mesh::Kind kind, std::vector<SpaceCorner> corners);

/// The mesh rotated about the z axis, with correctly rounded coordinates (outline/outline_rotation.h). Throws
/// Error if a corner is beyond the largest double. The result may be invalid: check it. Requires:
/// -360 <= heading <= 360. Cost: a microsecond per mesh, some 40 ns per corner.
Mesh turned(const Mesh& mesh, double heading);

// Validity of a mesh. Every triangle has an area, by exact signs, and each edge of a POLYHEDRALSURFACE belongs to
// exactly two: an edge that was not welded would make a solid hollow. Triangles may touch and intersect. The
// same on every machine. Cost: n log n; some 10 ns per triangle, after a rotation some 100 ns per corner.

/// Whether check_mesh() accepts it.
bool is_sound(const Mesh& mesh);

/// Throws Error, which says what is wrong and where, for the author of the mesh. Requires: a welded mesh.
void check_mesh(const Mesh& mesh);

/// The same for `turned`, the sound `mesh` rotated by `heading` degrees: rounding may take away the area of a
/// triangle, or merge two corners.
void check_turned(const Mesh& mesh, const Mesh& turned, double heading);

}  // namespace foresee
