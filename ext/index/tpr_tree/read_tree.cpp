#include <algorithm>

#include "index/tpr_tree/node.h"
#include "index/tpr_tree/search/tree_join.h"

namespace foresee {
namespace {

class TreeReader {
 public:
  TreeReader(NodeSource& source, Interrupt& interrupt) : source_(source), interrupt_(interrupt) {
    scene_.layout = source.layout();
    record_size_ = static_cast<std::size_t>(record_offsets(scene_.layout).size);
    row_size_ = static_cast<std::size_t>(row_offsets(scene_.layout).size);
  }

  TreeScene read() {
    if (source_.find_root() == 0) return std::move(scene_);
    const auto root = foresee::read(source_, unread_root(source_));
    if (root->level < 0 || root->level > 64) throw BrokenTree("a tree's root has an impossible level");
    scene_.levels.starts.resize(static_cast<std::size_t>(root->level) + 1);
    visit(source_.find_root(), *root);
    // From the top down: each level ends with the size of the level below, before that gets its own end.
    for (std::size_t level = scene_.levels.starts.size(); level-- > 0;)
      scene_.levels.starts[level].push_back(next_below(level));
    return std::move(scene_);
  }

 private:
  /// The number of rows, or of nodes one level down, so far.
  std::uint32_t next_below(std::size_t level) const {
    return static_cast<std::uint32_t>(level == 0 ? scene_.ids.size()
                                                 : scene_.levels.starts[level - 1].size());
  }

  void visit(NodeNumber number, const Node& node) {
    const auto level = static_cast<std::size_t>(node.level);
    scene_.levels.starts[level].push_back(next_below(level));
    if (node.is_leaf()) return add_rows(node);
    interrupt_.check();
    for (std::size_t slot = 0; slot < node.size(); ++slot)
      visit(node.keys[slot], *read_below(source_, number, node, slot));
  }

  void add_rows(const Node& leaf) {
    scene_.ids.insert(scene_.ids.end(), leaf.keys.begin(), leaf.keys.end());
    if (record_size_ == row_size_) {
      scene_.rows.insert(scene_.rows.end(), leaf.values.begin(), leaf.values.end());
      return;
    }
    const std::size_t first = scene_.rows.size();
    scene_.rows.resize(first + leaf.size() * row_size_);
    for (std::size_t slot = 0; slot < leaf.size(); ++slot)
      row_from_record(scene_.layout, leaf.values.data() + slot * record_size_,
                      scene_.rows.data() + first + slot * row_size_);
  }

  NodeSource& source_;
  Interrupt& interrupt_;
  TreeScene scene_;
  std::size_t record_size_, row_size_;
};

}  // namespace

TreeScene read_tree(NodeSource& source, Interrupt& interrupt) {
  return TreeReader(source, interrupt).read();
}

}  // namespace foresee
