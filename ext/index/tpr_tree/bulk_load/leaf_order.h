// Order of objects in the leaves of a bulk load: top-down halving by position, velocity and time (OMT). So the
// objects of a leaf are near each other now and later, and exist at about the same time.
//
// The objects are halved recursively at a boundary between nodes, of the highest level that has one near the
// middle. Each cut is along the axis of position, velocity or time with the largest spread
// (leaf_order_items.h). The spread is the distance between the first and the last tenth of a sample, so a few
// outliers do not change it. A cut in time leaves objects of equal time on one side. Objects far larger or
// faster than the median come last, in their own leaves. Objects without an end do not share leaves with those
// that end. Objects that may meet none of the others (shape/kinds.h) have leaves of their own, which a join
// does not read.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/error.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// The number of nodes on each level of a tree with `leaves` leaves, from the leaves up to the root.
std::vector<std::size_t> level_sizes(std::size_t leaves, std::size_t inner_capacity);

/// The first child of a parent, if `children` are distributed evenly over `parents`.
inline std::size_t first_child(std::size_t parent, std::size_t parents, std::size_t children) {
  return parent / parents * children + parent % parents * children / parents;
}

/// The section of an order that belongs to one of `parents`.
inline std::span<const std::uint32_t> part_of(std::span<const std::uint32_t> order, std::size_t parent,
                                              std::size_t parents) {
  const std::size_t first = first_child(parent, parents, order.size());
  return order.subspan(first, first_child(parent + 1, parents, order.size()) - first);
}

/// A leaf with the objects at these places; `size` is the number of doubles per record.
inline Node objects_at(std::span<const std::uint32_t> places, std::span<const std::int64_t> ids,
                       std::span<const double> records, std::size_t size) {
  Node leaf;
  leaf.keys.reserve(places.size());
  leaf.values.reserve(places.size() * size);
  for (const std::uint32_t place : places) {
    const auto record = records.subspan(place * size, size);
    leaf.keys.push_back(ids[place]);
    leaf.values.insert(leaf.values.end(), record.begin(), record.end());
  }
  return leaf;
}

/// A range of consecutive leaves.
struct LeafRange {
  std::size_t first, count;
};

/// Record indices in the order of these leaves of the tree. The i-th leaf holds places first_child(i, count,
/// objects) up to that of i + 1.
template <int D>
std::vector<std::uint32_t> leaf_order(const TreeState<D>& state, std::span<const double> records,
                                      const std::vector<std::size_t>& levels, LeafRange leaves,
                                      Interrupt& interrupt);

}  // namespace foresee
