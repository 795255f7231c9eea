// Minkowski sum of one convex piece and the reflection of another, in doubles: support function and signed
// distance.
//
//   PieceSum sum(hull.piece(0), quay.piece(3));
//   sum.support(0, 1)                      // no point of the sum is farther north
//   sum.turn(15);                          // rotates the first piece by 15 degrees from its given pose
//
// The sum is the set of relative positions at which the two touch (contact/outline/object_pieces.h). Its support
// function is an upper bound for proofs; the signed distance is approximate, for guesses.
// Cost: linear in the corners of both, some nanoseconds each.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "contact/outline/object_pieces.h"
#include "numbers/correct_rounding.h"

namespace foresee {

class PieceSum {
 public:
  /// `other` must outlive this.
  PieceSum(const ConvexPiece& own, const ConvexPiece& other);
  /// Of the first piece of `other`.
  PieceSum(const ConvexPiece& own, std::shared_ptr<const ObjectPieces> other);
  /// Of the second piece rotated to a pose, for sums that rotate: no exact rotation is read.
  PieceSum(const ConvexPiece& own, const ConvexPiece& other, const SineCosine<double>& pose_of_other);
  PieceSum(const PieceSum&) = delete;
  PieceSum& operator=(const PieceSum&) = delete;

  /// Rotates the own piece clockwise by so many degrees from its given pose.
  /// Requires: |degrees| <= 720; the own piece is not a box of no width.
  void turn(double degrees) { turn(quick_sine_cosine(degrees)); }
  void turn(const SineCosine<double>& at);

  /// Upper bound of the support function along (x, y), in lengths of that vector. It also holds for the
  /// corners that a rotated outline is stored with, at a rounded heading.
  double support(double x, double y) const;
  /// The support function in this pose, whatever the present one is.
  double support(double x, double y, const SineCosine<double>& pose) const;
  /// Approximate signed distance of a point, below 0 inside, and its gradient, of length 1.
  double signed_distance(double x, double y, double& normal_x, double& normal_y) const;
  /// The point of the sum that is farthest along (x, y): a corner.
  Corner farthest(double x, double y) const;
  /// The two corners whose difference that is after a rotation, the own one in the given pose.
  struct CornerPair {
    Corner own, other;
  };
  CornerPair farthest_pair(double x, double y, const SineCosine<double>& pose) const;
  /// Approximately the times from `begin` to `end` at which (x, y) + tau (vx, vy) is inside; first > second: none.
  std::pair<double, double> crossing(double x, double y, double vx, double vy, double begin,
                                     double end) const;
  /// Whether one corner of either piece remains inside the other, or within `radius` of it, while both rotate. They
  /// rotate with the vector `own_place`, by up to a half width from the present pose. `half`: the sine and cosine of
  /// the half width. Approximate; of many corners and many sides not all are tested.
  bool has_corner_inside(const Corner& other_place, const Corner& own_place, const SineCosine<double>& half,
                         double radius, double slack) const;
  /// Calls use(normal_x, normal_y, error) for each edge that a point is beyond, or inside by less than
  /// `near`. The normal points outward; `error` is an upper bound of its error.
  template <class Use>
  void for_each_edge_near(double x, double y, double near, Use&& use) const {
    for (const Edge& edge : ring())
      if (!((x - edge.x) * edge.normal_x + (y - edge.y) * edge.normal_y < -near))
        use(edge.normal_x, edge.normal_y, size_ * 0x1p-45 / edge.run);
  }
  const SineCosine<double>& pose() const { return pose_; }
  std::span<const Corner> given_corners() const { return given_; }
  /// In the present pose.
  std::span<const Corner> own_corners() const { return own_; }
  std::span<const Corner> other_corners() const { return other_.corners; }
  /// About the cost of an evaluation.
  std::size_t corners() const { return own_.size() + other_.corners.size(); }
  /// Upper bound of the distance from the origin on each axis.
  double size() const { return size_; }
  /// Upper bound of the distance of the own corners from their position.
  double own_reach() const { return own_reach_; }

 private:
  /// An edge of the boundary, which runs counterclockwise.
  struct Edge {
    double x, y;                ///< its start
    double normal_x, normal_y;  ///< outward
    double length;
    double run;  ///< the length of the vector that gives its direction, also for boxes of no width
  };
  void make_ring(const Corner* along) const;
  void make_turned_ring() const;
  /// After a rotation it is made when it is read: a path that passes the sum needs no more than corners.
  const std::vector<Edge>& ring() const {
    if (is_turned_) make_turned_ring();
    return ring_;
  }

  /// An edge of one piece: its outward normal.
  struct Side {
    double normal_x, normal_y, length, run;

    /// Whether it runs downward, or to the left: counterclockwise from the lowest corner, these come last.
    bool is_late() const { return normal_x < 0 || (normal_x == 0 && normal_y > 0); }
  };
  static std::vector<Side> sides_of(const ConvexPiece& piece, double sign);
  void make_sides() const;
  static std::size_t first_of(const std::vector<Side>& sides);
  struct Arc;
  struct Placed;
  static bool is_inside(const Arc& arc, const Placed& piece, double radius, double slack, std::size_t& side,
                        std::size_t& left);

  std::vector<Corner> given_, own_;
  mutable std::vector<Side> own_sides_, other_sides_;  ///< made with the first turned ring
  mutable std::vector<Side> turned_sides_;             ///< the own ones in the present pose
  mutable std::size_t first_other_ = 0;
  SineCosine<double> pose_{0, 1};
  std::shared_ptr<const ObjectPieces> kept_;
  std::vector<Corner> kept_corners_;
  ConvexPiece other_;
  mutable std::vector<Edge> ring_;
  mutable Corner point_;            ///< the sum, if it has no edges
  mutable bool is_turned_ = false;  ///< since the ring was made
  double size_ = 0, own_reach_ = 0;
};

}  // namespace foresee
