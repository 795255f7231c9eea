#include "shape/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "shape/mesh/mesh_text.h"
#include "shape/outline/outline.h"
#include "shape/outline/outline_rotation.h"

namespace foresee {
namespace {

bool before(const SpaceCorner& a, const SpaceCorner& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Indices of the corners, sorted by coordinates and then by index.
std::vector<std::uint32_t> sorted_places(std::span<const SpaceCorner> corners) {
  std::vector<std::uint32_t> places(corners.size());
  std::iota(places.begin(), places.end(), 0);
  std::sort(places.begin(), places.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (before(corners[a], corners[b])) return true;
    return a < b && !before(corners[b], corners[a]);
  });
  return places;
}

/// For each corner, the first index of an equal one.
std::vector<std::uint32_t> first_equals(std::span<const SpaceCorner> corners) {
  const std::vector<std::uint32_t> places = sorted_places(corners);
  std::vector<std::uint32_t> firsts(corners.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool again = i > 0 && corners[places[i]] == corners[places[i - 1]];
    firsts[places[i]] = again ? firsts[places[i - 1]] : places[i];
  }
  return firsts;
}

/// An edge between two corners of a mesh, and the number of triangles that have it.
struct MeshEdge {
  std::uint32_t from, to;
  std::size_t triangles;
};

/// The first edge that does not belong to exactly two triangles; empty: the surface is closed.
std::optional<MeshEdge> open_edge_of(std::span<const Triangle> triangles) {
  const std::vector<NamedEdge> edges = sorted_edges(triangles);
  const NamedEdge* first = nullptr;
  std::size_t count_of_first = 0;
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next =
        std::find_if(edge, edges.end(), [&](const NamedEdge& e) { return !e.joins_same(*edge); });
    if (next - edge != 2 && (!first || edge->place < first->place))
      first = &*edge, count_of_first = static_cast<std::size_t>(next - edge);
    edge = next;
  }
  if (!first) return std::nullopt;
  const Triangle& triangle = triangles[first->place / 3];
  return MeshEdge{triangle[first->place % 3], triangle[(first->place % 3 + 1) % 3], count_of_first};
}

/// The first two corners that are equal; empty for a welded mesh.
std::optional<std::array<std::uint32_t, 2>> equal_corners_of(std::span<const SpaceCorner> corners) {
  const std::vector<std::uint32_t> firsts = first_equals(corners);
  for (std::uint32_t i = 0; i < firsts.size(); ++i)
    if (firsts[i] != i) return std::array{firsts[i], i};
  return std::nullopt;
}

/// Whether the corners are collinear: then their projections to all three planes are.
bool on_one_line(const SpaceCorner& a, const SpaceCorner& b, const SpaceCorner& c) {
  return orientation({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 &&
         orientation({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
         orientation({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

/// The index of the first triangle whose corners are collinear.
std::optional<std::size_t> flat_triangle_of(const Mesh& mesh) {
  const FloatEnvironment environment;
  const auto corners = mesh.corners();
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    const auto [a, b, c] = mesh.triangles()[t];
    if (on_one_line(corners[a], corners[b], corners[c])) return t;
  }
  return std::nullopt;
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

std::vector<NamedEdge> sorted_edges(std::span<const Triangle> triangles) {
  std::vector<NamedEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [lower, upper] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      edges.push_back({lower, upper, 3 * t + i});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

Extents<3> Mesh::extents() const {
  const Vec<3> first = place_of(corners_[0]);
  Extents<3> around{first, first};
  for (const SpaceCorner& corner : corners_) {
    around.lower = around.lower.min(place_of(corner)), around.upper = around.upper.max(place_of(corner));
  }
  return around;
}

Mesh welded(Mesh::Kind kind, std::vector<SpaceCorner> corners) {
  for (SpaceCorner& corner : corners) corner = {corner.x + 0.0, corner.y + 0.0, corner.z + 0.0};
  const std::vector<std::uint32_t> firsts = first_equals(corners);
  std::vector<std::uint32_t> numbers(corners.size());
  std::vector<SpaceCorner> distinct;
  std::vector<Triangle> triangles(corners.size() / 3);
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (firsts[i] == i) {
      numbers[i] = static_cast<std::uint32_t>(distinct.size());
      distinct.push_back(corners[i]);
    }
    triangles[i / 3][i % 3] = numbers[firsts[i]];
  }
  const bool closed = !open_edge_of(triangles);
  return Mesh(kind, closed, std::move(distinct), std::move(triangles));
}

Mesh turned(const Mesh& mesh, double heading) {
  const FloatEnvironment environment;
  Turn turn(heading);
  std::vector<SpaceCorner> corners;
  corners.reserve(mesh.corners().size());
  for (const SpaceCorner& corner : mesh.corners()) {
    const Corner there = finite_turn(turn, {corner.x, corner.y}, heading);
    corners.push_back({there.x, there.y, corner.z});
  }
  return mesh.with_corners(std::move(corners));
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
