// The rotated meshes of many rows, shared by rows of the same mesh and heading.
//
//   const TurnedMeshes meshes(drones, source, interrupt);               // looks every number up
//   ScratchPieces<TriangleTree> own;
//   if (const TriangleTree* hull = meshes.triangles(row, own)) …             // turned by the row's heading
//
// Cost (turned_forms.h): a look-up per row; on demand a microsecond per heading and some 200 ns per corner,
// as a rule once.
#pragma once

#include "shape/mesh/mesh_rows.h"
#include "shape/mesh/shared_mesh.h"
#include "shape/turned_forms.h"

namespace foresee {

class TurnedMeshes final : public MeshRows {
 public:
  TurnedMeshes() = default;
  explicit TurnedMeshes(std::size_t budget) : forms_(budget) {}
  TurnedMeshes(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
    assign(bodies, source, interrupt);
  }

  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
    forms_.assign(bodies, source, interrupt);
  }
  const TriangleTree* triangles(std::size_t row, ScratchPieces<TriangleTree>& own) const override {
    return forms_.pieces(row, own);
  }
  std::size_t memory() const { return forms_.memory(); }

 private:
  TurnedForms<SharedMesh> forms_;
};

}  // namespace foresee
