// State shared by the operations of a TPR-tree: its pages, a record reader and the write clock, but no nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "index/tpr_tree/reference_times.h"
#include "index/tpr_tree/visit_cost.h"

namespace foresee {

/// The fraction of `horizon` for which the tree's shape is optimized. Queries about a whole horizon are
/// fastest with 0.3 to 0.5, queries about a twentieth of it with 0.1 or less. With 0.15 neither costs much
/// more than its optimum.
inline constexpr double look_ahead = 0.15;

/// The fraction of a leaf that packing fills. Moving objects come and go, so every other write would
/// redistribute leaves without free slots.
inline constexpr double packed_fill = 0.9;

/// When repack_dispersed() examines nodes. Nothing of it is stored.
struct RepackTurns {
  bool are_known = false;
  double changes = 0;             ///< since the last packing
  double visits_when_packed = 0;  ///< of a query beneath the node packed last; 0: not known
};

template <int D>
struct TreeState {
  TreeState(Pages& pages, double horizon) : pages(pages), reader(pages.layout()), horizon(horizon) {}

  Pages& pages;
  LeafReader<D> reader;
  double horizon;
  WriteClock clock;
  RepackTurns repack_turns;

  ReferenceTimes reference_times() const { return ReferenceTimes(clock.now()); }
  /// The epoch of a node with these lives beneath it. Every epoch that is written comes from here.
  double epoch_for(const Lives& beneath) const {
    return reader.ends() ? reference_times().mean_of(beneath) : clock.now();
  }
  double epoch_for(const Node& node) const {
    if (!reader.ends()) return clock.now();
    Lives beneath;
    include_times(node, reader, beneath);
    return epoch_for(beneath);
  }
  VisitCost<D> cost(double epoch) const {
    return {reference_times(), clock.now(), look_ahead * horizon, epoch};
  }
  std::size_t stride(int level) const {
    return level == 0 ? reader.record_size() : static_cast<std::size_t>(entry_size(D));
  }
  std::size_t capacity(int level) const {
    return level == 0 ? pages.leaf_capacity() : pages.inner_capacity();
  }
  /// The number of objects in a packed leaf.
  std::size_t packed_size() const {
    return static_cast<std::size_t>(packed_fill * static_cast<double>(pages.leaf_capacity()));
  }
  /// The typical number of children of an inner node.
  double likely_children() const { return 0.7 * static_cast<double>(pages.inner_capacity()); }
  /// The typical number of objects beneath a node of this level with so many children.
  double likely_objects(int level, double children) const {
    return children * std::pow(likely_children(), level - 1) * static_cast<double>(packed_size());
  }
  /// The highest level whose nodes typically have no more than so many objects; 0: none.
  int highest_level_within(double objects) const {
    int level = 0;
    while (likely_objects(level + 1, likely_children()) <= objects) ++level;
    return level;
  }
  /// The number of leaves for these objects when they are packed.
  std::size_t leaves_for(std::size_t objects) const {
    return objects <= pages.leaf_capacity() ? 1 : (objects + packed_size() - 1) / packed_size();
  }
  /// A node with fewer keys is dissolved, except the root. No split gives a smaller half.
  std::size_t min_size(int level) const { return std::max<std::size_t>(2, capacity(level) / 4); }
};

/// What is added to the tree: an object in a leaf, or a branch in an inner node.
template <int D>
struct NewObject {
  std::int64_t id;
  std::span<const double> record;
  Mover<D> mover;

  Entry<D> entry(double epoch) const { return entry_of(mover, epoch); }
};

template <int D>
struct Branch {
  NodeNumber number;
  NodeNumber parent;  ///< which no longer exists
  int level;          ///< of the node that the branch is added to
  Entry<D> known;
  double epoch;

  Entry<D> entry(double at) const { return {known.times, carried(known.bounds, epoch, at), known.kinds}; }
};

/// The entry of a child, for any max t: that is cheap to update.
template <int D>
Entry<D> entry_without_newest(const Node& parent, NodeNumber child) {
  Entry<D> entry = entry_at<D>(parent, slot_of(parent, child));
  entry.times.t_max = std::numeric_limits<double>::infinity();
  return entry;
}

}  // namespace foresee
