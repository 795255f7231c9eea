// When do two convex pieces touch, certainly and possibly? Each pair of pieces is tested once, as long as
// there are not too many: all conditions of their sum (convex_sum.h), in doubles with error bounds.
//
//   PieceTests<2, 1> tests(a, b, relative, asked, sizes, true, space);
//   for (const PieceStay& stay : tests.of(piece_a, piece_b)) best = std::min(best, stay.begin.high);
//
// Corners are differenced before the motion comes in, and the motion's positions before that, so that far
// coordinates cost nothing. Two that are prisms also overlap along z: a condition of every pair of pieces.
// Cost: some ten nanoseconds an edge.
#pragma once

#include <span>

#include "contact/certain/certain_motion.h"
#include "contact/outline/object_pieces.h"
#include "contact/outline/piece_space.h"

namespace foresee::contact {

/// The relative motion by powers of the time after tau.
template <int Degree, int D>
std::array<Powers<Bounded, Degree>, D> seen_from(const CertainMotion<D>& relative, double tau) {
  std::array<Powers<Bounded, Degree>, D> x;
  for (std::size_t j = 0; j < D; ++j) {
    const AxisView<> view = view_from<Degree>(relative.axis[j], tau, relative.underflow);
    x[j][0] = {view.p, view.ep}, x[j][1] = {view.q, view.eq};
    if constexpr (Degree > 1) x[j][2] = {view.a, view.ea};
  }
  return x;
}

template <int D, int Degree>
class PieceTests {
 public:
  /// `asked`: the moments asked about, enclosed.
  PieceTests(const ObjectPieces& a, const ObjectPieces& b, const CertainMotion<D>& relative,
             const Stay& asked, const PairSizes<Bounded>& sizes, bool times_wanted, PieceSpace& space)
      : a_(a),
        b_(b),
        relative_(relative),
        asked_(asked),
        sizes_(sizes),
        lost_(relative.underflow + 0x1p-1060),
        times_wanted_(times_wanted),
        space_(space),
        x_(seen_from<Degree>(relative, 0)) {
    space.clear();
  }

  /// The stays of two pieces, until others are asked for.
  std::span<const PieceStay> of(std::size_t a, std::size_t b) {
    const PiecePair pair{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
    if (!times_wanted_ || is_full()) space_.clear();
    if (!times_wanted_) return test(pair);  // whoever wants no times asks once
    const auto [number, is_new] = space_.numbers.add(pair);
    if (is_new) {
      const auto first = static_cast<std::uint32_t>(space_.stays.size());
      space_.tested.push_back({first, static_cast<std::uint32_t>(test(pair).size())});
    }
    const auto& tested = space_.tested[number];
    return std::span(space_.stays).subspan(tested.first_stay, tested.stay_count);
  }

  /// Before another pair is tested all are forgotten: so the memory for a pair of outlines is bounded, and
  /// they are tested again if they are asked for again.
  bool is_full() const {
    return space_.tested.size() + space_.stays.size() + space_.ends.size() >= most_known;
  }

  /// All stays that are known.
  std::span<const PieceStay> all() const { return space_.stays; }
  std::span<const StayEnd> ends(const PieceStay& stay) const {
    return std::span(space_.ends).subspan(stay.first_end, stay.end_count);
  }

 private:
  using Kind = Condition::Kind;

  /// Some megabytes.
  static constexpr std::size_t most_known = 1 << 15;

  /// Their stays join all others.
  [[gnu::noinline]] std::span<const PieceStay> test(const PiecePair& pair) {
    const std::size_t first = space_.stays.size();
    ++space_.tests;
    space_.clipped.start(asked_);
    space_.all_ends.clear();
    if constexpr (D == 3)
      for (const int side : {-1, 1})
        if (sizes_.has_face(side)) keep({.kind = Kind::height, .sign = side});
    space_.heights = space_.all_ends.size();
    const ConvexPiece a = a_.piece(pair.a), b = b_.piece(pair.b);
    if (sizes_.radius.value > 0)
      test_grown(a, b);
    else
      test_as_they_are(a, b);
    return std::span(space_.stays).subspan(first);
  }

  void test_as_they_are(const ConvexPiece& a, const ConvexPiece& b) {
    Condition condition;
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(condition.edge);) keep(condition);
    end_part();
  }

