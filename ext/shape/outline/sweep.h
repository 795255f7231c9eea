// In which order does a line that sweeps over an outline meet its edges and corners? From left to right, and
// upwards along what stands upright; at each place where corners are, it says which edges meet there.
//
//   SweepEdges edges(outline);
//   sweep(edges, [&](const Meeting& m) { … });       // at every place with a corner, ordered by before()
//
// All by exact signs. Requires: edges cross nowhere to the left of the last meeting; whoever does not know
// that looks at each meeting for neighbours that cross, which some pair does before its crossing is reached,
// and ends the sweep by an exception (M. I. Shamos, D. Hoey, "Geometric intersection problems", FOCS 1976).
// Corners may lie on edges of other rings. Cost: n log n, some 150 ns a corner.
#pragma once

#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "shape/outline/orientation.h"

namespace foresee {

/// An edge goes by the place of the corner at which it begins, among the corners of the outline.
using EdgeNumber = std::uint32_t;
constexpr EdgeNumber no_edge = std::numeric_limits<EdgeNumber>::max();

struct SweepEdge {
  Corner left, right;        ///< in the order of before()
  std::uint32_t begin, end;  ///< its corners in the order of the ring
  std::uint32_t ring;
  bool rightwards;  ///< it begins at `left`

  /// The corner, by its place in the outline, that is its left or right end.
  std::uint32_t left_end() const { return rightwards ? begin : end; }
  std::uint32_t right_end() const { return rightwards ? end : begin; }
};

/// The edges of an outline, as sweeps see them. Requires: rings of two corners or more, without repeated
/// ones.
class SweepEdges {
 public:
  explicit SweepEdges(const Outline& outline);

  std::size_t size() const { return edges_.size(); }
  const SweepEdge& operator[](EdgeNumber edge) const { return edges_[edge]; }
  /// Where a corner is.
  const Corner& place_of(std::uint32_t corner) const {
    return edges_[corner].rightwards ? edges_[corner].left : edges_[corner].right;
  }
  /// The edge that ends where this one begins.
  EdgeNumber last(EdgeNumber edge) const { return last_[edge]; }
  /// Whether what the ring of the edge encloses is above the edge. Requires: a ring that does not cross
  /// itself.
  bool encloses_above(EdgeNumber edge) const {
    return edges_[edge].rightwards == counterclockwise_[edges_[edge].ring];
  }

 private:
  std::vector<SweepEdge> edges_;
  std::vector<EdgeNumber> last_;
  std::vector<bool> counterclockwise_;  ///< by ring
};

/// Some corners in one place, and the edges there.
struct Meeting {
  Corner place;
  std::vector<std::uint32_t> corners;  ///< by their places in the outline
  std::vector<EdgeNumber> arriving;    ///< that come from the left, upwards
  std::vector<EdgeNumber> leaving;     ///< that go on to the right, upwards; what passes is among both
  EdgeNumber below, above;             ///< the edges next to the place, or no_edge
};

/// The edges that the sweeping line crosses, upwards.
class SweepLine {
 public:
  explicit SweepLine(const SweepEdges& edges) : edges_(edges), line_(Below{&edges}), places_(edges.size()) {}

  /// Fills in what meets in m.place at m.corners.
  void find_meeting(Meeting& m);
  /// Moves on: what arrives goes, what leaves comes.
  void pass(const Meeting& m);

 private:
  struct Crossed {
    mutable EdgeNumber edge;  ///< another may take its place, where the one ends and the other begins
  };
  struct Below {
    using is_transparent = void;
    bool operator()(const Crossed& a, const Crossed& b) const;
    bool operator()(const Crossed& a, const Corner& place) const;
    const SweepEdges* edges;
  };
  using Line = std::set<Crossed, Below>;
  using Place = Line::iterator;

  bool holds(Place crossed, const Corner& place) const;

  const SweepEdges& edges_;
  Line line_;
  std::vector<Place> places_;  ///< of each edge that is crossed
  Place first_, end_;          ///< what arrives at the place looked at
};

/// The corners of the edges in the order of a sweep.
std::vector<std::uint32_t> sweep_order(const SweepEdges& edges);

template <class Visit>
void sweep(const SweepEdges& edges, Visit&& visit) {
  SweepLine line(edges);
  Meeting m;
  const std::vector<std::uint32_t> order = sweep_order(edges);
  for (auto next = order.begin(); next != order.end();) {
    m.place = edges.place_of(*next);
    m.corners.clear();
    while (next != order.end() && edges.place_of(*next) == m.place) m.corners.push_back(*next++);
    line.find_meeting(m);
    visit(std::as_const(m));
    line.pass(m);
  }
}

}  // namespace foresee
