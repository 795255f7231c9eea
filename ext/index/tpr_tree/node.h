// Typed views of a decoded tree node: the objects of a leaf, the entries of an inner node.
//
// An object with a plan (row_layout.h) is a point of the tree: at rest at the start of its first leg, and only for that
// instant. So it widens no bounds, the root knows its t, and no walk returns it. Its legs are in a tree of chunks.
#pragma once

#include <algorithm>
#include <cstring>
#include <utility>

#include "index/pages.h"
#include "index/tpr_tree/moving_box.h"
#include "shape/shapes.h"

namespace foresee {

/// Decodes the records of a leaf.
template <int D>
class LeafReader {
 public:
  explicit LeafReader(const Layout& layout) : at_(record_offsets(layout)), shape_(layout.shape) {}

  std::size_t record_size() const { return static_cast<std::size_t>(at_.size); }

  /// True if no object has a plan, and all are of the same kinds.
  bool is_plain() const { return at_.plan == Offsets::absent && !has_kinds(); }
  /// True for an object with a plan.
  bool is_head(const double* record) const { return has_plan(at_, record); }
  Motion<D> motion(const double* record) const {
    if (is_head(record)) return {t(record), vector(record, at_.x), Vec<D>::zero(), Vec<D>::zero(), t(record)};
    return own_motion(record);
  }
  /// Requires: no head.
  Motion<D> own_motion(const double* record) const {
    Motion<D> motion{t(record), vector(record, at_.x), vector(record, at_.v), vector(record, at_.a),
                     own_until(record)};
    if (at_.force != Offsets::absent) motion.a = vector(record, at_.force) / record[at_.mass];
    return motion;
  }
  Extents<D> extents(const double* record) const {
    return is_head(record) ? Extents<D>::none() : own_extents(record);
  }
  /// Requires: no head.
  Extents<D> own_extents(const double* record) const { return extents_of<D>(shape_, record, at_); }
  Vec<D> growth(const double* record) const { return growth_of<D>(shape_, record, at_); }
  bool grows() const { return at_.growth != Offsets::absent || at_.growth_z != Offsets::absent; }
  Kinds kinds(const double* record) const { return kinds_of(record, at_); }
  bool has_kinds() const { return at_.category != Offsets::absent || at_.mask != Offsets::absent; }
  double t(const double* record) const { return value_or(record, at_.t, 0); }
  double until(const double* record) const { return is_head(record) ? t(record) : own_until(record); }
  /// Requires: no head.
  double own_until(const double* record) const {
    return value_or(record, at_.until, std::numeric_limits<double>::infinity());
  }
  /// False if no object has an end: the table does not declare `until`.
  bool ends() const { return at_.until != Offsets::absent; }
  const double* record(const Node& leaf, std::size_t slot) const {
    return leaf.values.data() + slot * record_size();
  }
  double* record(Node& leaf, std::size_t slot) const { return leaf.values.data() + slot * record_size(); }

 private:
  static Vec<D> vector(const double* record, int place) {
    if (place == Offsets::absent) return Vec<D>::zero();
    return Vec<D>::at(record + place);
  }

  Offsets at_;
  Shape shape_;
};

/// A decoded object.
template <int D>
struct Mover {
  Motion<D> motion;
  Extents<D> extents;  ///< at its t
  Vec<D> growth;
  bool grows;  ///< true if the table has columns of growth
  Kinds kinds;

  Mover(const LeafReader<D>& reader, const double* record)
      : motion(reader.motion(record)),
        extents(reader.extents(record)),
        growth(reader.growth(record)),
        grows(reader.grows()),
        kinds(reader.kinds(record)) {}

  /// As the constructor, without tests of each record. Requires: reader.is_plain().
  static Mover plain(const LeafReader<D>& reader, const double* record) {
    return {reader.own_motion(record), reader.own_extents(record), reader.growth(record), reader.grows()};
  }

