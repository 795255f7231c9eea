// The way of many objects down a TPR-tree, level by level: each node on it is read once, however many objects pass it.
//
//   BatchDescent<2> batch(state, ids, records, interrupt);
//   for (std::uint32_t i = 0; i < batch.size(); ++i) batch.root().objects.push_back(i);
//   for (std::size_t level = batch.levels() - 1; level > 0; --level) batch.sink(level);
//
// Each object moves to the child whose visit cost increases least (choose_child.h). A node that is visited knows the
// objects that have come to it and its children with visits, which is what even_out() needs afterwards.
#pragma once

#include <map>
#include <utility>

#include "base/interrupt_steps.h"
#include "index/tpr_tree/update/choose_child.h"

namespace foresee {

template <int D>
class BatchDescent {
 public:
  /// The work of a batch in one node.
  struct Visit {
    NodeNumber parent = 0;
    std::vector<NodeNumber> children = {};    ///< the children with work, too
    std::size_t changes = 0;                  ///< of objects beneath; counted for parents of leaves
    std::vector<std::uint32_t> objects = {};  ///< that need a leaf beneath this node, or enter this leaf
  };
  using Visits = std::map<NodeNumber, Visit>;

  /// Requires: the root is an inner node.
  BatchDescent(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
               Interrupt& interrupt)
      : state_(state), ids_(ids), records_(records), step_(interrupt) {
    const auto root = read(state.pages, unread_root(state.pages));
    levels_.resize(static_cast<std::size_t>(root->level) + 1);
    levels_.back().try_emplace(state.pages.find_root());
  }

  std::size_t size() const { return ids_.size(); }
  NewObject<D> object(std::uint32_t i) const {
    const std::size_t size = state_.reader.record_size();
    const auto record = records_.subspan(i * size, size);
    return {ids_[i], record, Mover<D>(state_.reader, record.data())};
  }
  std::size_t levels() const { return levels_.size(); }
  Visits& at(std::size_t level) { return levels_[level]; }
  Visit& root() { return levels_.back().begin()->second; }
  void step() { step_(); }

  /// The visit of a child of a visited node.
  Visit& visit_below(NodeNumber parent, const Node& node, std::size_t slot) {
    const auto [place, is_new] =
        levels_[static_cast<std::size_t>(node.level) - 1].try_emplace(node.keys[slot]);
    if (is_new) {
      read_below(state_.pages, parent, node, slot);
      place->second.parent = parent;
      levels_[static_cast<std::size_t>(node.level)].at(parent).children.push_back(node.keys[slot]);
    }
    return place->second;
  }

  /// Moves objects that need a leaf beneath a node of this level to one of its children.
  void sink(std::size_t level) {
    for (auto& [number, visit] : levels_[level]) {
      if (visit.objects.empty()) continue;
      const auto node = state_.pages.read(number);
      if (node->size() == 0) throw BrokenTree("an inner node of a tree is empty");
      ChildChoice<D> choice(*node, state_.cost(node->epoch));
      std::vector<Visit*> below(node->size());
      for (const std::uint32_t i : std::exchange(visit.objects, {})) {
        step_();
        const std::size_t slot = choice.choose(object(i).entry(node->epoch));
        if (!below[slot]) below[slot] = &visit_below(number, *node, slot);
        below[slot]->objects.push_back(i);
      }
    }
  }

 private:
  TreeState<D>& state_;
  std::span<const std::int64_t> ids_;
  std::span<const double> records_;
  Steps step_;
  std::vector<Visits> levels_;  ///< leaves first
};

}  // namespace foresee
