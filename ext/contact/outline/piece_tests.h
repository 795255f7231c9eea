// When do two convex pieces touch, certainly and possibly? Each pair of pieces is tested once: all conditions
// of their sum (convex_sum.h), in doubles with error bounds.
//
//   PieceTests<2, 1> tests(setup, a, b, relative, asked, space);
//   for (const PieceStay& stay : tests.of(piece_a, piece_b)) best = std::min(best, stay.begin.high);
//
// Corners are differenced before the motion comes in, and the motion's positions before that, so that far
// coordinates cost nothing. Two that are prisms also overlap along z: a condition of every pair of pieces.
// Cost: some ten nanoseconds an edge.
#pragma once

#include <span>

#include "contact/certain/certain_motion.h"
#include "contact/outline/condition.h"
#include "contact/outline/stays.h"
#include "numbers/crossed_root.h"

namespace foresee::contact {

/// A condition that begins or ceases to hold where a stay may begin or end.
struct StayEnd {
  Condition condition;
  Way way;
  Enclosure at;
};

/// A stay of two pieces, and what it may begin and end with.
struct PieceStay : Stay {
  std::uint32_t tested;                ///< number of the pair of pieces
  std::uint32_t first_end, end_count;  ///< among all ends
};

/// Space for tests, used for one pair of objects after another.
struct PieceSpace {
  struct Tested {
    std::uint32_t a, b, first_stay, stay_count;
  };
  std::vector<Tested> tested;
  std::vector<PieceStay> stays;
  std::vector<StayEnd> ends, all_ends;
  Stays clipped;

  void clear() { tested.clear(), stays.clear(), ends.clear(); }
};

template <int D, int Degree>
class PieceTests {
 public:
  /// `asked`: the moments asked about, enclosed. `half_height`: of both together, along z.
  PieceTests(const Pieces& a, const Pieces& b, const CertainMotion<D>& relative, const Stay& asked,
             const Bounded& half_height, bool with_ends, PieceSpace& space)
      : a_(a),
        b_(b),
        asked_(asked),
        half_height_(half_height),
        lost_(relative.underflow + 0x1p-1060),
        with_ends_(with_ends),
        space_(space) {
    space.clear();
    for (int j = 0; j < D; ++j) {
      const CertainAxisMotion<double>& r = relative.axis[j];
      x_[j][0] = {r.x, r.ex}, x_[j][1] = {r.v, r.ev};
      if constexpr (Degree > 1) x_[j][2] = {r.a, r.ea};
    }
  }

  /// The stays of two pieces.
  std::span<const PieceStay> of(std::size_t a, std::size_t b) {
    for (const auto& t : space_.tested)
      if (t.a == a && t.b == b) return std::span(space_.stays).subspan(t.first_stay, t.stay_count);
    return test(a, b);
  }

  /// All stays so far.
  std::span<const PieceStay> all() const { return space_.stays; }
  std::span<const StayEnd> ends(const PieceStay& stay) const {
    return std::span(space_.ends).subspan(stay.first_end, stay.end_count);
  }
  const PieceSpace::Tested& pair_of(const PieceStay& stay) const { return space_.tested[stay.tested]; }

 private:
  [[gnu::noinline]] std::span<const PieceStay> test(std::size_t a, std::size_t b) {
    const auto number = static_cast<std::uint32_t>(space_.tested.size());
    const auto first = static_cast<std::uint32_t>(space_.stays.size());
    clip(a_.piece(a), b_.piece(b));
    for (const Stay& stay : space_.clipped) {
      const auto first_end = static_cast<std::uint32_t>(space_.ends.size());
      for (const StayEnd& end : space_.all_ends)
        if (end.at.meets(end.way == Way::in ? stay.begin : stay.end)) space_.ends.push_back(end);
      space_.stays.push_back(
          {stay, number, first_end, static_cast<std::uint32_t>(space_.ends.size()) - first_end});
    }
    const auto count = static_cast<std::uint32_t>(space_.stays.size()) - first;
    space_.tested.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), first, count});
    return std::span(space_.stays).subspan(first, count);
  }

  /// What all conditions leave of the time asked about.
  void clip(const ConvexPiece& a, const ConvexPiece& b) {
    space_.clipped.begin(asked_);
    space_.all_ends.clear();
    Condition condition;
    if constexpr (D == 3)
      for (const int side : {-1, 1}) keep({.along_z = side});
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(condition.edge);) keep(condition);
  }

  void keep(const Condition& condition) {
    const Inside inside =
        contact::inside(polynomial_of<Degree>(condition, x_, half_height_), lost_, asked_.end.high);
    space_.clipped.keep(inside);
    if (!with_ends_) return;
    for (int i = 0; i < inside.count; ++i) {
      const Stay& stay = inside.list[static_cast<std::size_t>(i)];
      if (stay.begin.high > -Stay::inf) space_.all_ends.push_back({condition, Way::in, stay.begin});
      if (stay.end.low < Stay::inf) space_.all_ends.push_back({condition, Way::out, stay.end});
    }
  }

  const Pieces &a_, &b_;
  const Stay asked_;
  const Bounded half_height_;
  const double lost_;
  const bool with_ends_;
  PieceSpace& space_;
  Powers<Bounded, Degree> x_[D];
};

}  // namespace foresee::contact
