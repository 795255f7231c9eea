#include "contact/mesh/mesh_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace foresee::testing_by_hand {
namespace {

/// Two triangles; corners in turn.
void add_face(Triangles& triangles, const SpaceCorner& a, const SpaceCorner& b, const SpaceCorner& c,
              const SpaceCorner& d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

/// The side between two corners of a ring.
void add_wall(Triangles& triangles, const Corner& p, const Corner& q, double lower, double upper) {
  add_face(triangles, {p.x, p.y, lower}, {q.x, q.y, lower}, {q.x, q.y, upper}, {p.x, p.y, upper});
}

/// As a number, so that sums of several have no sign of their own.
SpaceCorner plain(const SpaceCorner& corner) {
  return {corner.x + 0.0, corner.y + 0.0, corner.z + 0.0};
}

}  // namespace

Mesh mesh_of(Mesh::Kind kind, const Triangles& triangles) {
  std::vector<SpaceCorner> corners;
  const auto number_of = [&](const SpaceCorner& corner) {
    const auto found = std::find(corners.begin(), corners.end(), corner);
    const auto number = static_cast<std::uint32_t>(found - corners.begin());
    if (found == corners.end()) corners.push_back(plain(corner));
    return number;
  };
  std::vector<Triangle> numbered;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : triangles) {
    numbered.push_back({number_of(triangle[0]), number_of(triangle[1]), number_of(triangle[2])});
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[std::minmax(numbered.back()[i], numbered.back()[(i + 1) % 3])];
  }
  const bool closed = std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 2; });
  return Mesh(kind, closed, corners, numbered);
}

Mesh solid_of(const Triangles& triangles) {
  return mesh_of(Mesh::Kind::solid, triangles);
}
Mesh surface_of(const Triangles& triangles) {
  return mesh_of(Mesh::Kind::surface, triangles);
}

bool have_area(const Triangles& triangles) {
  return std::none_of(triangles.begin(), triangles.end(), [](const auto& t) {
    const Vec<3> p = place_of(t[0]), e = place_of(t[1]) - p, f = place_of(t[2]) - p;
    return e[0] * f[1] == e[1] * f[0] && e[1] * f[2] == e[2] * f[1] && e[2] * f[0] == e[0] * f[2];
  });
}

Triangles box_between(const SpaceCorner& lower, const SpaceCorner& upper) {
  return prism({{lower.x, lower.y}, {upper.x, lower.y}, {upper.x, upper.y}, {lower.x, upper.y}},
               {lower.x, lower.y}, lower.z, upper.z);
}

Triangles prism(const std::vector<Corner>& ring, const Corner& middle, double lower, double upper) {
  Triangles triangles;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &p = ring[i], &q = ring[(i + 1) % ring.size()];
    add_wall(triangles, p, q, lower, upper);
    if (p == middle || q == middle) continue;
    for (const double z : {lower, upper})
      triangles.push_back({{{middle.x, middle.y, z}, {p.x, p.y, z}, {q.x, q.y, z}}});
  }
  return triangles;
}

Triangles frame(double inner, double outer, double lower, double upper) {
  static constexpr Corner square[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto at = [](const Corner& c, double size) -> Corner { return {size * c.x, size * c.y}; };
  Triangles triangles;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &c = square[i], &d = square[(i + 1) % 4];
    const Corner p = at(c, inner), q = at(d, inner), r = at(d, outer), s = at(c, outer);
    add_wall(triangles, p, q, lower, upper);
    add_wall(triangles, r, s, lower, upper);
    for (const double z : {lower, upper})
      add_face(triangles, {p.x, p.y, z}, {q.x, q.y, z}, {r.x, r.y, z}, {s.x, s.y, z});
  }
  return triangles;
}

Triangles together(std::initializer_list<Triangles> parts) {
  Triangles all;
  for (const Triangles& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Triangles shifted(Triangles triangles, const SpaceCorner& by) {
  for (auto& triangle : triangles)
    for (SpaceCorner& c : triangle) c = {c.x + by.x, c.y + by.y, c.z + by.z};
  return triangles;
}

SpaceCorner globe_corner(int meridian, int meridians, int ring, int rings, double radius) {
  const double around = 2 * M_PI * meridian / meridians, down = M_PI * ring / (rings + 1);
  return {radius * std::sin(down) * std::cos(around), radius * std::sin(down) * std::sin(around),
          radius * std::cos(down)};
}

}  // namespace foresee::testing_by_hand
