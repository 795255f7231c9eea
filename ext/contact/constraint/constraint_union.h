// A union of pieces, each the intersection of constraints, which are named by number: what the exact stage
// reads of any contact set.
//
//   ConstraintUnion pieces;
//   pieces.add_piece({.all = {0, 1, 2}});                       // constraints 0, 1 and 2 hold
//
// The constraints themselves are those of a contact set (minkowski/primitive.h) or of pieces (constraint.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace foresee {

/// One piece: the intersection in which the constraints `all` are at most 0. `around` and `beyond` save work;
/// they do not change the union. Where the piece holds, the constraints `around` it hold too. The piece may
/// be restricted to where `beyond` is at least 0, because another piece covers the rest. `ball` is a
/// quadratic constraint of `all` that no other piece has. Its roots are costly: the exact stage computes them
/// last, and only while the rest holds.
struct Conditions {
  std::vector<int> all, around = {}, beyond = {};
  int ball = -1;  ///< -1: no such constraint
};

class ConstraintUnion {
 public:
  /// A range of the list of members.
  struct Part {
    std::uint32_t begin, end;
  };
  struct Piece {
    Part all, around, beyond;
    int ball;
  };

  void add_piece(const Conditions& conditions) {
    const Part all = add(conditions.all), around = add(conditions.around), beyond = add(conditions.beyond);
    pieces_.push_back({all, around, beyond, conditions.ball});
  }

  std::span<const Piece> pieces() const { return pieces_; }
  std::span<const int> members(const Part& part) const {
    return {members_.data() + part.begin, members_.data() + part.end};
  }

 protected:
  std::vector<Piece> pieces_;
  std::vector<int> members_;

 private:
  Part add(const std::vector<int>& members) {
    const auto begin = static_cast<std::uint32_t>(members_.size());
    members_.insert(members_.end(), members.begin(), members.end());
    return {begin, static_cast<std::uint32_t>(members_.size())};
  }
};

}  // namespace foresee
