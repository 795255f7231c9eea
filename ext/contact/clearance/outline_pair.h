// The relative positions at which two objects touch if one has an outline, as a hierarchy of Minkowski sums.
// The leaves are the sums of two convex pieces. Inner nodes are sums of boxes around several pieces, so that
// pieces are read only where they matter.
//
//   const auto own = std::make_shared<OwnOutline>(ships, 7, true);      // rotates with its course
//   OutlinePair pair(own, quays, 3);
//   pair.reach()                                        // farther apart than this, the two do not touch
//   for (const OutlinePair::Part& part : pair.parts()) use(pair.sum_of(part), pair.more_round(part));
//
// If the outline rotates with k, the bound of several pieces is a disc around the object's position.
// For a narrow range of changes it is the rotated box.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contact/clearance/piece_sum.h"
#include "contact/outline/object_pieces.h"
#include "shape/outline/shared_outline.h"

namespace foresee {

/// The object that changes its motion, and whether its outline rotates with its course.
struct OwnOutline {
  OwnOutline(const Bodies& bodies, std::size_t row, bool rotates);

  ObjectPieces pieces;
  bool rotates;
  double reach;  ///< no corner is farther from its position
};

class OutlinePair {
 public:
  using Node = ObjectPieces::Node;

  /// Two nodes of the trees of pieces, or two pieces.
  struct Part {
    Node own = ObjectPieces::root, other = ObjectPieces::root;
    bool pieces = false;
  };

  /// `given`: the other outline before its rotation, if it is known; then a convex one is not rotated exactly with an
  /// own outline that rotates. Both this and `others` must outlive the pair.
  OutlinePair(std::shared_ptr<const OwnOutline> own, const Bodies& others, std::size_t row,
              const SharedOutline* given = nullptr);

  /// Upper bound of the distance from the origin at which the two touch, without an r.
  double reach() const { return own_->reach + other_reach_; }
  bool rotates() const { return own_->rotates; }
  /// Both objects are convex.
  bool is_sole() const;

  /// The parts of the whole pair, and those of a part that is not two pieces.
  std::vector<Part> parts() const;
  std::vector<Part> parts(const Part& of) const;
  /// The sum of a part without own boxes that rotate: grown by more_round() it contains the part. Own pieces
  /// that rotate have their present pose.
  std::unique_ptr<PieceSum> sum_of(const Part& part) const;
  double more_round(const Part& part) const;
  /// The sum of two boxes of which the own one rotates, in its present pose; null if that has no width.
  std::unique_ptr<PieceSum> turning_sum_of(const Part& part) const;
  /// The summed widths of both boxes of a part.
  double box_size(const Part& part) const;

 private:
  const ObjectPieces& other() const;

  std::shared_ptr<const OwnOutline> own_;
  const Bodies& others_;
  std::size_t row_;
  const SharedOutline* given_;  ///< null: not known, or not needed
  double other_reach_;
  mutable std::optional<ObjectPieces> other_;  ///< made at its first use
};

}  // namespace foresee
