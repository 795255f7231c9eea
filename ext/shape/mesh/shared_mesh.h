// A mesh that many rows share, with its triangle tree, which is built on demand.
//
//   const auto building = std::make_shared<const SharedMesh>(read_mesh(text));
//   building->pieces();                  // made at the first call, by whichever thread comes first
//   building->rotated(37.5)           // throws if the rotated mesh is not valid
//
// Immutable: several threads and statements may hold one.
#pragma once

#include <mutex>

#include "shape/mesh/mesh.h"
#include "shape/mesh/mesh_text.h"
#include "shape/mesh/triangle_tree.h"
#include "shape/shared_form.h"

namespace foresee {

class SharedMesh final : public Form {
 public:
  using Pieces = TriangleTree;

  /// Requires: a sound mesh (mesh.h).
  explicit SharedMesh(Mesh mesh) : mesh_(std::move(mesh)) {}

  const Mesh& mesh() const { return mesh_; }
  const TriangleTree& pieces() const {
    std::call_once(cut_, [this] { pieces_ = TriangleTree(mesh_); });
    return pieces_;
  }
  /// The mesh rotated by `heading` degrees (mesh.h). Throws Error if the result is not a valid mesh,
  /// or beyond the largest double. Requires: -360 <= heading <= 360.
  Mesh rotated(double heading) const {
    if (heading == 0) return mesh_;
    Mesh rotated = turned(mesh_, heading);
    check_turned(mesh_, rotated, heading);
    return rotated;
  }
  TriangleTree rotated_pieces(double heading) const { return TriangleTree(pieces(), rotated(heading)); }

  Shape shape() const override { return Shape::mesh; }
  std::size_t corners() const override { return 3 * mesh_.triangles().size(); }
  std::string text() const override { return write_mesh(mesh_); }
  Extents<3> extents(double heading) const override {
    return heading == 0 ? mesh_.extents() : rotated(heading).extents();
  }

 private:
  Mesh mesh_;
  mutable std::once_flag cut_;
  mutable TriangleTree pieces_;
};

}  // namespace foresee
