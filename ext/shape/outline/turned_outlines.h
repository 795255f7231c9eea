// The rotated outlines of many rows, shared by rows of the same outline and heading.
//
//   const TurnedOutlines outlines(ships, source, interrupt);      // looks every number up
//   ScratchPieces<ConvexPieces> own;
//   if (const ConvexPieces* hull = outlines.pieces(row, own)) …        // turned by the row's heading
//
// Cost (turned_forms.h): a look-up per row; on demand a microsecond per heading and some 50 ns per corner,
// 200 if the outline is not convex, as a rule once.
#pragma once

#include "shape/outline/outline_rows.h"
#include "shape/outline/shared_outline.h"
#include "shape/turned_forms.h"

namespace foresee {

class TurnedOutlines final : public OutlineRows {
 public:
  TurnedOutlines() = default;
  explicit TurnedOutlines(std::size_t budget) : forms_(budget) {}
  TurnedOutlines(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
    assign(bodies, source, interrupt);
  }

  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt) {
    forms_.assign(bodies, source, interrupt);
  }
  const ConvexPieces* pieces(std::size_t row, ScratchPieces<ConvexPieces>& own) const override {
    return forms_.pieces(row, own);
  }
  std::size_t memory() const { return forms_.memory(); }

 private:
  TurnedForms<SharedOutline> forms_;
};

}  // namespace foresee