  Bounds<D> bounds(double epoch, double pad = rounding_pad) const {
    const Bounds<D> bounds = bounds_at(motion, extents, epoch, pad);
    return grows ? with_growth(bounds, growth, epoch - motion.t, pad) : bounds;
  }
  /// Grown by `margin` on both sides of every axis.
  MovingBox<D> box(const Horizon& horizon, const Vec<D>& margin) const {
    const MovingBox<D> box = moving_box<D>(motion, extents, horizon, margin);
    return grows ? with_growth(box, growth, horizon.now - motion.t) : box;
  }

 private:
  Mover(const Motion<D>& motion, const Extents<D>& extents, const Vec<D>& growth, bool grows)
      : motion(motion), extents(extents), growth(growth), grows(grows) {}
};

/// The time ranges of the objects beneath an entry: of their t, and the max of their until.
struct Times {
  double t_min = std::numeric_limits<double>::infinity();
  double t_max = -std::numeric_limits<double>::infinity();
  double until_max = -std::numeric_limits<double>::infinity();

  void include(const Times& other) {
    t_min = std::min(t_min, other.t_min);
    t_max = std::max(t_max, other.t_max);
    until_max = std::max(until_max, other.until_max);
  }
  bool contains(const Times& other) const {
    return t_min <= other.t_min && other.t_max <= t_max && other.until_max <= until_max;
  }
  friend bool operator==(const Times&, const Times&) = default;
};

/// True if every object beneath has an end.
inline bool ends(const Times& times) {
  return times.until_max < std::numeric_limits<double>::infinity();
}

/// An inner node's entry for one child.
template <int D>
struct Entry {
  Times times;
  Bounds<D> bounds = Bounds<D>::nothing();
  Kinds kinds = Kinds::none();  ///< of all objects beneath, or-ed; bits of others may be set too

  void include(const Entry& other) {
    times.include(other.times);
    bounds.include(other.bounds);
    kinds.include(other.kinds);
  }
  bool contains(const Entry& other) const {
    return times.contains(other.times) && bounds.contains(other.bounds) && kinds.contains(other.kinds);
  }
};

template <int D>
Entry<D> entry_of(const Mover<D>& mover, double epoch) {
  return {{mover.motion.t, mover.motion.t, mover.motion.until}, mover.bounds(epoch), mover.kinds};
}

inline constexpr std::size_t times_size = 3;

template <int D>
Times times_at(const Node& inner, std::size_t slot) {
  const double* from = inner.values.data() + slot * entry_size(D);
  return {from[0], from[1], from[2]};
}

template <int D>
Bounds<D> bounds_at(const Node& inner, std::size_t slot) {
  const double* from = inner.values.data() + slot * entry_size(D) + times_size;
  auto next = [&from] { return Vec<D>::at(std::exchange(from, from + D)); };
  return {next(), next(), next(), next(), next(), next()};
}

template <int D>
Entry<D> entry_at(const Node& inner, std::size_t slot) {
  return {times_at<D>(inner, slot), bounds_at<D>(inner, slot), kinds_at(inner, slot)};
}

/// entry_at() with its bounds carried to another epoch.
template <int D>
Entry<D> entry_at(const Node& inner, std::size_t slot, double epoch) {
  Entry<D> entry = entry_at<D>(inner, slot);
  entry.bounds = carried(entry.bounds, inner.epoch, epoch);
  return entry;
}

template <int D>
void set_entry(Node& inner, std::size_t slot, const Entry<D>& entry) {
  double* to = inner.values.data() + slot * entry_size(D);
  *to++ = entry.times.t_min, *to++ = entry.times.t_max, *to++ = entry.times.until_max;
  for (const Vec<D>* part : {&entry.bounds.x_lower, &entry.bounds.x_upper, &entry.bounds.v_lower,
                             &entry.bounds.v_upper, &entry.bounds.a_lower, &entry.bounds.a_upper})
    to = std::copy_n(part->data(), D, to);
  set_kinds(inner, slot, entry.kinds);
}

template <int D>
void add_entry(Node& inner, NodeNumber child, const Entry<D>& entry) {
  inner.keys.push_back(child);
  inner.values.resize(inner.values.size() + entry_size(D));
  set_entry(inner, inner.size() - 1, entry);
}

/// The slot of `key` in the node. Throws BrokenTree if the node does not have it.
inline std::size_t slot_of(const Node& node, std::int64_t key) {
  const auto found = std::find(node.keys.begin(), node.keys.end(), key);
  if (found == node.keys.end()) throw BrokenTree("a tree node lacks a key that it should hold");
  return static_cast<std::size_t>(found - node.keys.begin());
}

/// A node to be read, with the parent and the level that it must have. read() checks both. Levels decrease
/// strictly and a node has one parent. So every path down the tree ends, and no two paths lead to the same
/// node.
struct Unread {
  static constexpr int any_level = -1;

