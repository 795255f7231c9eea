// Shapes in space to test with, as lists of triangles: solids convex and not, hollow and of several parts,
// terrain, crossing triangles.
#pragma once

#include <array>
#include <vector>

#include "shape/mesh/mesh.h"
#include "shape/outline/outline.h"

namespace foresee::testing_by_hand {

using Triangles = std::vector<std::array<SpaceCorner, 3>>;

/// Corners that are equal become one.
Mesh mesh_of(Mesh::Kind kind, const Triangles& triangles);
Mesh solid_of(const Triangles& triangles);
Mesh surface_of(const Triangles& triangles);

/// Whether each is more than a line.
bool have_area(const Triangles& triangles);

/// Twelve.
Triangles box_between(const SpaceCorner& lower, const SpaceCorner& upper);
/// What stands on a ring all of which is seen from `middle`, which may be a corner of it.
Triangles prism(const std::vector<Corner>& ring, const Corner& middle, double lower, double upper);
/// A square frame around the z axis: 32 triangles, and a hole through which one can fly.
Triangles frame(double inner, double outer, double lower, double upper);
/// Around the origin: 2 * meridians * rings triangles; `radius_of` is called for each corner. 4 and 1 make an
/// octahedron.
template <class RadiusOf>
Triangles globe(int meridians, int rings, RadiusOf&& radius_of);
/// Squares of two triangles each; `height_of` is called for each corner, row by row.
template <class HeightOf>
Triangles terrain(int columns, int rows, double width, HeightOf&& height_of);

/// Parts of one shape.
Triangles together(std::initializer_list<Triangles> parts);
Triangles shifted(Triangles triangles, const SpaceCorner& by);

/// The place on a ball.
SpaceCorner globe_corner(int meridian, int meridians, int ring, int rings, double radius);

template <class RadiusOf>
Triangles globe(int meridians, int rings, RadiusOf&& radius_of) {
  const SpaceCorner top{0, 0, radius_of()}, bottom{0, 0, -radius_of()};
  std::vector<SpaceCorner> above(static_cast<std::size_t>(meridians), top), ring(above);
  Triangles triangles;
  const auto join = [&](const std::vector<SpaceCorner>& from, const std::vector<SpaceCorner>& to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const std::size_t next = (i + 1) % from.size();
      if (!(to[i] == to[next])) triangles.push_back({from[i], to[i], to[next]});
      if (!(from[i] == from[next])) triangles.push_back({from[i], to[next], from[next]});
    }
  };
  for (int r = 1; r <= rings; ++r, above = ring) {
    for (int m = 0; m < meridians; ++m)
      ring[static_cast<std::size_t>(m)] = globe_corner(m, meridians, r, rings, radius_of());
    join(above, ring);
  }
  join(above, std::vector<SpaceCorner>(above.size(), bottom));
  return triangles;
}

template <class HeightOf>
Triangles terrain(int columns, int rows, double width, HeightOf&& height_of) {
  const auto across = static_cast<std::size_t>(columns) + 1;
  std::vector<SpaceCorner> corners;
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) corners.push_back({x * width, y * width, height_of()});
  Triangles triangles;
  for (std::size_t i = 0; i + across < corners.size(); ++i) {
    if ((i + 1) % across == 0) continue;
    triangles.push_back({corners[i], corners[i + 1], corners[i + across]});
    triangles.push_back({corners[i + 1], corners[i + across], corners[i + across + 1]});
  }
  return triangles;
}

}  // namespace foresee::testing_by_hand
