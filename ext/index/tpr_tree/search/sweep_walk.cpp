// Padding of swept bounds, so that they contain the swept boxes of all objects beneath a node.
//
// swept_box() rounds outward by less than 36 units of 2^-53 of the terms of an object's box. These are |x| at its own
// t, and its velocity and acceleration over the time between that t and the horizon. The bounds of a node
// contain its objects' real faces, but at another time, at which those magnitudes may have cancelled. The
// node's own numbers bound the terms. Let R be an upper bound, in seconds, of the time from the epoch to any
// t beneath the node, and from there to the horizon. Then |x| + |v| R + |a| R^2 at t is at most
// X + 2 V R + 3 A R^2 of the node. This file adds 64 units of that, and of the margin. If a shape is far from
// its position, its extents cancel |x|. There the bounds themselves are wide enough: bounds_at() pads by 32
// units of both, and errs by 8.
#include "index/tpr_tree/search/sweep_walk.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

constexpr double reach_pad = 0x1p-47;  // 64 units

double farthest(double time, const Times& times) {
  return std::max(std::abs(time - times.t_min), std::abs(time - times.t_max));
}

/// A box that contains the swept boxes of all objects beneath an entry; an unbounded face is infinite or NaN.
template <int D>
Box<D> swept_bounds(const Node& inner, std::size_t slot, const Horizon& horizon, const Vec<D>& margin) {
  const MovingBox<D> box = child_box<D>(inner, slot, horizon);
  if (box.span.is_empty()) return Box<D>::empty();
  const Times times = times_at<D>(inner, slot);
  const Bounds<D> bounds = bounds_at<D>(inner, slot);
  const double reach =
      farthest(inner.epoch, times) + farthest(horizon.now, times) + horizon.h + shortest_reach;
  const Vec<D> size = bounds.x_lower.abs().max(bounds.x_upper.abs()) + margin +
                      2 * reach * bounds.v_lower.abs().max(bounds.v_upper.abs()) +
                      3 * reach * (reach * bounds.a_lower.abs().max(bounds.a_upper.abs()));
  const Vec<D> more = margin + (size * reach_pad + (1 + reach) * smallest_pad);
  const double first = box.span.begin, last = box.span.end;
  return {(box.lower + box.v_lower * first).min(box.lower + box.v_lower * last) - more,
          (box.upper + box.v_upper * first).max(box.upper + box.v_upper * last) + more};
}

}  // namespace

template <int D>
SweepWalk<D>::SweepWalk(NodeSource& source, const Box<D>& query, const Horizon& horizon, const Vec<D>& margin,
                        Interrupt& interrupt)
    : source_(source), interrupt_(interrupt), query_(query), horizon_(horizon), margin_(margin) {
  if (source.find_root() != 0) open_.push_back(unread_root(source));
}

template <int D>
std::shared_ptr<const Node> SweepWalk<D>::next() {
  while (!open_.empty()) {
    interrupt_.check();
    const Unread open = open_.back();
    open_.pop_back();
    auto node = read(source_, open);
    if (node->is_leaf()) return node;
    open_children(open.number, *node, open_);
  }
  return nullptr;
}

template <int D>
double SweepWalk<D>::likely_share() {
  constexpr std::size_t enough = 64;
  double share = 1;
  std::vector<Unread> level = open_, below;
  while (!level.empty() && level.size() < enough) {
    std::size_t children = 0;
    below.clear();
    for (const Unread& open : level) {
      interrupt_.check();
      const auto node = read(source_, open);
      if (node->is_leaf()) return share;
      children += node->size();
      open_children(open.number, *node, below);
    }
    share *= static_cast<double>(below.size()) / static_cast<double>(std::max<std::size_t>(1, children));
    if (children >= enough) break;
    level.swap(below);
  }
  return share;
}

template <int D>
[[gnu::flatten]] bool SweepWalk<D>::meets(const Node& inner, std::size_t slot) const {
  const Box<D> box = swept_bounds<D>(inner, slot, horizon_, margin_);
  for (int axis = 0; axis < D; ++axis)
    if (box.lower[axis] > query_.upper[axis] || box.upper[axis] < query_.lower[axis]) return false;
  return true;
}

template <int D>
void SweepWalk<D>::open_children(NodeNumber number, const Node& inner, std::vector<Unread>& open) const {
  for (std::size_t slot = 0; slot < inner.size(); ++slot)
    if (meets(inner, slot)) open.push_back(unread_child(number, inner, slot));
}

template class SweepWalk<1>;
template class SweepWalk<2>;
template class SweepWalk<3>;

}  // namespace foresee
