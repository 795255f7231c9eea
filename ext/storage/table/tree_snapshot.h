// The tree as it was when this was made, whatever the connection has written, committed or rolled back since.
//
// Holds the store, and a mark in its cache (undo_log.h); it must not outlive the statement that asked, whose
// read transaction keeps the rows as they are.
#pragma once

#include "storage/table/store.h"

namespace foresee {

class TreeSnapshot final : public NodeSource, private FormSource {
 public:
  explicit TreeSnapshot(std::shared_ptr<Store> store)
      : store_(std::move(store)),
        root_(store_->nodes().find_root()),
        forms_(store_->known_forms()),
        mark_(store_->nodes().set_mark(true)) {}
  ~TreeSnapshot() override { store_->give_up(mark_); }
  TreeSnapshot(const TreeSnapshot&) = delete;
  TreeSnapshot& operator=(const TreeSnapshot&) = delete;

  const Layout& layout() const override { return store_->format().layout; }
  NodeNumber find_root() override { return root_; }
  std::shared_ptr<const Node> read(NodeNumber number) override {
    return store_->nodes().read_at(mark_, number);
  }
  FormSource* forms() override { return forms_ ? this : nullptr; }

 private:
  /// What a rollback took back is not stored any more.
  std::shared_ptr<const Form> form(std::int64_t number) override {
    const auto known = forms_->find(number);
    return known == forms_->end() ? store_->form(number) : known->second;
  }

  std::shared_ptr<Store> store_;
  NodeNumber root_;
  std::shared_ptr<const StoredForms::ByNumber> forms_;  ///< null: the layout has none
  UndoLog::Handle mark_;
};

}  // namespace foresee
