#include <algorithm>
#include <set>

#include "base/axes.h"
#include "base/interrupt_steps.h"
#include "index/tpr_tree/node.h"
#include "index/tpr_tree/tpr_tree.h"

namespace foresee {
namespace {

/// Visits the whole tree and keeps the entries above the current node.
template <int D>
class TreeCheck {
 public:
  TreeCheck(Pages& pages, Interrupt& interrupt)
      : pages_(pages), interrupt_(interrupt), reader_(pages.layout()) {}

  TreeReport run() {
    if (pages_.find_root() != 0) visit(pages_.find_root(), 0, -1);
    find_objects_held_twice();
    return std::move(report_);
  }

 private:
  struct Above {
    Entry<D> entry;
    double epoch;
  };

  struct Place {
    std::int64_t id;
    NodeNumber leaf;
  };

  void problem(NodeNumber number, const std::string& what) {
    if (report_.problems.size() < 100)
      report_.problems.push_back("node " + std::to_string(number) + ": " + what);
  }

  /// `level` is the level that the parent requires; -1: any.
  void visit(NodeNumber number, NodeNumber parent, int level) {
    interrupt_.check();
    if (!nodes_.insert(number).second) return problem(number, "is reached twice");
    ++report_.nodes;
    const auto node = pages_.read(number);
    if (level >= 0 && node->level != level)
      return problem(number, "has level " + std::to_string(node->level) + " below a node that requires " +
                                 std::to_string(level));
    if (node->parent != parent) problem(number, "names a parent that is not its own");
    if (!sizes_fit(number, *node)) return;
    if (!above_.empty()) check_newest(number, *node);
    if (node->is_leaf()) return visit_objects(number, *node);
    for (std::size_t slot = 0; slot < node->size(); ++slot) {
      above_.push_back({entry_at<D>(*node, slot), node->epoch});
      visit(node->keys[slot], number, node->level - 1);
      above_.pop_back();
    }
  }

  bool sizes_fit(NodeNumber number, const Node& node) {
    const std::size_t stride = node.is_leaf() ? reader_.record_size() : entry_size(D);
    const std::size_t size = node.size();
    const bool too_empty = size < (node.is_leaf() ? 1 : 2);
    const bool too_full = size > (node.is_leaf() ? pages_.leaf_capacity() : pages_.inner_capacity());
    if (too_empty) problem(number, "is too empty");
    if (too_full) problem(number, "is too full");
    const bool fits = node.values.size() == size * stride &&
                      (node.kinds.empty() || (!node.is_leaf() && node.kinds.size() == size));
    if (!fits) problem(number, "has numbers missing or too many");
    return !too_empty && fits;
  }

  void check_newest(NodeNumber number, const Node& node) {
    if (times_of(node, reader_).t_max != above_.back().entry.times.t_max)
      problem(number, "has another greatest t than its entry");
  }

  void visit_objects(NodeNumber number, const Node& leaf) {
    report_.objects += leaf.size();
    for (std::size_t slot = 0; slot < leaf.size(); ++slot) {
      const std::int64_t id = leaf.keys[slot];
      places_.push_back({id, number});
      if (pages_.find_leaf(id) != number)
        problem(number, "is not where the map has object " + std::to_string(id));
      check_bounds(number, id, Mover<D>(reader_, reader_.record(leaf, slot)));
    }
  }

  void find_objects_held_twice() {
    Steps step(interrupt_);
    std::sort(places_.begin(), places_.end(), [&](const Place& a, const Place& b) {
      step();
      return a.id != b.id ? a.id < b.id : a.leaf < b.leaf;
    });
    for (std::size_t i = 1; i < places_.size(); step(), ++i)
      if (places_[i - 1].id == places_[i].id)
        problem(places_[i].leaf, "holds object " + std::to_string(places_[i].id) + " again");
  }

  /// Bounds that contain position, velocity and acceleration at the epoch contain the object at every time.
  /// The object's own bounds are not padded, so their error is less than the entry's padding.
  void check_bounds(NodeNumber number, std::int64_t id, const Mover<D>& mover) {
    const Motion<D>& motion = mover.motion;
    for (const Above& above : above_) {
      const Entry<D> own{
          {motion.t, motion.t, motion.until}, known(mover.bounds(above.epoch, 0.0)), mover.kinds};
      if (!above.entry.contains(own))
        problem(number, "holds object " + std::to_string(id) + ", which an entry above does not contain");
    }
  }

  /// A face that overflowed in the computation is replaced by one inside any entry: it proves nothing.
  static Bounds<D> known(Bounds<D> own) {
    const Vec<D> anywhere = Vec<D>::constant(std::numeric_limits<double>::infinity());
    for (Vec<D>* lower : {&own.x_lower, &own.v_lower, &own.a_lower})
      *lower = lower->is_finite().select(*lower, anywhere);
    for (Vec<D>* upper : {&own.x_upper, &own.v_upper, &own.a_upper})
      *upper = upper->is_finite().select(*upper, -anywhere);
    return own;
  }

  Pages& pages_;
  Interrupt& interrupt_;
  LeafReader<D> reader_;
  TreeReport report_;
  std::vector<Above> above_;
  std::set<NodeNumber> nodes_;
  std::vector<Place> places_;  ///< of every object
};

}  // namespace

TreeReport check_tree(Pages& pages, Interrupt& interrupt) {
  return with_axes(pages.layout().axes, [&]<int D>(Axes<D>) { return TreeCheck<D>(pages, interrupt).run(); });
}

}  // namespace foresee
