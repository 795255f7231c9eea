// Triangulation of an outline by one plane sweep.
//
// Every gap between two edges that belongs to the region keeps the boundary of its uncut rest: a chain of
// corners that bulges to the right. Each new corner cuts off all triangles that it sees.
//
// As in S. Hertel, K. Mehlhorn, "Fast triangulation of the plane with respect to simple polygons"
// (Information and Control 64, 1985), extended to places where any number of rings touch, at corners and
// along edges.

#include <utility>

#include "shape/outline/convex_pieces.h"
#include "shape/outline/sweep.h"

namespace foresee {

namespace {

constexpr std::uint32_t none = TriangleSide::none;

/// A chain of corners, ordered upwards, each joined to the next by an edge of the outline or by a cut. The
/// rest of the region is to its right; only at its ends may a triangle still be cut off.
struct Chain {
  std::uint32_t front = none, back = none;  ///< indices of links
  std::uint32_t last = none;                ///< the newest link: visible from every corner that may come next
};

class Triangulator {
 public:
  explicit Triangulator(const Outline& outline)
      : corners_(outline.corners()), edges_(outline), hole_(outline.rings(), true), gaps_(edges_.size()) {
    for (std::size_t part = 0; part < outline.parts(); ++part) hole_[outline.part_start(part)] = false;
    sides_.reserve(3 * (corners_.size() + 2 * outline.rings()));
    sweep(edges_, [this](const Meeting& m) { meet(m); });
  }

  std::vector<TriangleSide> sides() && { return std::move(sides_); }

 private:
  /// A corner in a chain.
  struct Link {
    std::uint32_t corner;
    std::uint32_t down, up;
    std::uint32_t cut;  ///< the cut to the next link up; none: an edge of the outline
  };

  bool region_above(EdgeNumber edge) const {
    return edge != no_edge && edges_.encloses_above(edge) != hole_[edges_[edge].ring];
  }

  void meet(const Meeting& m) {
    const std::uint32_t corner = m.corners.front();
    if (m.arriving.empty()) {
      if (region_above(m.below)) gaps_[m.leaving.back()] = split(gaps_[m.below], corner);
    } else {
      arrive(m, corner);
    }
    for (std::size_t i = 0; i + 1 < m.leaving.size(); ++i)
      if (region_above(m.leaving[i])) {
        const std::uint32_t link = add_link(corner, none, none, none);
        gaps_[m.leaving[i]] = {link, link, link};
      }
  }

  /// Gaps between arriving edges end here; the gaps beside them continue, merged if no edge leaves.
  void arrive(const Meeting& m, std::uint32_t corner) {
    for (const EdgeNumber edge : m.arriving)
      if (region_above(edge)) add_front(gaps_[edge], corner, none);
    if (region_above(m.below)) add_back(gaps_[m.below], corner, none);
    if (!region_above(m.arriving.back())) return;
    const Chain above = gaps_[m.arriving.back()];
    if (m.leaving.empty())
      join(gaps_[m.below], above);
    else
      gaps_[m.leaving.back()] = above;
  }

  /// Splits the chain at its newest link: keeps the lower half in `chain`, returns the upper one. A cut from
  /// that link to `corner` is the end of the lower half and the start of the upper.
  Chain split(Chain& chain, std::uint32_t corner) {
    const std::uint32_t at = chain.last, cut = add_cut(none);
    const std::uint32_t copy = add_link(links_[at].corner, none, links_[at].up, links_[at].cut);
    Chain upper{copy, chain.back == at ? copy : chain.back, copy};
    links_[at].up = none;
    chain.back = at;
    add_back(chain, corner, cut);
    add_front(upper, corner, cut);
    return upper;
  }

  /// Appends `upper` to `lower`: the last corner of the lower is the first of the upper.
  void join(Chain& lower, const Chain& upper) {
    Link& at = links_[lower.back];
    at.up = links_[upper.front].up, at.cut = links_[upper.front].cut;
    links_[at.up].down = lower.back;
    lower.back = upper.back;
  }

  /// Adds a corner in front, joined by `cut` or by an edge of the outline.
  void add_front(Chain& chain, std::uint32_t corner, std::uint32_t cut) {
    std::uint32_t front = chain.front;
    for (; front != chain.back; front = links_[front].up) {
      const std::uint32_t lower = links_[front].corner, upper = links_[links_[front].up].corner;
      if (side_of(lower, corner, upper) <= 0) break;
      cut = cut_off(lower, corner, upper, cut, links_[front].cut);
    }
    chain.front = chain.last = add_link(corner, none, front, cut);
  }

  void add_back(Chain& chain, std::uint32_t corner, std::uint32_t cut) {
    std::uint32_t back = chain.back;
    for (; back != chain.front; back = links_[back].down) {
      const Link& below = links_[links_[back].down];
      const std::uint32_t upper = links_[back].corner;
      if (side_of(upper, below.corner, corner) <= 0) break;
      cut = cut_off(upper, below.corner, corner, below.cut, cut);
    }
    chain.back = chain.last = add_link(corner, back, none, none);
    links_[back].up = chain.back, links_[back].cut = cut;
  }

  int side_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orientation(corners_[a], corners_[b], corners_[c]);
  }

  /// Adds the triangle a, b, c, whose sides a b and c a are known. Returns the new cut b c.
  std::uint32_t cut_off(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t cut_ab,
                        std::uint32_t cut_ca) {
    const auto side = static_cast<std::uint32_t>(sides_.size());
    for (const std::uint32_t corner : {a, b, c}) sides_.push_back({corner});
    lay_along(cut_ab, side);
    lay_along(cut_ca, side + 2);
    return add_cut(side + 1);
  }

  void lay_along(std::uint32_t cut, std::uint32_t side) {
    if (cut == none) return;
    const std::uint32_t other = std::exchange(cuts_[cut], side);
    if (other != none) sides_[side].twin = other, sides_[other].twin = side;
  }

  std::uint32_t add_cut(std::uint32_t side) {
    cuts_.push_back(side);
    return static_cast<std::uint32_t>(cuts_.size() - 1);
  }

  /// Adds a link and connects the one above to it; the caller connects the one below.
  std::uint32_t add_link(std::uint32_t corner, std::uint32_t down, std::uint32_t up, std::uint32_t cut) {
    links_.push_back({corner, down, up, cut});
    const auto link = static_cast<std::uint32_t>(links_.size() - 1);
    if (up != none) links_[up].down = link;
    return link;
  }

  std::span<const Corner> corners_;
  const SweepEdges edges_;
  std::vector<bool> hole_;           ///< per ring
  std::vector<Chain> gaps_;          ///< per edge below the gap
  std::vector<Link> links_;          ///< of all chains
  std::vector<std::uint32_t> cuts_;  ///< the side along each cut, or none yet
  std::vector<TriangleSide> sides_;
};

}  // namespace

std::vector<TriangleSide> triangulation(const Outline& outline) {
  return Triangulator(outline).sides();
}

}  // namespace foresee
