// In which order do objects fill the leaves of a new tree? So that a leaf's objects are near each other now
// and stay so.
//
// Top down, as in OMT: the objects are halved again and again, at a boundary between nodes of the highest
// level that has one near the middle, each time along the axis of position or velocity on which they are most
// spread out; a velocity counts as the distance it covers in part of a horizon. The spread is that of a
// sample between its tenths, so that a few outliers do not decide it; objects far larger or faster than the
// median come last, in leaves of their own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/error.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// How many nodes of each level a tree of so many leaves has, leaves first, up to the root.
std::vector<std::size_t> level_sizes(std::size_t leaves, std::size_t inner_capacity);

/// Of `children` spread evenly over `parents`: the first one of a parent.
inline std::size_t first_child(std::size_t parent, std::size_t parents, std::size_t children) {
  return parent / parents * children + parent % parents * children / parents;
}

/// The part of an order that belongs to one of `parents`.
inline std::span<const std::uint32_t> part_of(std::span<const std::uint32_t> order, std::size_t parent,
                                              std::size_t parents) {
  const std::size_t first = first_child(parent, parents, order.size());
  return order.subspan(first, first_child(parent + 1, parents, order.size()) - first);
}

/// The objects at these places, side by side as a leaf has them; `size`: doubles of a record.
inline Node objects_at(std::span<const std::uint32_t> places, std::span<const std::int64_t> ids,
                       std::span<const double> records, std::size_t size) {
  Node leaf;
  leaf.keys.reserve(places.size()), leaf.values.reserve(places.size() * size);
  for (const std::uint32_t place : places) {
    const auto record = records.subspan(place * size, size);
    leaf.keys.push_back(ids[place]);
    leaf.values.insert(leaf.values.end(), record.begin(), record.end());
  }
  return leaf;
}

/// Leaves of a tree side by side.
struct LeafRange {
  std::size_t first, count;
};

/// Positions of the records in the order of these leaves of the tree: the i-th of them holds places
/// first_child(i, count, objects) up to that of i + 1.
template <int D>
std::vector<std::uint32_t> leaf_order(const TreeState<D>& state, std::span<const double> records,
                                      const std::vector<std::size_t>& levels, LeafRange leaves,
                                      Interrupt& interrupt);

}  // namespace foresee
