// When do two meshes first collide, by FCL's continuous collision of translating trees of oriented boxes?
//
//   const FclMesh a(mesh_a), b(mesh_b);                    // trees are made once
//   first_collision(a, b, {.from = d, .velocity = v, .h = 60}, 1000);      // seconds; never: at no sample
//
// FCL asks at moments evenly spread over [0, h], the first and the last among them, and answers the first at
// which triangles of both meet: late by up to the space between two, and what touches only between two is
// missed. (Of its other solvers, in Debian's 0.7.0, conservative advancement misses meshes that meet head
// on and the polynomial one reports contact where there is none.) Only what is linked with FCL may call.
#pragma once

#include <memory>

#include "agreement.h"
#include "shape/mesh/mesh.h"

namespace foresee::bench {

/// Where b is as seen from a.
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