  NodeNumber number, parent;
  int level;
};

inline bool has_child(const Node& inner, NodeNumber child) {
  return std::find(inner.keys.begin(), inner.keys.end(), child) != inner.keys.end();
}
/// In a damaged file two parents may have the same child, although each node is valid separately.
inline void expect_no_child(const Node& inner, NodeNumber child) {
  if (has_child(inner, child)) throw BrokenTree("a node of a tree has a child twice");
}

inline void expect_below(const Node& node, NodeNumber parent, int level) {
  if (node.parent != parent || (node.level != level && level != Unread::any_level))
    throw BrokenTree("a tree node does not fit below its parent");
}

inline Unread unread_root(NodeSource& source) {
  return {source.find_root(), 0, Unread::any_level};
}
/// `number` is the number of `node`.
inline Unread unread_child(NodeNumber number, const Node& node, std::size_t slot) {
  return {node.keys[slot], number, node.level - 1};
}

inline std::shared_ptr<const Node> read(NodeSource& source, const Unread& unread) {
  auto node = source.read(unread.number);
  expect_below(*node, unread.parent, unread.level);
  return node;
}

inline std::shared_ptr<const Node> read_below(NodeSource& source, NodeNumber number, const Node& node,
                                              std::size_t slot) {
  return read(source, unread_child(number, node, slot));
}

/// The parent of a node; it may lack the child. Null for the root.
inline std::shared_ptr<const Node> read_above(NodeSource& source, NodeNumber number, const Node& node) {
  if (node.parent == 0) {
    if (number != source.find_root()) throw BrokenTree("a tree node has no parent and is not the root");
    return nullptr;
  }
  auto parent = source.read(node.parent);
  if (parent->level != node.level + 1) throw BrokenTree("a tree node does not fit above its child");
  return parent;
}

/// Removes a key and its `stride` values; the last key moves to its slot.
inline void remove_slot(Node& node, std::size_t slot, std::size_t stride) {
  node.keys[slot] = node.keys.back();
  std::copy(node.values.end() - static_cast<std::ptrdiff_t>(stride), node.values.end(),
            node.values.begin() + static_cast<std::ptrdiff_t>(slot * stride));
  if (!node.kinds.empty()) {
    node.kinds[slot] = node.kinds.back();
    node.kinds.pop_back();
  }
  node.keys.pop_back();
  node.values.resize(node.values.size() - stride);
}

/// Adds the times of each object of a leaf, or of each entry of an inner node, to `all`: Times or Lives.
template <int D, class All>
void include_times(const Node& node, const LeafReader<D>& reader, All& all) {
  for (std::size_t slot = 0; slot < node.size(); ++slot) {
    if (!node.is_leaf()) {
      all.include(times_at<D>(node, slot));
      continue;
    }
    const double *record = reader.record(node, slot), t = reader.t(record);
    all.include({t, t, reader.until(record)});
  }
}

/// The times of all objects beneath a node, computed from the node's own numbers.
template <int D>
Times times_of(const Node& node, const LeafReader<D>& reader) {
  Times all;
  include_times(node, reader, all);
  return all;
}

/// The tightest entry for a whole node at `epoch`, computed from the node's own numbers.
template <int D>
Entry<D> summary(const Node& node, const LeafReader<D>& reader, double epoch);

}  // namespace foresee
