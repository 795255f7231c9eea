#include "contact/clearance/outline_pair.h"

#include <cmath>

namespace foresee {
namespace {

/// The distance of the farthest corner of a box from the origin, rounded up.
double reach_of(const Box<2>& box) {
  const Vec<2> far = box.lower.abs().max(box.upper.abs());
  const double largest = far.largest();
  if (largest == 0) return 0;
  return largest * std::sqrt((far / largest).square().sum()) * (1 + 0x1p-49) +
         std::numeric_limits<double>::denorm_min();
}

/// reach_of() of the bounds of a row.
double reach_of_row(const Bodies& bodies, std::size_t i) {
  ObjectPieces around;
  around.take_row(bodies, nullptr, i);
  return reach_of(around.box(ObjectPieces::root));
}

/// A box as one piece.
ConvexPiece piece_of(const Box<2>& box, ObjectPieces& made) {
  made.take_box(box);
  return made.piece(0);
}

}  // namespace

OwnOutline::OwnOutline(const Bodies& bodies, std::size_t row, bool rotates) : rotates(rotates) {
  pieces.take_row(bodies, bodies.outlines, row);
  reach = reach_of(pieces.box(ObjectPieces::root));
}

OutlinePair::OutlinePair(std::shared_ptr<const OwnOutline> own, const Bodies& others, std::size_t row,
                         const SharedOutline* given)
    : own_(std::move(own)),
      others_(others),
      row_(row),
      given_(given),
      other_reach_(reach_of_row(others, row)) {}

const ObjectPieces& OutlinePair::other() const {
  if (!other_) other_.emplace().take_row(others_, others_.outlines, row_);
  return *other_;
}

bool OutlinePair::is_sole() const {
  return own_->pieces.count() == 1 && (given_ ? given_->pieces().count() : other().count()) == 1;
}

std::vector<OutlinePair::Part> OutlinePair::parts() const {
  return is_sole() ? std::vector<Part>{{.pieces = true}} : std::vector<Part>{{}};
}

std::vector<OutlinePair::Part> OutlinePair::parts(const Part& of) const {
  const auto left = ObjectPieces::left, right = ObjectPieces::right;
  if (!other().is_leaf(of.other)) return {{of.own, left(of.other)}, {of.own, right(of.other)}};
  if (!own_->pieces.is_leaf(of.own)) return {{left(of.own), of.other}, {right(of.own), of.other}};
  return {{of.own, of.other, true}};
}

std::unique_ptr<PieceSum> OutlinePair::sum_of(const Part& part) const {
  const ObjectPieces& mine = own_->pieces;
  if (part.pieces && given_ && is_sole()) {
    const std::span<const Corner> corners = given_->pieces().corners(0);
    const double heading = value_or(others_.row(row_), others_.at.heading, 0);
    return std::make_unique<PieceSum>(mine.piece(0), ConvexPiece{corners, corners.data(), nullptr},
                                      quick_sine_cosine(heading));
  }
  if (part.pieces)
    return std::make_unique<PieceSum>(mine.piece(mine.item(part.own)),
                                      other().piece(other().item(part.other)));
  static constexpr Corner position[] = {{0, 0}};
  Box<2> box = other().box(part.other), turned{-box.upper, -box.lower};
  if (!rotates()) {
    const Box<2>& own = mine.box(part.own);
    for (int axis = 0; axis < 2; ++axis) {
      const Ends ends = grown(own.lower[axis], own.upper[axis], box.upper[axis], -box.lower[axis]);
      turned.lower[axis] = ends.lower, turned.upper[axis] = ends.upper;
    }
  }
  ObjectPieces around;
  return std::make_unique<PieceSum>(piece_of(turned, around), ConvexPiece{position, position, nullptr});
}

std::unique_ptr<PieceSum> OutlinePair::turning_sum_of(const Part& part) const {
  const Box<2>& own = own_->pieces.box(part.own);
  if (!rotates() || part.pieces || !(own.upper > own.lower).all()) return nullptr;
  ObjectPieces around;
  auto other_box = std::make_shared<ObjectPieces>();
  other_box->take_box(other().box(part.other));
  return std::make_unique<PieceSum>(piece_of(own, around), std::move(other_box));
}

double OutlinePair::more_round(const Part& part) const {
  return rotates() && !part.pieces ? reach_of(own_->pieces.box(part.own)) : 0;
}

double OutlinePair::box_size(const Part& part) const {
  const Box<2>&one = own_->pieces.box(part.own), &two = other().box(part.other);
  return (one.upper - one.lower).sum() + (two.upper - two.lower).sum();
}

}  // namespace foresee
