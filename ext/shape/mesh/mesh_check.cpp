#include "shape/mesh/mesh_check.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "shape/mesh/mesh_text.h"
#include "shape/outline/orientation_predicate.h"

namespace foresee {

namespace {

/// Whether the corners are collinear: then their projections to all three planes are.
bool on_one_line(const SpaceCorner& a, const SpaceCorner& b, const SpaceCorner& c) {
  return orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 &&
         orientation({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         orientation({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

bool needs_closing(const Mesh& mesh) {
  return mesh.kind() == Mesh::Kind::solid && !mesh.is_solid();
}

std::string shown_edge(const Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  return '(' + shown(mesh.corners()[from]) + ", " + shown(mesh.corners()[to]) + ')';
}

/// "face 2 (0 0 0, 1 0 0, 2 0 0)"
std::string shown_face(const Mesh& mesh, std::size_t t) {
  const auto [a, b, c] = mesh.triangles()[t];
  return "face " + std::to_string(t + 1) + " (" + shown(mesh.corners()[a]) + ", " + shown(mesh.corners()[b]) +
         ", " + shown(mesh.corners()[c]) + ')';
}

}  // namespace

std::optional<std::size_t> flat_triangle_of(const Mesh& mesh) {
  const FloatEnvironment environment;
  const auto corners = mesh.corners();
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    const auto [a, b, c] = mesh.triangles()[t];
    if (on_one_line(corners[a], corners[b], corners[c])) return t;
  }
  return std::nullopt;
}

bool is_sound(const Mesh& mesh) {
  return !flat_triangle_of(mesh) && !needs_closing(mesh);
}

void check_mesh(const Mesh& mesh) {
  if (const auto flat = flat_triangle_of(mesh))
    throw Error(shown_face(mesh, *flat) + " has no area: its corners lie on one line");
  if (!needs_closing(mesh)) return;
  const MeshEdge edge = *open_edge_of(mesh.triangles());
  throw Error("edge " + shown_edge(mesh, edge.from, edge.to) + " belongs to " +
              std::to_string(edge.triangles) + (edge.triangles == 1 ? " triangle" : " triangles") +
              ", in a solid to two: write equal corners with equal numbers, or TIN Z for a surface");
}

void check_turned(const Mesh& mesh, const Mesh& turned, double heading) {
  if (std::fmod(heading, 90) == 0) return;
  const auto fail = [&](const std::string& what) {
    throw Error("turned by " + shown(heading) + " degrees its " + what +
                ": they are closer than doubles resolve");
  };
  if (const auto equal = equal_corners_of(turned.corners()))
    fail("corners " + shown_edge(mesh, (*equal)[0], (*equal)[1]) + " become one");
  if (const auto flat = flat_triangle_of(turned))
    fail(shown_face(mesh, *flat) + " has no area between its corners");
}

}  // namespace foresee
