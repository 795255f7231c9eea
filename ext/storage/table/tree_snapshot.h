// Snapshot of a table's TPR-tree, unaffected by later writes, commits and rollbacks of the connection.
//
// It holds the store and a position in the history of its nodes (node_history.h). It must not outlive the
// statement that took it, whose read transaction preserves the rows.
#pragma once

#include "storage/table/store.h"

namespace foresee {

class TreeSnapshot final : public NodeSource, private FormSource {
 public:
  explicit TreeSnapshot(std::shared_ptr<Store> store)
      : store_(std::move(store)),
        root_(store_->nodes().find_root()),
        forms_(store_->known_forms()),
        nodes_(store_->nodes().take_snapshot()) {}
  ~TreeSnapshot() override { store_->give_up(nodes_); }
  TreeSnapshot(const TreeSnapshot&) = delete;
  TreeSnapshot& operator=(const TreeSnapshot&) = delete;

  const Layout& layout() const override { return store_->format().layout; }
  NodeNumber find_root() override { return root_; }
  std::shared_ptr<const Node> read(NodeNumber number) override {
    return store_->nodes().read_at(nodes_, number);
  }
  FormSource* forms() override { return forms_ ? this : nullptr; }

 private:
  /// From the forms at the time of the snapshot first: a rollback may have removed rows.
  std::shared_ptr<const Form> form(std::int64_t number) override {
    const auto known = forms_->find(number);
    return known == forms_->end() ? store_->form(number) : known->second;
  }

  std::shared_ptr<Store> store_;
  NodeNumber root_;
  std::shared_ptr<const StoredForms::ByNumber> forms_;  ///< null: the layout has no forms
  NodeHistory::Snapshot nodes_;
};

}  // namespace foresee
