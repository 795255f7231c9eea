// What do the outlines of many rows look like, as they lie? Asked by contact, for the rows that come near
// each other.
//
//   const TurnedOutlines outlines(ships, source, interrupt);      // looks every number up
//   if (const ConvexPieces* hull = outlines.pieces(row)) …        // turned by the row's heading
//
// Rows of one outline share its pieces, unless they are turned: then a row's pieces are made when it is first
// asked for, and kept. Several threads may ask. Cost: a look-up a row; later a microsecond a turned row, some
// 50 ns a corner and 200 where it is not convex, once.
#pragma once

#include <atomic>
#include <memory>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "shape/bodies.h"
#include "shape/outline/cut_outline.h"
#include "shape/outline/outline_rows.h"

namespace foresee::shape {

class TurnedOutlines final : public OutlineRows {
 public:
  TurnedOutlines() = default;
  /// Requires: the layout is one of outlines; the rows live as long as this and do not change.
  TurnedOutlines(const Bodies& bodies, OutlineSource& source, Interrupt& interrupt) {
    assign(bodies, source, interrupt);
  }
  ~TurnedOutlines() override { clear(); }
  TurnedOutlines(const TurnedOutlines&) = delete;
  TurnedOutlines& operator=(const TurnedOutlines&) = delete;

  /// From now on these rows. Nobody asks meanwhile.
  void assign(const Bodies& bodies, OutlineSource& source, Interrupt& interrupt);

  /// Throws Error where the outline, turned, is none: no row that was accepted has such a heading.
  const ConvexPieces* pieces(std::size_t row) const override;

  /// Bytes, some of them an estimate: it grows as rows are asked for.
  std::size_t memory() const;

 private:
  using Turned = std::atomic<const ConvexPieces*>;

  void clear() noexcept;
  double heading(std::size_t row) const { return value_or(bodies_.row(row), bodies_.at.heading, 0); }

  Bodies bodies_;
  std::unordered_map<std::int64_t, std::shared_ptr<const CutOutline>> known_;
  std::vector<const CutOutline*> outlines_;   ///< one a row; null: none
  mutable std::unique_ptr<Turned[]> turned_;  ///< … and its pieces; null: not made
  mutable std::atomic<std::size_t> turned_corners_ = 0;
};

}  // namespace foresee::shape
