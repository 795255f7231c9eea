// Simultaneous descent of two trees of boxes: the pairs of pieces of two moving objects that could touch,
// and an upper bound on when.
//
//   const TreeWalk<2, ObjectPieces> walk(a, b, relative, {0, 600}, sizes, steps);
//   walk.visit(Order::earlier_first, [&](const Interval<double>& near) { return near.begin <= best; },
//              [&](std::size_t piece_a, std::size_t piece_b, const Interval<double>& near) { … });
//
// Each pair of nodes cuts the remaining time by the chord of the relative motion (chord.h). Objects
// do not rotate while they move, so axis-aligned boxes stay tight. Surfaces have bounding discs as well
// (mesh/disc_tests.h). Cost: some ten nanoseconds per pair of nodes.
#pragma once

#include <cstdint>

#include "base/interrupt_steps.h"
#include "contact/certified/certain_motion.h"
#include "contact/certified/chord.h"
#include "contact/constraint/constraint.h"
#include "motion/axis_aligned_box.h"

namespace foresee {

/// When two boxes could touch, one from each of two objects: the chord's bounds, with the terms that all
/// pairs of boxes within `around_a` and `around_b` share computed once.
///
///   const BoxChord<2> chord(Chord<2>(relative, end), box_around_a, box_around_b, grown);
///   const Interval<double> near = chord.between(box_of_a, box_of_b, queried);  // empty: they never touch
///
/// The slack is far larger than all rounding errors. Numbers too large for it take the chord's own
/// computation. The boxes have the first `axes` of D axes. Cost: some nanoseconds per pair.
template <int axes, int D = axes>
class BoxChord {
 public:
  /// `grown`: the contact distance.
  BoxChord(const Chord<D>& chord, const Box<axes>& around_a, const Box<axes>& around_b, const Bounded& grown)
      : chord_(chord), grown_(grown) {
    const Vec<axes> sizes = reach(around_a) + reach(around_b);
    for (int j = 0; j < axes; ++j) {
      const auto [at, steep, room] = chord.along(j);
      const double more = grown.value + grown.error;
      const double beside = room + more + 0x1p-40 * (sizes[j] + std::abs(at) + more);
      steep_[j] = steep, below_[j] = -beside - at, above_[j] = beside - at;
      is_plain_ &= sizes[j] + beside + std::abs(at) < 0x1p1000 && std::abs(steep) <= 0x1p1000;
    }
  }

  /// The part of `span` in which the boxes could touch.
  Interval<double> between(const Box<axes>& a, const Box<axes>& b, const Interval<double>& span) const {
    return is_plain_ ? quickly_between(a, b, span) : carefully_between(a, b, span);
  }

  bool is_plain() const { return is_plain_; }
  /// Takes boxes of floats as well. Requires: is_plain().
  template <class AnyBox>
  Interval<double> quickly_between(const AnyBox& a, const AnyBox& b, Interval<double> span) const {
    const auto gap = [](double to, double from) { return to - from; };
    for (int i = 0; i < axes; ++i) {
      const auto j = static_cast<decltype(a.lower.size())>(i);
      const double one = (gap(a.lower[j], b.upper[j]) + below_[i]) * steep_[i];
      const double other = (gap(a.upper[j], b.lower[j]) + above_[i]) * steep_[i];
      span.begin = greater(lesser(one, other), span.begin);
      span.end = lesser(greater(one, other), span.end);
    }
    return span;
  }

 private:
  static Vec<axes> reach(const Box<axes>& box) { return box.lower.abs().max(box.upper.abs()); }

  [[gnu::noinline]] Interval<double> carefully_between(const Box<axes>& a, const Box<axes>& b,
                                                       const Interval<double>& span) const {
    static constexpr Faces faces[] = {{.axis = 0, .below = {0}, .above = {1}},
                                      {.axis = 1, .below = {2}, .above = {3}},
                                      {.axis = 2, .below = {4}, .above = {5}}};
    Bounded limits[2 * axes];
    for (int j = 0; j < axes; ++j) {
      limits[2 * j] = Bounded{b.upper[j]} - Bounded{a.lower[j]} + grown_;
      limits[2 * j + 1] = Bounded{a.upper[j]} - Bounded{b.lower[j]} + grown_;
    }
    return chord_.between(faces, axes, limits, span);
  }

  const Chord<D>& chord_;
  const Bounded grown_;
  double steep_[axes], below_[axes], above_[axes];
  bool is_plain_ = true;
};

/// The child to visit first: the one whose contact could start earlier, or end later.
enum class Order : std::uint8_t { earlier_first, later_first };

/// Node tests of TreeWalk by axis-aligned boxes.
template <int D, class Pieces>
class BoxTests {
 public:
  using Node = typename Pieces::Node;

  /// Pieces and chord must outlive this.
  template <class Sizes>
  BoxTests(const Pieces& a, const Pieces& b, const Chord<D>& chord, const CertainMotion<D>& /*relative*/,
           const Sizes& sizes, double end)
      : a_(a), b_(b), boxes_(chord, a.box(Pieces::root), b.box(Pieces::root), largest(sizes.radius, end)) {}

