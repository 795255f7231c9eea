// Pages of a TPR-tree in memory: for tests, benchmarks and applications that embed the core without SQLite.
//
//   MemoryPages pages({.axes = 2, .law = Law::uniform});
//   auto tree = make_tpr_tree(pages, 60);
//
// A node is copied before a change only while a caller holds a shared pointer to it.
#pragma once

#include <unordered_map>

#include "index/pages.h"

namespace foresee {

class MemoryPages final : public Pages {
 public:
  /// By default the capacities are what fits a page of 4096 bytes.
  explicit MemoryPages(const Layout& layout, std::size_t leaf_capacity = 0, std::size_t inner_capacity = 0);

  const Layout& layout() const override { return layout_; }
  NodeNumber find_root() override { return root_; }
  std::shared_ptr<const Node> read(NodeNumber number) override;

  std::size_t leaf_capacity() const override { return leaf_capacity_; }
  std::size_t inner_capacity() const override { return inner_capacity_; }
  Node& modify(NodeNumber number) override;
  NodeNumber allocate() override;
  NodeNumber reserve(std::size_t count) override;
  void put(NodeNumber number, Node node) override;
  void free(NodeNumber number) override;
  void set_root(NodeNumber number) override { root_ = number; }
  std::optional<NodeNumber> find_leaf(std::int64_t id) override;
  void place(std::span<const std::int64_t> ids, NodeNumber leaf) override;
  void forget(std::int64_t id) override { leaves_.erase(id); }

  std::size_t node_count() const { return nodes_.size() - free_.size() - 1; }
  std::size_t object_count() const { return leaves_.size(); }

 private:
  std::shared_ptr<Node>& at(NodeNumber number);

  Layout layout_;
  std::size_t leaf_capacity_, inner_capacity_;
  NodeNumber root_ = 0;
  std::vector<std::shared_ptr<Node>> nodes_;  ///< by number; null: unused
  std::vector<NodeNumber> free_;
  std::unordered_map<std::int64_t, NodeNumber> leaves_;
};

}  // namespace foresee
