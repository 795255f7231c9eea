#include "contact/mesh/draw_mesh.h"

#include <cmath>

namespace foresee::testing_by_hand {

double DrawMesh::number(double range) {
  const double any = std::uniform_real_distribution<double>(-range, range)(random_);
  return family_.whole ? std::round(2 * any) / 2 : any;
}

Mesh DrawMesh::mesh(bool is_a) {
  switch (family_.cast) {
    case MeshFamily::Cast::boxes:
      return solid_of(boxes());
    case MeshFamily::Cast::terrain:
      return is_a ? surface_of(ground()) : solid_of(below(2) ? tetrahedron() : box(2));
    case MeshFamily::Cast::nested:
      return solid_of(is_a ? hollow() : below(2) ? tetrahedron() : box(1));
    case MeshFamily::Cast::slivers:
      if (below(2)) return surface_of({sliver(), sliver(), triangle()});
      return solid_of(below(4) ? flat_tetrahedron() : tetrahedron());
    case MeshFamily::Cast::many:
      if (!is_a) return solid_of(globe(5, 2, [this] { return above(1, 1); }));
      if (below(2)) return solid_of(globe(12, 8, [this] { return above(2, 1); }));
      return surface_of(shifted(terrain(10, 10, 1, [this] { return number(1); }), {-5, -5, 0}));
    case MeshFamily::Cast::any:
      break;
  }
  return any_mesh();
}

Mesh DrawMesh::any_mesh() {
  switch (below(12)) {
    case 0:
      return surface_of({triangle()});
    case 1:
      return surface_of({triangle(), triangle(), triangle()});
    case 2:
      return surface_of(ground());
    case 3:
      return surface_of(box(4));
    case 4:
      return solid_of(hollow());
    case 5:
      return solid_of(boxes());
    case 6:
      return solid_of(l_shaped());
    case 7:
      return solid_of(star());
    case 8:
      return solid_of(below(4) ? octahedron() : ball());
    case 9: {
      const SpaceCorner apart = place(6);
      return mesh_of(Mesh::Kind::parts, together({tetrahedron(), shifted(tetrahedron(), apart)}));
    }
    case 10: {  // both sides of one triangle
      const auto one = triangle();
      return solid_of({one, one});
    }
    default:
      return solid_of(tetrahedron());
  }
}

std::array<SpaceCorner, 3> DrawMesh::triangle() {
  while (true) {
    const std::array<SpaceCorner, 3> t{place(4), place(4), place(4)};
    if (have_area({t})) return t;
  }
}

Triangles DrawMesh::tetrahedron() {
  while (true) {
    const SpaceCorner p = place(4), q = place(4), r = place(4), s = place(4);
    const Triangles faces{{p, q, r}, {p, q, s}, {p, r, s}, {q, r, s}};
    if (have_area(faces)) return faces;
  }
}

std::array<SpaceCorner, 3> DrawMesh::sliver() {
  while (true) {
    std::array<SpaceCorner, 3> t = triangle();
    t[2] = {between(t[0].x, t[1].x), between(t[0].y, t[1].y), between(t[0].z, t[1].z)};
    if (have_area({t})) return t;
  }
}

double DrawMesh::between(double a, double b) {
  const double middle = a + static_cast<double>(below(5)) / 4 * (b - a);
  return below(2) ? middle : std::nextafter(middle, below(2) ? 9 : -9);
}

Triangles DrawMesh::flat_tetrahedron() {
  while (true) {
    const SpaceCorner p = place(4), q = place(4), r = place(4);
    const SpaceCorner s{between(p.x, (q.x + r.x) / 2), between(p.y, (q.y + r.y) / 2),
                        between(p.z, (q.z + r.z) / 2)};
    const Triangles faces{{p, q, r}, {p, q, s}, {p, r, s}, {q, r, s}};
    if (have_area(faces)) return faces;
  }
}

Triangles DrawMesh::box(double range) {
  const SpaceCorner lower = place(2);
  return box_between(lower,
                     {lower.x + above(0.5, range), lower.y + above(0.5, range), lower.z + above(0.5, range)});
}

Triangles DrawMesh::boxes() {
  const double w = above(0.5, 2), x = number(2), y = number(2), z = number(2), up = above(0.5, 2);
  const Triangles lower = box_between({x, y, z}, {x + 2 * w, y + 2 * w, z + 2 * w});
  switch (below(4)) {
    case 0:  // stacked
      return together(
          {lower, box_between({x + w / 2, y + w / 2, z + 2 * w}, {x + w, y + w, z + 2 * w + up})});
    case 1:  // side by side
      return together({lower, box_between({x + 2 * w + 1, y, z}, {x + 3 * w + 1, y + w, z + w})});
    case 2:  // crossing: where both are there is nothing
      return together(
          {lower, box_between({x + w, y + w / 2, z + w / 2}, {x + 3 * w, y + 3 * w / 2, z + 3 * w / 2})});
    default:
      return lower;
  }
}

Triangles DrawMesh::l_shaped() {
  const double x = number(2), y = number(2), w = above(1, 2), z = number(2);
  const Corner reflex{x + w, y + w};
  return prism({{x, y}, {x + 2 * w, y}, {x + 2 * w, y + w}, reflex, {x + w, y + 3 * w}, {x, y + 3 * w}},
               reflex, z, z + above(1, 2));
}

Triangles DrawMesh::star() {
  const int corners = static_cast<int>(6 + 2 * below(3));
  std::vector<Corner> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, r = (i % 2 == 0 ? 3 : 1) + above(0, 1);
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const double z = number(2);
  return prism(ring, {0, 0}, z, z + above(1, 2));
}

Triangles DrawMesh::octahedron() {
  const double x = above(1, 3), y = above(1, 3), up = above(1, 3);
  const SpaceCorner ring[4] = {{x, 0, 0}, {0, y, 0}, {-x, 0, 0}, {0, -y, 0}};
  Triangles triangles;
  for (int i = 0; i < 4; ++i)
    for (const double z : {up, -up}) triangles.push_back({ring[i], ring[(i + 1) % 4], {0, 0, z}});
  return triangles;
}

Triangles DrawMesh::ball() {
  const int meridians = static_cast<int>(3 + below(6)), rings = static_cast<int>(1 + below(4));
  return globe(meridians, rings, [this] { return above(2, 1.5); });
}

Triangles DrawMesh::ground() {
  const int columns = static_cast<int>(1 + below(3)), rows = static_cast<int>(1 + below(3));
  return shifted(terrain(columns, rows, above(1, 2), [this] { return number(2); }), {-3, -3, 0});
}

Triangles DrawMesh::hollow() {
  const double w = above(0.5, 1);
  const auto cube = [](double size) { return box_between({-size, -size, -size}, {size, size, size}); };
  switch (below(4)) {
    case 0:
      return together({cube(3 * w), cube(2 * w)});
    case 1:
      return together({cube(3 * w), cube(2 * w), cube(w)});
    case 2:
      return frame(w, 3 * w, -w, w);
    default:
      return together({box_between({-4 * w, -4, -4}, {-3 * w, 4, 4}), box_between({-w, -4, -4}, {w, 4, 4}),
                       box_between({2 * w, -4, -4}, {4 * w, 4, 4})});
  }
}

}  // namespace foresee::testing_by_hand
