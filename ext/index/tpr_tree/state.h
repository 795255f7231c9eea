// What the parts of the tree share: its pages, how to read a record, the clock. Nothing about nodes.
#pragma once

#include "index/tpr_tree/clock.h"
#include "index/tpr_tree/cost.h"
#include "index/tpr_tree/node.h"

namespace foresee {

/// The part of `horizon` that the tree's shape looks ahead. Questions about a whole horizon are served best
/// by 0.3 to 0.5, those about a twentieth by 0.1 or less; at 0.15 neither costs much more than it has to.
inline constexpr double look_ahead = 0.15;

/// The part of a leaf that is filled where leaves are packed. Objects that move come and go: leaves without
/// room would be shared out anew by every other write.
inline constexpr double packed_fill = 0.9;

template <int D>
struct TreeState {
  TreeState(Pages& pages, double horizon) : pages(pages), reader(pages.layout()), horizon(horizon) {}

  Pages& pages;
  LeafReader<D> reader;
  double horizon;
  WriteClock clock;

  VisitCost<D> cost(double epoch) const { return {clock.now(), look_ahead * horizon, epoch}; }
  std::size_t stride(int level) const {
    return level == 0 ? reader.record_size() : static_cast<std::size_t>(entry_size(D));
  }
  std::size_t capacity(int level) const {
    return level == 0 ? pages.leaf_capacity() : pages.inner_capacity();
  }
  /// Objects of a leaf that was packed.
  std::size_t packed_size() const {
    return static_cast<std::size_t>(packed_fill * static_cast<double>(pages.leaf_capacity()));
  }
  /// How many leaves so many objects are packed into.
  std::size_t leaves_for(std::size_t objects) const {
    return objects <= pages.leaf_capacity() ? 1 : (objects + packed_size() - 1) / packed_size();
  }
  /// A node with fewer keys is dissolved, the root excepted. At most the smaller half of any split.
  std::size_t least_size(int level) const { return std::max<std::size_t>(2, capacity(level) / 4); }
};

/// Something that gets a place in the tree: an object in a leaf, or a branch in an inner node.
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
  NodeNumber parent;  ///< which is gone
  int level;          ///< of the node it goes into
  Entry<D> known;
  double epoch;

  Entry<D> entry(double at) const { return {known.times, carried(known.bounds, epoch, at)}; }
};

}  // namespace foresee
