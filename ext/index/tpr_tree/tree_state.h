// What the parts of the tree share: its pages, how to read a record, the clock. Nothing about nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "index/tpr_tree/node.h"
#include "index/tpr_tree/visit_cost.h"

namespace foresee {

// What time is it in this table? Objects are mostly written with the current time as their t, but some are
// scheduled for later and some come late, so the clock is the median t of the last writes.
//
// Only the tree's shape depends on it, never an answer.

class WriteClock {
 public:
  /// How many writes it knows of.
  static constexpr std::size_t memory = 15;

  double now() const { return now_; }
  /// False until something has been written.
  bool runs() const { return count_ > 0; }

  /// An object with this t is being written. A fresh clock believes its first write.
  void observe(double t) {
    if (count_ == 0) recent_.fill(t);
    recent_[count_++ % recent_.size()] = t;
    if (t == now_ && count_ > 1) return;
    auto sorted = recent_;
    std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
    now_ = sorted[sorted.size() / 2];
  }
  /// A whole table was written, with `t` as its typical time.
  void set(double t) { recent_.fill(t), now_ = t, count_ = recent_.size(); }

 private:
  std::array<double, memory> recent_{};
  std::size_t count_ = 0;
  double now_ = 0;
};

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
  std::size_t min_size(int level) const { return std::max<std::size_t>(2, capacity(level) / 4); }
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
