#include "shape/outline/triangulation.h"

#include <utility>

#include "shape/outline/sweep.h"

namespace foresee {

namespace {

constexpr std::uint32_t none = TriangleSide::none;

/// Corners joined upwards, each to the next by an edge of the outline or by a cut. What is left of the region
/// is to the right, and at no corner but the ends could a triangle be cut off.
struct Chain {
  std::uint32_t front = none, back = none;  ///< places among the links
  std::uint32_t last = none;                ///< that which came last: seen from all that is to come next
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
    std::uint32_t cut;  ///< what joins it to the next one up; none: an edge of the outline
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

  /// Gaps between edges that arrive end here; those beside them go on, as one if nothing leaves.
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

  /// The chain in two, where it came last: the lower stays, the upper is returned. A cut from there to
  /// `corner` ends the one and begins the other.
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

  /// One chain of two: the last corner of the lower is the first of the upper.
  void join(Chain& lower, const Chain& upper) {
    Link& at = links_[lower.back];
    at.up = links_[upper.front].up, at.cut = links_[upper.front].cut;
    links_[at.up].down = lower.back;
    lower.back = upper.back;
  }

  /// `cut` joins the corner to the front, or an edge of the outline does.
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

  /// The triangle a, b, c, of which a b and c a are known. The cut that b c is.
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

  /// The link above knows it; that below is for the caller.
  std::uint32_t add_link(std::uint32_t corner, std::uint32_t down, std::uint32_t up, std::uint32_t cut) {
    links_.push_back({corner, down, up, cut});
    const auto link = static_cast<std::uint32_t>(links_.size() - 1);
    if (up != none) links_[up].down = link;
    return link;
  }

  std::span<const Corner> corners_;
  const SweepEdges edges_;
  std::vector<bool> hole_;           ///< by ring
  std::vector<Chain> gaps_;          ///< by the edge below
  std::vector<Link> links_;          ///< of all chains
  std::vector<std::uint32_t> cuts_;  ///< the side that lies along each, or none yet
  std::vector<TriangleSide> sides_;
};

}  // namespace

std::vector<TriangleSide> triangulation(const Outline& outline) {
  return Triangulator(outline).sides();
}

}  // namespace foresee
