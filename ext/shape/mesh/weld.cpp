#include "shape/mesh/weld.h"

#include <algorithm>
#include <numeric>
#include <tuple>

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

/// An edge of one triangle.
struct NamedEdge {
  std::uint32_t lower, upper, place;  ///< the two corners; place: 3 * triangle + number of the edge

  bool joins_same(const NamedEdge& other) const { return lower == other.lower && upper == other.upper; }
  friend auto operator<=>(const NamedEdge&, const NamedEdge&) = default;
};

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

}  // namespace

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

std::optional<std::array<std::uint32_t, 2>> equal_corners_of(std::span<const SpaceCorner> corners) {
  const std::vector<std::uint32_t> firsts = first_equals(corners);
  for (std::uint32_t i = 0; i < firsts.size(); ++i)
    if (firsts[i] != i) return std::array{firsts[i], i};
  return std::nullopt;
}

}  // namespace foresee
