#include <algorithm>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/node.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/tpr_tree.h"

namespace foresee {
namespace {

class TreeReader {
 public:
  TreeReader(NodeSource& source, Interrupt& interrupt, const std::optional<KindTest>& wanted)
      : source_(source), interrupt_(interrupt), wanted_(wanted), at_(record_offsets(source.layout())) {
    scene_.layout = source.layout();
    record_size_ = static_cast<std::size_t>(at_.size);
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
      if (is_wanted(kinds_at(node, slot))) visit(node.keys[slot], *read_below(source_, number, node, slot));
  }

  bool is_wanted(Kinds kinds) {
    const bool wanted = !wanted_ || wanted_->accepts(kinds);
    scene_.complete &= wanted;
    return wanted;
  }

  void add_rows(const Node& leaf) {
    if (wanted_) return add_wanted_rows(leaf);
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

  void add_wanted_rows(const Node& leaf) {
    for (std::size_t slot = 0; slot < leaf.size(); ++slot) {
      const double* const record = leaf.values.data() + slot * record_size_;
      if (!is_wanted(kinds_of(record, at_))) continue;
      scene_.ids.push_back(leaf.keys[slot]);
      scene_.rows.resize(scene_.rows.size() + row_size_);
      row_from_record(scene_.layout, record, scene_.rows.data() + scene_.rows.size() - row_size_);
    }
  }

  NodeSource& source_;
  Interrupt& interrupt_;
  const std::optional<KindTest>& wanted_;
  const Offsets at_;
  TreeScene scene_;
  std::size_t record_size_, row_size_;
};

void add_leaves(NodeSource& source, const Unread& unread, const KindTest& wanted, Interrupt& interrupt,
                WantedLeaves& leaves) {
  interrupt.check();
  const auto node = read(source, unread);
  if (node->is_leaf()) return leaves.numbers.push_back(unread.number);  // the root
  for (std::size_t slot = 0; slot < node->size(); ++slot) {
    if (node->level > 1)
      add_leaves(source, unread_child(unread.number, *node, slot), wanted, interrupt, leaves);
    else if (wanted.accepts(kinds_at(*node, slot)))
      leaves.numbers.push_back(node->keys[slot]);
    else
      ++leaves.others;
  }
}

}  // namespace

TreeScene read_tree(NodeSource& source, Interrupt& interrupt, const std::optional<KindTest>& wanted) {
  return TreeReader(source, interrupt, wanted).read();
}

Kinds kinds_of_all(NodeSource& source) {
  Kinds all = Kinds::none();
  if (source.find_root() == 0) return all;
  const auto root = read(source, unread_root(source));
  const Offsets at = record_offsets(source.layout());
  for (std::size_t slot = 0; slot < root->size(); ++slot)
    all.include(root->is_leaf() ? kinds_of(root->values.data() + slot * static_cast<std::size_t>(at.size), at)
                                : kinds_at(*root, slot));
  return all;
}

WantedLeaves find_leaves(NodeSource& source, const KindTest& wanted, Interrupt& interrupt) {
  WantedLeaves leaves;
  if (source.find_root() != 0) add_leaves(source, unread_root(source), wanted, interrupt, leaves);
  std::sort(leaves.numbers.begin(), leaves.numbers.end());
  return leaves;
}

namespace {

/// Without bias if each `place`, from 0 to less than 1, is as likely. It chooses a child of the root, and its remainder
/// one of that child's, and so on.
double estimate_by_path(NodeSource& source, double place) {
  double objects = 1;
  for (Unread next = unread_root(source);;) {
    const auto node = read(source, next);
    const auto size = static_cast<double>(node->size());
    objects *= size;
    if (node->is_leaf() || node->size() == 0) return objects;
    const auto slot = std::min(static_cast<std::size_t>(place * size), node->size() - 1);
    place = place * size - static_cast<double>(slot);
    next = unread_child(next.number, *node, slot);
  }
}

}  // namespace

double estimate_objects(NodeSource& source, double compared) {
  if (source.find_root() == 0) return 0;
  const double first = estimate_by_path(source, fraction_of(hash_of(1)));
  if (first > 1000 * compared) return first;
  constexpr unsigned paths = 32;
  double sum = 0;
  for (unsigned path = 0; path < paths; ++path)
    sum += estimate_by_path(source, (path + fraction_of(hash_of(path))) / paths);
  return sum / paths;
}

void collect_objects(NodeSource& source, std::vector<std::int64_t>& ids, std::vector<double>& records,
                     Interrupt& interrupt) {
  std::vector<Unread> open;
  if (source.find_root() != 0) open.push_back(unread_root(source));
  while (!open.empty()) {
    interrupt.check();
    const NodeNumber number = open.back().number;
    const auto node = read(source, open.back());
    open.pop_back();
    if (node->is_leaf()) {
      ids.insert(ids.end(), node->keys.begin(), node->keys.end());
      records.insert(records.end(), node->values.begin(), node->values.end());
    }
    for (std::size_t slot = node->is_leaf() ? 0 : node->size(); slot-- > 0;)
      open.push_back(unread_child(number, *node, slot));
  }
}

}  // namespace foresee
