// First contact of two meshes by a textbook in plain double: every corner of each against every triangle of
// the other, every edge against every edge (C. Ericson, "Real-Time Collision Detection", 2005, sections 5.3.6
// and 5.1.9). At the start it tests whether edges cross triangles or one mesh contains the other.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "agreement.h"
#include "motion/vec.h"
#include "shape/mesh/mesh.h"

namespace foresee::bench {

struct PlainMesh {
  using Place = Vec<3>;

  explicit PlainMesh(const Mesh& mesh)
      : triangles(mesh.triangles().begin(), mesh.triangles().end()), box(mesh.extents()) {
    for (const SpaceCorner& c : mesh.corners()) corners.emplace_back(c.x, c.y, c.z);
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (t[i] < t[(i + 1) % 3]) edges.push_back({t[i], t[(i + 1) % 3]});
  }

  std::vector<Place> corners;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of a closed mesh each once
  Extents<3> box;
};

inline double dot(const Vec<3>& a, const Vec<3>& b) {
  return (a * b).sum();
}

inline Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Seconds until `from`, moving by `run` per second, reaches the triangle; below 0: never, or before.
inline double time_to_triangle(const PlainMesh& mesh, const Triangle& t, const PlainMesh::Place& from,
                               const PlainMesh::Place& run) {
  const PlainMesh::Place &p = mesh.corners[t[0]], u = mesh.corners[t[1]] - p, v = mesh.corners[t[2]] - p;
  const PlainMesh::Place across = cross(run, v), gap = from - p;
  const double volume = dot(u, across);
  if (volume == 0) return never;
  const double along_u = dot(gap, across) / volume;
  if (along_u < 0 || along_u > 1) return never;
  const PlainMesh::Place other = cross(gap, u);
  const double along_v = dot(run, other) / volume;
  if (along_v < 0 || along_u + along_v > 1) return never;
  return dot(v, other) / volume;
}

/// The first time before `first` at which a corner, moved by `at` + t `velocity`, meets a triangle.
inline double first_on_triangle(const PlainMesh& mesh, const PlainMesh& corners, const PlainMesh::Place& at,
                                const PlainMesh::Place& velocity, double first) {
  for (const Triangle& t : mesh.triangles)
    for (const PlainMesh::Place& corner : corners.corners) {
      const double time = time_to_triangle(mesh, t, corner + at, velocity);
      if (time >= 0 && time < first) first = time;
    }
  return first;
}

/// The same of the edges of b, so moved, and those of a.
inline double first_of_edges(const PlainMesh& a, const PlainMesh& b, const PlainMesh::Place& at,
                             const PlainMesh::Place& velocity, double first) {
  for (const auto& edge : a.edges) {
    const PlainMesh::Place p = a.corners[edge[0]], u = a.corners[edge[1]] - p;
    const PlainMesh::Place u_across = cross(velocity, u);
    for (const auto& other : b.edges) {
      const PlainMesh::Place q = b.corners[other[0]] + at, v = b.corners[other[1]] - b.corners[other[0]];
      const double volume = dot(v, u_across);  // of velocity, u and v
      if (volume == 0) continue;
      const PlainMesh::Place gap = p - q;
      const double time = dot(gap, cross(u, v)) / volume;
      if (!(time >= 0 && time < first)) continue;
      const double along_v = dot(gap, u_across) / volume, along_u = dot(gap, cross(velocity, v)) / volume;
      if (along_u >= 0 && along_u <= 1 && along_v >= 0 && along_v <= 1) first = time;
    }
  }
  return first;
}

/// Whether edges of `b`, moved by `at`, cross triangles of `a`.
inline bool any_crossing(const PlainMesh& a, const PlainMesh& b, const PlainMesh::Place& at) {
  for (const Triangle& t : a.triangles)
    for (const auto& edge : b.edges) {
      const PlainMesh::Place& from = b.corners[edge[0]];
      const double along = time_to_triangle(a, t, from + at, b.corners[edge[1]] - from);
      if (along >= 0 && along <= 1) return true;
    }
  return false;
}

inline bool is_within(const PlainMesh& mesh, const PlainMesh::Place& place) {
  const PlainMesh::Place ray(0.3, 0.5, 0.8);
  bool within = false;
  for (const Triangle& t : mesh.triangles) within ^= time_to_triangle(mesh, t, place, ray) >= 0;
  return within;
}

/// Whether b, at position `at` relative to a, touches a.
inline bool touches_at(const PlainMesh& a, const PlainMesh& b, const PlainMesh::Place& at) {
  for (int j = 0; j < 3; ++j)
    if (b.box.lower[j] + at[j] > a.box.upper[j] || b.box.upper[j] + at[j] < a.box.lower[j]) return false;
  return is_within(a, b.corners[0] + at) || is_within(b, a.corners[0] - at) || any_crossing(a, b, at) ||
         any_crossing(b, a, -at);
}

/// `at`: the position of b relative to a.
inline double first_touch(const PlainMesh& a, const PlainMesh& b, const PlainMesh::Place& at,
                          const PlainMesh::Place& velocity, double h) {
  if (touches_at(a, b, at)) return 0;
  double first = std::nextafter(h, HUGE_VAL);
  first = first_on_triangle(a, b, at, velocity, first);
  first = first_on_triangle(b, a, -at, -velocity, first);
  first = first_of_edges(a, b, at, velocity, first);
  return first <= h ? first : never;
}

}  // namespace foresee::bench
