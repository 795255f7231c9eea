#include "shape/outline/validity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "shape/outline/sweep.h"
#include "shape/outline/wkt.h"

namespace foresee {

namespace {

std::size_t ring_of(const Outline& outline, std::uint32_t corner) {
  std::size_t ring = 0;
  while (outline.ring_start(ring + 1) <= corner) ++ring;
  return ring;
}

/// "(0 0, 2 2)"
std::string shown_edge(const Outline& outline, std::uint32_t begin) {
  const std::size_t ring = ring_of(outline, begin);
  const bool last = begin + 1 == outline.ring_start(ring + 1);
  const std::size_t end = last ? outline.ring_start(ring) : begin + 1;
  return '(' + shown(outline.corners()[begin]) + ", " + shown(outline.corners()[end]) + ')';
}

/// "edges (0 0, 2 2) and (2 0, 0 2)"
std::string both_edges(const Flaw& flaw, const Outline& outline) {
  return "edges " + shown_edge(outline, flaw.a) + " and " + shown_edge(outline, flaw.b);
}

/// What is wrong with the outline rotated by `heading` degrees.
std::string shown_turned(const Flaw& flaw, const Outline& outline, double heading) {
  const std::string turned = "turned by " + shown(heading) + " degrees ";
  if (flaw.kind == Flaw::Kind::edge_touch)
    return turned + "its rings no longer touch at (" + shown(flaw.place) +
           "): write this point as a corner of both rings";
  if (flaw.kind == Flaw::Kind::few_corners || flaw.kind == Flaw::Kind::no_area)
    return turned + name_of_ring(outline, ring_of(outline, flaw.a)) +
           " encloses no area: its corners are closer than doubles resolve";
  return turned + "its " + both_edges(flaw, outline) + " touch: they are closer than doubles resolve";
}

/// Thrown to end the sweep at the first flaw.
struct FlawFound {
  Flaw flaw;
};

/// Checks every meeting of a sweep for flaws.
class Validity {
 public:
  /// Requires: rings of at least three corners.
  explicit Validity(const Outline& outline)
      : outline_(outline),
        edges_(outline),
        ring_of_part_(outline.rings()),
        within_(outline.rings(), unknown) {
    for (std::uint32_t part = 0, ring = 0; part < outline.parts(); ++part)
      for (const std::uint32_t first = ring; ring < outline.part_start(part + 1); ++ring)
        ring_of_part_[ring] = first;
  }

  /// Throws FlawFound.
  void check() {
    sweep(edges_, [this](const Meeting& m) {
      check_overlap(m);
      if (m.arriving.size() + m.leaving.size() > 2) check_touch(m);
      check_crossings(m);
      for (std::size_t i = 0; i < m.leaving.size(); ++i)
        check_ring(m.leaving[i], i == 0 ? m.below : m.leaving[i - 1]);
    });
  }

  const std::optional<Flaw>& edge_touch() const { return edge_touch_; }

 private:
  static constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max(), nothing = unknown - 1;

  /// One of two edges by which a ring visits a place.
  struct Spoke {
    EdgeNumber edge;
    std::uint32_t visit;  ///< number of the ring's corner there, or of the edge that passes
  };

  /// Throws a flaw between two edges; the one written first becomes `a`.
  [[noreturn]] static void fail(Flaw::Kind kind, EdgeNumber a, EdgeNumber b, const Corner& place = {}) {
    throw FlawFound{{kind, std::min(a, b), std::max(a, b), place}};
  }

  /// Edges in the same direction from here: any two that overlap do so from the start of the second.
  void check_overlap(const Meeting& m) const {
    for (std::size_t i = 0; i + 1 < m.leaving.size(); ++i) {
      const EdgeNumber a = m.leaving[i], b = m.leaving[i + 1];
      if (orientation(m.place, edges_[a].right, edges_[b].right) != 0) continue;
      fail(on_one_line(edges_[a].ring) ? Flaw::Kind::no_area : Flaw::Kind::overlap, a, b);
    }
  }

