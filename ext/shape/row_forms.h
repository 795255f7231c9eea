// The rotated forms of many rows, outlines or meshes as their layout says, to be attached to bodies.
//
//   RowForms forms;
//   forms.assign(bodies, source, interrupt);              // after the rows are filled
//   forms.attach_to(bodies);                                   // bodies.outlines or bodies.meshes
#pragma once

#include "shape/mesh/turned_meshes.h"
#include "shape/outline/turned_outlines.h"

namespace foresee {

class RowForms {
 public:
  /// As TurnedForms::assign(). Requires: a layout whose shapes are stored separately.
  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
    if (bodies.layout.shape == Shape::mesh)
      meshes_.assign(bodies, source, interrupt);
    else
      outlines_.assign(bodies, source, interrupt);
  }
  /// From now on contact reads the forms of these bodies here; this must outlive it.
  void attach_to(Bodies& bodies) const {
    if (bodies.layout.shape == Shape::mesh)
      bodies.meshes = &meshes_;
    else
      bodies.outlines = &outlines_;
  }
  std::size_t memory() const { return outlines_.memory() + meshes_.memory(); }

 private:
  TurnedOutlines outlines_;
  TurnedMeshes meshes_;
};

}  // namespace foresee
