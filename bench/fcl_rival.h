// First collision of two meshes by FCL's continuous collision of translating trees of oriented boxes.
//
//   const FclMesh a(mesh_a), b(mesh_b);                    // trees are made once
//   first_collision(a, b, {.from = d, .velocity = v, .h = 60}, 1000);      // seconds; never: at no sample
//
// FCL samples times evenly spread over [0, h], both ends included. It returns the first sample at which
// triangles of both meshes intersect. So it is late by up to one interval, and a contact between two samples
// is missed. (Of its other solvers, in Debian's 0.7.0, conservative advancement misses meshes that meet head
// on, and the polynomial one reports contact where none exists.) Only programs linked with FCL may call.
#pragma once

#include <memory>

#include "agreement.h"
#include "shape/mesh/mesh.h"

namespace foresee::bench {

/// The position of b relative to a.
struct Flight {
  Vec<3> from, velocity;
  double h;
};

class FclMesh {
 public:
  explicit FclMesh(const Mesh& mesh);

 private:
  struct Model;
  std::shared_ptr<const Model> model_;

  friend double first_collision(const FclMesh& a, const FclMesh& b, const Flight& flight, int samples);
};

double first_collision(const FclMesh& a, const FclMesh& b, const Flight& flight, int samples);

}  // namespace foresee::bench