  bool on_one_line(std::uint32_t ring) const {
    const std::span<const Corner> corners = outline_.ring(ring);
    return std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
      return orientation(corners[0], corners[1], corner) == 0;
    });
  }

  /// The edges around a place, counterclockwise from the downward direction.
  std::vector<Spoke> spokes_of(const Meeting& m) const {
    std::vector<Spoke> spokes;
    const auto size = static_cast<std::uint32_t>(edges_.size());
    const auto passes = [&](const SweepEdge& edge) { return edge.left != m.place && edge.right != m.place; };
    for (const EdgeNumber edge : m.leaving)
      spokes.push_back({edge, passes(edges_[edge]) ? size + edge : edges_[edge].left_end()});
    for (auto edge = m.arriving.rbegin(); edge != m.arriving.rend(); ++edge)
      spokes.push_back({*edge, passes(edges_[*edge]) ? size + *edge : edges_[*edge].right_end()});
    return spokes;
  }

  /// Checks a place that several rings visit, or one ring twice.
  void check_touch(const Meeting& m) {
    std::vector<Spoke> spokes = spokes_of(m);
    check_nesting(spokes);
    std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
      return std::pair(edges_[a.edge].ring, a.visit) < std::pair(edges_[b.edge].ring, b.visit);
    });
    for (std::size_t i = 2; i < spokes.size(); i += 2)
      if (edges_[spokes[i].edge].ring == edges_[spokes[i - 2].edge].ring)
        fail(Flaw::Kind::self_touch, spokes[i - 2].edge, spokes[i].edge, m.place);
    const auto passing = std::find_if(spokes.begin(), spokes.end(),
                                      [&](const Spoke& spoke) { return spoke.visit >= edges_.size(); });
    if (passing == spokes.end() || edge_touch_) return;
    const Spoke& other = passing == spokes.begin() ? spokes.back() : spokes.front();
    edge_touch_ = Flaw{Flaw::Kind::edge_touch, passing->edge, other.edge, m.place};
  }

  /// Visits that do not cross nest like brackets: the last one opened is the first one closed.
  static void check_nesting(const std::vector<Spoke>& spokes) {
    std::vector<Spoke> open;
    for (const Spoke& spoke : spokes) {
      if (!open.empty() && open.back().visit == spoke.visit)
        open.pop_back();
      else
        open.push_back(spoke);
    }
    // Among the remaining visits, the one with the nearest spokes has a spoke of another visit between them.
    std::map<std::uint32_t, std::size_t> opened;
    std::size_t nearest = open.size(), at = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const auto [first, is_first] = opened.try_emplace(open[i].visit, i);
      if (!is_first && i - first->second < nearest) nearest = i - first->second, at = first->second;
    }
    if (!open.empty()) fail(Flaw::Kind::cross, open[at].edge, open[at + 1].edge);
  }

  /// Checks edges that become neighbours here for crossings.
  void check_crossings(const Meeting& m) const {
    if (m.leaving.empty()) return check_crossing(m.below, m.above);
    check_crossing(m.below, m.leaving.front());
    check_crossing(m.leaving.back(), m.above);
  }

  void check_crossing(EdgeNumber one, EdgeNumber other) const {
    if (one == no_edge || other == no_edge) return;
    const SweepEdge &a = edges_[one], &b = edges_[other];
    const auto separated = [](const SweepEdge& edge, const SweepEdge& by) {
      return orientation(by.left, by.right, edge.left) * orientation(by.left, by.right, edge.right) < 0;
    };
    if (separated(a, b) && separated(b, a)) fail(Flaw::Kind::cross, one, other);
  }

  /// Called at the leftmost corner of a ring: finds and checks the ring around it. `below`: the next edge
  /// below.
  void check_ring(EdgeNumber edge, EdgeNumber below) {
    const std::uint32_t ring = edges_[edge].ring;
    if (within_[ring] != unknown) return;
    std::uint32_t around = nothing;
    if (below != no_edge)
      around = edges_.encloses_above(below) ? edges_[below].ring : within_[edges_[below].ring];
    within_[ring] = around;
    const bool hole = ring_of_part_[ring] != ring;
    const auto fail_ring = [&](Flaw::Kind kind) {
      const std::size_t begin = around == nothing ? 0 : outline_.ring_start(around);
      throw FlawFound{{kind, edge, static_cast<EdgeNumber>(begin), {}}};
    };
    if (hole && around == nothing) fail_ring(Flaw::Kind::hole_outside);
    if (hole && around != ring_of_part_[ring]) fail_ring(Flaw::Kind::hole_inside);
    if (!hole && around != nothing && around == ring_of_part_[around]) fail_ring(Flaw::Kind::part_inside);
  }

  const Outline& outline_;
  const SweepEdges edges_;
  std::vector<std::uint32_t> ring_of_part_;  ///< per ring: the outer ring of its part
  std::vector<std::uint32_t> within_;        ///< per ring: the innermost ring around it, or nothing
  std::optional<Flaw> edge_touch_;
};

