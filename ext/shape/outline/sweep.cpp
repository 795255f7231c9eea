#include "shape/outline/sweep.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace foresee {

SweepEdges::SweepEdges(const Outline& outline) {
  edges_.reserve(outline.corners().size());
  last_.reserve(outline.corners().size());
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const std::span<const Corner> ring = outline.ring(r);
    const auto begin = static_cast<std::uint32_t>(outline.ring_start(r));
    const auto size = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t next = i + 1 == size ? 0 : i + 1;
      const bool rightwards = before(ring[i], ring[next]);
      edges_.push_back({rightwards ? ring[i] : ring[next], rightwards ? ring[next] : ring[i], begin + i,
                        begin + next, static_cast<std::uint32_t>(r), rightwards});
      last_.push_back(begin + (i == 0 ? size : i) - 1);
    }
    counterclockwise_.push_back(is_counterclockwise(ring));
  }
}

/// Compares at the place from which the sweep line crosses both edges.
bool SweepLine::Below::operator()(const Crossed& one, const Crossed& other) const {
  const SweepEdge &a = (*edges)[one.edge], &b = (*edges)[other.edge];
  if (before(b.left, a.left)) {
    const int side = orientation(b.left, b.right, a.left);
    return (side != 0 ? side : orientation(b.left, b.right, a.right)) < 0;
  }
  const int side = orientation(a.left, a.right, b.left);
  return (side != 0 ? side : orientation(a.left, a.right, b.right)) > 0;
}

bool SweepLine::Below::operator()(const Crossed& one, const Corner& place) const {
  const SweepEdge& edge = (*edges)[one.edge];
  return orientation(edge.left, edge.right, place) > 0;
}

bool SweepLine::holds(Place crossed, const Corner& place) const {
  const SweepEdge& edge = edges_[crossed->edge];
  return edge.right == place || orientation(edge.left, edge.right, place) == 0;
}

void SweepLine::find_meeting(Meeting& m) {
  m.arriving.clear();
  m.leaving.clear();
  first_ = line_.end();
  for (const std::uint32_t corner : m.corners)
    for (const EdgeNumber edge : {edges_.last(corner), corner}) {
      if (edges_[edge].left_end() == corner)
        m.leaving.push_back(edge);
      else
        first_ = places_[edge];
    }
  if (first_ == line_.end()) first_ = line_.lower_bound(m.place);
  while (first_ != line_.begin() && holds(std::prev(first_), m.place)) --first_;
  for (end_ = first_; end_ != line_.end() && holds(end_, m.place); ++end_) {
    m.arriving.push_back(end_->edge);
    if (edges_[end_->edge].right != m.place) m.leaving.push_back(end_->edge);
  }
  std::sort(m.leaving.begin(), m.leaving.end(), [&](EdgeNumber a, EdgeNumber b) {
    return orientation(m.place, edges_[a].right, edges_[b].right) > 0;
  });
  m.below = first_ == line_.begin() ? no_edge : std::prev(first_)->edge;
  m.above = end_ == line_.end() ? no_edge : end_->edge;
}

void SweepLine::pass(const Meeting& m) {
  auto next = m.leaving.begin();
  for (; first_ != end_ && next != m.leaving.end(); ++first_, ++next) {
    first_->edge = *next;
    places_[*next] = first_;
  }
  line_.erase(first_, end_);
  for (; next != m.leaving.end(); ++next) places_[*next] = line_.insert(end_, {*next});
}

std::vector<std::uint32_t> sweep_order(const SweepEdges& edges) {
  std::vector<std::uint32_t> order(edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return before(edges.place_of(a), edges.place_of(b)); });
  return order;
}

}  // namespace foresee
