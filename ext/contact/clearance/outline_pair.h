// Which convex sets together are the places at which two objects touch of which one has an outline? A sum for
// each pair of their convex pieces, under sums of boxes around many, so that pieces are looked at only where
// they matter.
//
//   const auto own = std::make_shared<OwnOutline>(ships, 7, true);      // turns with its course
//   OutlinePair pair(own, quays, 3);
//   pair.reach()                                        // what is farther apart than this does not touch
//   for (const OutlinePair::Part& part : pair.parts()) use(pair.sum_of(part), pair.more_round(part));
//
// What turns with the change is, for a box around many of its pieces, a disc around its position; of few
// changes the box, turned.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contact/clearance/piece_sum.h"
#include "contact/outline/object_pieces.h"

namespace foresee {

/// Whether of two tables one has outlines: which look as an OutlinePair tells.
inline bool has_outlines(const Layout& a, const Layout& b) {
  return a.shape == Shape::outline || b.shape == Shape::outline;
}

/// The object that changes its motion, and whether its outline turns with its course.
struct OwnOutline {
  OwnOutline(const Bodies& bodies, std::size_t row, bool turns);

  ObjectPieces pieces;
  bool turns;
  double reach;  ///< no corner is farther from its position
};

class OutlinePair {
 public:
  using Node = ObjectPieces::Node;

  /// Two nodes, or the pieces that they are.
  struct Part {
    Node own = ObjectPieces::root, other = ObjectPieces::root;
    bool pieces = false;
  };

  /// `others` must outlive this.
  OutlinePair(std::shared_ptr<const OwnOutline> own, const Bodies& others, std::size_t row);

  /// No places at which the two touch are farther from the origin; without an r.
  double reach() const { return own_->reach + other_reach_; }
  bool turns() const { return own_->turns; }
  /// Both are convex.
  bool is_sole() const;

  /// What all is made of, and what a part that is not pieces is.
  std::vector<Part> parts() const;
  std::vector<Part> parts(const Part& of) const;
  /// Without what turns around: the places of the part are within it, grown by more_round(). Of pieces that
  /// turn, as they lie now.
  std::unique_ptr<PieceSum> sum_of(const Part& part) const;
  double more_round(const Part& part) const;
  /// Of boxes of which the own one turns, as they lie now; null where that has no width.
  std::unique_ptr<PieceSum> turning_sum_of(const Part& part) const;
  /// How large the boxes of a part are.
  double box_size(const Part& part) const;

 private:
  const ObjectPieces& other() const;

  std::shared_ptr<const OwnOutline> own_;
  const Bodies& others_;
  std::size_t row_;
  double other_reach_;
  mutable std::optional<ObjectPieces> other_;  ///< once it is asked for
};

}  // namespace foresee