std::optional<Flaw> ring_of_few_corners(const Outline& outline) {
  for (std::size_t r = 0; r < outline.rings(); ++r)
    if (outline.ring(r).size() < 3) {
      const auto begin = static_cast<std::uint32_t>(outline.ring_start(r));
      return Flaw{Flaw::Kind::few_corners, begin, begin, {}};
    }
  return std::nullopt;
}

}  // namespace

std::string shown(const Flaw& flaw, const Outline& outline) {
  const auto ring = [&](std::uint32_t edge) { return name_of_ring(outline, ring_of(outline, edge)); };
  const std::string place = '(' + shown(flaw.place) + ')';
  switch (flaw.kind) {
    case Flaw::Kind::few_corners:
      return ring(flaw.a) + " has fewer than three corners";
    case Flaw::Kind::no_area:
      return ring(flaw.a) + " encloses no area: its corners lie on one line";
    case Flaw::Kind::cross:
      return both_edges(flaw, outline) + " cross";
    case Flaw::Kind::overlap:
      return both_edges(flaw, outline) + " overlap";
    case Flaw::Kind::self_touch:
      return ring(flaw.a) + " touches itself at " + place + ": write a ring for each loop";
    case Flaw::Kind::edge_touch:
      return both_edges(flaw, outline) + " touch at " + place +
             ": write this point as a corner of both rings";
    case Flaw::Kind::hole_outside:
      return ring(flaw.a) + " is a hole but lies outside its part";
    case Flaw::Kind::hole_inside:
      return ring(flaw.a) + " is a hole but lies within " + ring(flaw.b);
    case Flaw::Kind::part_inside:
      return ring(flaw.a) + " lies within " + ring(flaw.b) + ": write parts that lie apart";
  }
  return {};
}

std::optional<Flaw> flaw_of(const Outline& outline) {
  const FloatEnvironment environment;
  if (outline.rings() == 1 && convex_direction(outline.corners()) != 0) return std::nullopt;
  if (const auto flaw = ring_of_few_corners(outline)) return flaw;
  try {
    Validity(outline).check();
  } catch (const FlawFound& found) {
    return found.flaw;
  }
  return std::nullopt;
}

void check_outline(const Outline& outline) {
  if (const auto flaw = flaw_of(outline)) throw Error(shown(*flaw, outline));
}

std::optional<Flaw> edge_touch_of(const Outline& outline) {
  if (outline.rings() == 1) return std::nullopt;
  const FloatEnvironment environment;
  Validity validity(outline);
  validity.check();
  return validity.edge_touch();
}

void check_turned(const Outline& outline, const std::optional<Flaw>& edge_touch, const Outline& turned,
                  double heading) {
  if (std::fmod(heading, 90) == 0) return;
  if (edge_touch) throw Error(shown_turned(*edge_touch, outline, heading));
  const auto flaw = flaw_of(turned);
  if (!flaw) return;
  const bool same_places = outline.corners().size() == turned.corners().size();
  throw Error(shown_turned(*flaw, same_places ? outline : turned, heading));
}

}  // namespace foresee
