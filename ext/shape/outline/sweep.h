// Plane sweep over the edges and corners of an outline, by exact signs.
//
// The sweep line moves from left to right, and upwards along vertical edges. At each place with corners it
// reports the edges that meet there.
//
//   SweepEdges edges(outline);
//   sweep(edges, [&](const Meeting& m) { … });       // at every place with a corner, ordered by before()
//
// Requires: no edges cross to the left of the last meeting. If that is not known, the caller tests neighbours
// for crossings at each meeting, and ends the sweep by an exception. This suffices: two crossing edges become
// neighbours before the sweep reaches the leftmost crossing (M. I. Shamos, D. Hoey, "Geometric intersection
// problems", FOCS 1976). Corners may lie on edges of other rings. Cost: n log n, some 150 ns per corner.
#pragma once

#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "shape/outline/outline.h"

namespace foresee {

/// The number of an edge is the index of its first corner in the outline.
using EdgeNumber = std::uint32_t;
constexpr EdgeNumber no_edge = std::numeric_limits<EdgeNumber>::max();

struct SweepEdge {
  Corner left, right;        ///< in the order of before()
  std::uint32_t begin, end;  ///< indices of its corners, in the order of the ring
  std::uint32_t ring;
  bool rightwards;  ///< whether the edge starts at `left`

  /// The index of the corner at the left or right end.
  std::uint32_t left_end() const { return rightwards ? begin : end; }
  std::uint32_t right_end() const { return rightwards ? end : begin; }
};

/// The edges of an outline, as sweeps read them. Requires: rings of at least two corners, no corner repeated.
class SweepEdges {
 public:
  explicit SweepEdges(const Outline& outline);

  std::size_t size() const { return edges_.size(); }
  const SweepEdge& operator[](EdgeNumber edge) const { return edges_[edge]; }
  /// The coordinates of a corner.
  const Corner& place_of(std::uint32_t corner) const {
    return edges_[corner].rightwards ? edges_[corner].left : edges_[corner].right;
  }
  /// The edge before this one in its ring.
  EdgeNumber last(EdgeNumber edge) const { return last_[edge]; }
  /// Whether the inside of the edge's ring is above the edge. Requires: a ring that does not cross itself.
  bool encloses_above(EdgeNumber edge) const {
    return edges_[edge].rightwards == counterclockwise_[edges_[edge].ring];
  }

 private:
  std::vector<SweepEdge> edges_;
  std::vector<EdgeNumber> last_;
  std::vector<bool> counterclockwise_;  ///< per ring
};

/// All corners at one place, and the edges there.
struct Meeting {
  Corner place;
  std::vector<std::uint32_t> corners;  ///< by their indices in the outline
  std::vector<EdgeNumber> arriving;    ///< edges from the left, upwards
  std::vector<EdgeNumber> leaving;     ///< edges to the right, upwards; edges that pass are in both
  EdgeNumber below, above;             ///< the edges next to the place, or no_edge
};

/// The edges that the sweep line crosses, upwards.
class SweepLine {
 public:
  explicit SweepLine(const SweepEdges& edges) : edges_(edges), line_(Below{&edges}), places_(edges.size()) {}

  /// Fills in the edges that meet in m.place at m.corners.
  void find_meeting(Meeting& m);
  /// Moves past the meeting: removes arriving edges, inserts leaving ones.
  void pass(const Meeting& m);

 private:
  struct Crossed {
    mutable EdgeNumber edge;  ///< may be replaced by an edge that starts where this one ends
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
  std::vector<Place> places_;  ///< position of each crossed edge
  Place first_, end_;          ///< range of the edges that arrive at the current place
};

/// The corners of the edges in sweep order.
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