  /// The part of `queried` in which pieces below the two nodes could touch.
  Interval<double> near(Node a, Node b, const Interval<double>& queried) const {
    return boxes_.between(a_.box(a), b_.box(b), queried);
  }
  /// Whether the first node is the larger.
  bool is_larger(Node a, Node b) const { return margin(a_.box(a)) >= margin(b_.box(b)); }

  const BoxChord<Pieces::axes, D>& boxes() const { return boxes_; }

 private:
  static double margin(const Box<Pieces::axes>& box) { return (box.upper - box.lower).sum(); }

  const Pieces &a_, &b_;
  const BoxChord<Pieces::axes, D> boxes_;
};

/// `Pieces`: of one object, under a tree of boxes on its first axes; further axes are those of upright
/// prisms. `NodeTests`: has the constructor and the functions of BoxTests.
template <int D, class Pieces, class NodeTests = BoxTests<D, Pieces>>
class TreeWalk {
 public:
  /// `queried`: the queried time. `sizes`: the contact distance, and that of prisms along z.
  /// A pair of nodes counts as one step, a pair of pieces as several.
  template <class Sizes>
  TreeWalk(const Pieces& a, const Pieces& b, const CertainMotion<D>& relative,
           const Interval<double>& queried, const Sizes& sizes, Steps& steps)
      : a_(a),
        b_(b),
        chord_(relative, queried.end),
        queried_(overlap_along_z(chord_, queried, sizes)),
        tests_(a, b, chord_, relative, sizes, queried.end),
        near_(tests_.near(Pieces::root, Pieces::root, queried_)),
        steps_(steps) {}

  /// The two objects touch at no time outside of this; never if its end is before its start.
  const Interval<double>& near() const { return near_; }

  /// Calls `visit` for every pair of pieces that could touch, with the time outside of which they do not.
  /// `wanted` is called for each pair of nodes and cuts the descent there when it returns false.
  template <class Wanted, class Visit>
  void visit(Order order, Wanted&& wanted, Visit&& visit) const {
    steps_();
    if (near_.begin <= near_.end) descend({Pieces::root, Pieces::root, near_}, order, wanted, visit);
  }

 private:
  static constexpr int axes = Pieces::axes;
  using Node = typename Pieces::Node;

  struct Nodes {
    Node a, b;
    Interval<double> near;
  };

  /// Requires: the nodes could touch. The caller counts the step of their test.
  template <class Wanted, class Visit>
  void descend(const Nodes& nodes, Order order, Wanted&& wanted, Visit&& visit) const {
    const Interval<double>& near = nodes.near;
    if (!wanted(near)) return;
    if (a_.is_leaf(nodes.a) && b_.is_leaf(nodes.b)) {
      const std::size_t a = a_.item(nodes.a), b = b_.item(nodes.b);
      // Each edge of the two is a condition, whose sign may have to be found exactly.
      steps_.costly(static_cast<unsigned>(8 * (a_.corner_count(a) + b_.corner_count(b))));
      return visit(a, b, near);
    }
    Nodes one = nodes, other = nodes;
    if (splits_a(nodes.a, nodes.b))
      one.a = Pieces::left(nodes.a), other.a = Pieces::right(nodes.a);
    else
      one.b = Pieces::left(nodes.b), other.b = Pieces::right(nodes.b);
    steps_();
    steps_();
    one.near = tests_.near(one.a, one.b, near), other.near = tests_.near(other.a, other.b, near);
    const bool has_one = one.near.begin <= one.near.end, has_other = other.near.begin <= other.near.end;
    if (has_one && has_other) {
      const bool swap =
          order == Order::earlier_first ? other.near.begin < one.near.begin : other.near.end > one.near.end;
      descend(swap ? other : one, order, wanted, visit);
      descend(swap ? one : other, order, wanted, visit);
    } else if (has_one || has_other) {
      descend(has_one ? one : other, order, wanted, visit);
    }
  }

  bool splits_a(Node a, Node b) const {
    if (a_.is_leaf(a) || b_.is_leaf(b)) return b_.is_leaf(b);
    return tests_.is_larger(a, b);
  }

  /// The part of `queried` in which two prisms could overlap along z, whatever their outlines are.
  template <class Sizes>
  static Interval<double> overlap_along_z(const Chord<D>& chord, const Interval<double>& queried,
                                          const Sizes& sizes) {
    if constexpr (D == axes) {
      return queried;
    } else {
      const Faces faces{
          .axis = 2, .below = {0}, .above = {1}, .has_below = sizes.has_below, .has_above = sizes.has_above};
      const Bounded reach[] = {largest(sizes.below, queried.end), largest(sizes.above, queried.end)};
      return chord.between(&faces, 1, reach, queried);
    }
  }

  const Pieces &a_, &b_;
  const Chord<D> chord_;
  const Interval<double> queried_;
  const NodeTests tests_;
  const Interval<double> near_;  ///< of the roots
  Steps& steps_;
};

}  // namespace foresee
