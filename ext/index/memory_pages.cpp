#include "index/memory_pages.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace foresee {
namespace {

std::size_t fitting(std::size_t requested, std::size_t bytes_per_key) {
  constexpr std::size_t page = 4096, head = 64;
  return std::max<std::size_t>(4, requested != 0 ? requested : (page - head) / bytes_per_key);
}

}  // namespace

MemoryPages::MemoryPages(const Layout& layout, std::size_t leaf_capacity, std::size_t inner_capacity)
    : layout_(layout),
      leaf_capacity_(fitting(leaf_capacity, 8 + 8 * static_cast<std::size_t>(record_offsets(layout).size))),
      inner_capacity_(fitting(inner_capacity, 8 + 8 * static_cast<std::size_t>(entry_size(layout.axes)))),
      nodes_(1) {}

std::shared_ptr<Node>& MemoryPages::at(NodeNumber number) {
  auto& node = nodes_.at(static_cast<std::size_t>(number));
  if (!node) throw std::out_of_range("a tree node that is not there");
  return node;
}

std::shared_ptr<const Node> MemoryPages::read(NodeNumber number) {
  return at(number);
}

Node& MemoryPages::modify(NodeNumber number) {
  auto& node = at(number);
  if (node.use_count() > 1) node = std::make_shared<Node>(*node);
  return *node;
}

NodeNumber MemoryPages::allocate() {
  if (!free_.empty()) {
    const NodeNumber number = free_.back();
    nodes_[static_cast<std::size_t>(number)] = std::make_shared<Node>();
    free_.pop_back();
    return number;
  }
  nodes_.push_back(std::make_shared<Node>());
  return static_cast<NodeNumber>(nodes_.size() - 1);
}

NodeNumber MemoryPages::reserve(std::size_t count) {
  const auto first = static_cast<NodeNumber>(nodes_.size());
  for (std::size_t i = 0; i < count; ++i) nodes_.push_back(std::make_shared<Node>());
  return first;
}

void MemoryPages::put(NodeNumber number, Node node) {
  at(number) = std::make_shared<Node>(std::move(node));
}

void MemoryPages::free(NodeNumber number) {
  at(number).reset();
  free_.push_back(number);
}

std::optional<NodeNumber> MemoryPages::find_leaf(std::int64_t id) {
  const auto found = leaves_.find(id);
  return found == leaves_.end() ? std::nullopt : std::optional(found->second);
}

void MemoryPages::place(std::span<const std::int64_t> ids, NodeNumber leaf) {
  for (const std::int64_t id : ids) leaves_[id] = leaf;
}

}  // namespace foresee