  /// First the polygon that R moves the edges out to, which is more; then all parts of the grown sum. Each
  /// lies in that polygon, so it begins and ends with conditions of its own: the polygon's edges are no ends.
  void test_grown(const ConvexPiece& a, const ConvexPiece& b) {
    space_.edges.clear();
    SumEdge edge;
    for (ConvexSum sum(a, b); !space_.clipped.empty() && sum.next(edge);) {
      space_.edges.push_back(edge);
      space_.clipped.keep(beside(edge, 1));
    }
    if (space_.clipped.empty()) return;
    space_.outer.start(space_.clipped);
    for (const SumEdge& one : space_.edges) keep({.edge = one});
    end_part();
    for (const SumEdge& one : space_.edges) {
      if (is_decided()) return;
      begin_part();
      for (const int side : {-1, 1}) keep({.kind = Kind::foot, .sign = side, .edge = one});
      for (const int side : {-1, 1}) keep({.kind = Kind::side, .edge = one}, beside(one, side));
      end_part();
      begin_part();
      keep({.kind = Kind::corner, .edge = one});
      end_part();
    }
  }

  void begin_part() {
    space_.clipped.start(space_.outer);
    space_.all_ends.resize(space_.heights);
  }
  bool is_decided() const {
    return !times_wanted_ && !space_.stays.empty() && space_.stays.back().is_certain();
  }

  /// What all conditions leave of the time asked about joins the stays.
  void end_part() {
    for (const Stay& stay : space_.clipped) {
      const auto first_end = static_cast<std::uint32_t>(space_.ends.size());
      for (const StayEnd& end : space_.all_ends)
        if (end.at.meets(end.way == Way::in ? stay.begin : stay.end)) space_.ends.push_back(end);
      space_.stays.push_back({stay, first_end, static_cast<std::uint32_t>(space_.ends.size()) - first_end});
    }
  }

  void keep(const Condition& condition) {
    if (space_.clipped.empty()) return;
    if (Degree > 1 && condition.kind == Kind::corner)
      return keep(condition,
                  inside_by_leaps([&](double tau) { return around_corner(condition, tau); }, lost_, asked_));
    // Of more powers are sides alone, which beside() has, and corners.
    with_polynomial<Degree>(condition, x_, sizes_, [&](const auto& p) {
      if constexpr (std::tuple_size_v<std::decay_t<decltype(p)>> < 5)
        keep(condition, inside(p, lost_, asked_.end.high));
    });
  }

  /// When d is at most R from the line of an edge, on one side: fewer powers than on both.
  Inside beside(const SumEdge& edge, int side) const {
    Powers<Bounded, Degree> p = beyond<Degree>(edge, x_.data());
    if (side < 0)
      for (Bounded& c : p) c = -c;
    // R may be large: what underflow loses of the square counts before the product.
    p[0] = p[0] - sizes_.radius * sqrt(with_lost(squared_length<Bounded>(edge), 0x1p-1060));
    return inside(p, lost_, asked_.end.high);
  }

  Powers<Bounded, 4> around_corner(const Condition& condition, double tau) const {
    const auto x = seen_from<Degree>(relative_, tau);
    const auto p = round_polynomial<Degree>(condition, x.data(), sizes_.radius);
    Powers<Bounded, 4> all{};
    std::copy(p.begin(), p.end(), all.begin());
    return all;
  }

  void keep(const Condition& condition, const Inside& inside) {
    if (space_.clipped.empty()) return;
    space_.clipped.keep(inside);
    if (!times_wanted_) return;
    for (int i = 0; i < inside.count; ++i) {
      const Stay& stay = inside.list[static_cast<std::size_t>(i)];
      if (stay.begin.high > -Stay::inf) space_.all_ends.push_back({condition, Way::in, stay.begin});
      if (stay.end.low < Stay::inf) space_.all_ends.push_back({condition, Way::out, stay.end});
    }
  }

  const ObjectPieces &a_, &b_;
  const CertainMotion<D>& relative_;
  const Stay asked_;
  const PairSizes<Bounded> sizes_;
  const double lost_;
  const bool times_wanted_;
  PieceSpace& space_;
  const std::array<Powers<Bounded, Degree>, D> x_;  ///< the motion from now on
};

}  // namespace foresee::contact
