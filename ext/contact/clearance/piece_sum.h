// At which places, seen from one convex piece of an outline, does another touch it? In their Minkowski sum
// (contact/outline/convex_sum.h), here in doubles: how far it reaches, for proofs, and how far outside of it
// a place is, for guesses.
//
//   PieceSum sum(hull.piece(0), quay.piece(3));
//   sum.support(0, 1)                      // no place of the sum lies farther north
//   sum.turn(15);                       // the first piece turned by 15 degrees clockwise from where it was
//
// Cost: linear in the corners of both, some nanoseconds each.
#pragma once

#include <memory>
#include <vector>

#include "contact/outline/convex_sum.h"
#include "contact/outline/object_pieces.h"

namespace foresee {

class PieceSum {
 public:
  /// `other` must outlive this.
  PieceSum(const ConvexPiece& own, const ConvexPiece& other);
  /// With the first piece of `other`.
  PieceSum(const ConvexPiece& own, std::shared_ptr<const ObjectPieces> other);
  PieceSum(const PieceSum&) = delete;
  PieceSum& operator=(const PieceSum&) = delete;

  /// From now on that of the own piece turned clockwise by so many degrees, counted from how it was given.
  /// Requires: |degrees| <= 720; the own piece is not a box of no width.
  void turn(double degrees);

  /// An upper bound of how far it reaches along (x, y), in lengths of that; also if the own corners are those
  /// that a turned outline is stored with, at a heading that is rounded.
  double support(double x, double y) const;
  /// How far outside it a place is, below 0 within, roughly; and which way it grows there, of length 1.
  double signed_distance(double x, double y, double& normal_x, double& normal_y) const;
  /// use(normal_x, normal_y, error) for each edge that a place is beyond, or inside by less than `near`:
  /// which way it grows there, and how far that is off at most.
  template <class Use>
  void for_each_edge_near(double x, double y, double near, Use&& use) const {
    for (const Edge& edge : ring_)
      if (!((x - edge.x) * edge.normal_x + (y - edge.y) * edge.normal_y < -near))
        use(edge.normal_x, edge.normal_y, size_ * 0x1p-45 / edge.run);
  }
  /// No place of it is farther from the origin on any axis.
  double size() const { return size_; }
  /// No corner of the own piece is farther from its position.
  double own_reach() const { return own_reach_; }

 private:
  /// One of the ring around it, that runs counterclockwise.
  struct Edge {
    double x, y;                ///< where it begins
    double normal_x, normal_y;  ///< outward
    double length;
    double run;  ///< of what tells its direction, for boxes of no width too
  };
  void make_ring(const Corner* along);

  std::vector<Corner> given_, own_;
  std::shared_ptr<const ObjectPieces> kept_;
  ConvexPiece other_;
  std::vector<Edge> ring_;
  Corner point_;  ///< where the ring has no edges
  double size_ = 0, own_reach_ = 0;
};

}  // namespace foresee
