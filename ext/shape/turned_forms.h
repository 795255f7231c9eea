// What do the forms of many rows look like, as they lie? Asked by contact, for the rows that come near each
// other. Common to outlines (outline/turned_outlines.h) and meshes (mesh/turned_meshes.h).
//
//   TurnedForms<CutOutline> forms;
//   forms.assign(ships, source, interrupt);               // looks every number up
//   if (const ConvexPieces* hull = forms.pieces(row)) …   // turned by the row's heading
//
// Rows of one form share its pieces, unless they are turned: then a row's pieces are made when it is first
// asked for, and kept. Several threads may ask. Cost: a look-up a row; later, once, to turn and to make.
#pragma once

#include <atomic>
#include <memory>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "shape/bodies.h"
#include "shape/form.h"

namespace foresee::shape {

template <class KindOfForm>
class TurnedForms {
 public:
  using Pieces = typename KindOfForm::Pieces;

  TurnedForms() = default;
  ~TurnedForms() { clear(); }
  TurnedForms(const TurnedForms&) = delete;
  TurnedForms& operator=(const TurnedForms&) = delete;

  /// From now on these rows. Nobody asks meanwhile. Requires: the layout is one of such forms; the rows live
  /// as long as this and do not change.
  void assign(const Bodies& bodies, FormSource& source, Interrupt& interrupt);

  /// Which live as long as this; null: the row has no form. Throws Error where the form, turned, is none: no
  /// row that was accepted has such a heading.
  const Pieces* pieces(std::size_t row) const;

  /// Bytes, some of them an estimate: it grows as rows are asked for.
  std::size_t memory() const;

 private:
  using Turned = std::atomic<const Pieces*>;

  void clear() noexcept;
  double heading(std::size_t row) const { return value_or(bodies_.row(row), bodies_.at.heading, 0); }

  Bodies bodies_;
  std::unordered_map<std::int64_t, std::shared_ptr<const KindOfForm>> known_;
  std::vector<const KindOfForm*> forms_;      ///< one a row; null: none
  mutable std::unique_ptr<Turned[]> turned_;  ///< … and its pieces; null: not made
  mutable std::atomic<std::size_t> turned_corners_ = 0;
};

}  // namespace foresee::shape
