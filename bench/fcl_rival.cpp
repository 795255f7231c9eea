#include "fcl_rival.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/continuous_collision.h>

namespace foresee::bench {

struct FclMesh::Model {
  fcl::BVHModel<fcl::OBBRSSd> tree;
};

FclMesh::FclMesh(const Mesh& mesh) {
  std::vector<fcl::Vector3d> corners;
  std::vector<fcl::Triangle> triangles;
  for (const SpaceCorner& corner : mesh.corners()) corners.emplace_back(corner.x, corner.y, corner.z);
  for (const Triangle& t : mesh.triangles()) triangles.emplace_back(t[0], t[1], t[2]);
  const auto model = std::make_shared<Model>();
  model->tree.beginModel();
  model->tree.addSubModel(corners, triangles);
  model->tree.endModel();
  model_ = model;
}

double first_collision(const FclMesh& a, const FclMesh& b, const Flight& flight, int samples) {
  const auto moved_by = [](const Vec<3>& place) {
    fcl::Transform3d transform = fcl::Transform3d::Identity();
    transform.translation() = fcl::Vector3d(place[0], place[1], place[2]);
    return transform;
  };
  const fcl::Transform3d at_rest = fcl::Transform3d::Identity();
  const fcl::ContinuousCollisionRequestd request(static_cast<std::size_t>(samples), 1.0 / samples,
                                                 fcl::CCDM_TRANS, fcl::GST_LIBCCD, fcl::CCDC_NAIVE);
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(&a.model_->tree, at_rest, at_rest, &b.model_->tree, moved_by(flight.from),
                         moved_by(flight.from + flight.h * flight.velocity), request, result);
  return result.is_collide ? result.time_of_contact * flight.h : never;
}

}  // namespace foresee::bench
