// What one connection holds of a table: its rows, its trees, forms and plans in memory, and which of them are valid.
//
// The base of TableReader, TableWriter and Store, in this order: each calls only those before it, except through
// ChangingTable. Changes wait in memory until flush(), at the end of the transaction or when the tables of the
// connection together exceed their budget. The cache stays valid in the next transaction only under the same stamp
// (version.h).
// Errors: SQLite's result codes as StoreError; SQLITE_CORRUPT_VTAB for a blob that foresee did not write.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/sqlite_api.h"
#include "format/declaration.h"
#include "storage/rows/shadow_rows.h"
#include "storage/table/stored_forms.h"
#include "storage/table/stored_plans.h"
#include "storage/table/table_totals.h"
#include "storage/table/table_transaction.h"
#include "storage/tree/tree_store.h"

namespace foresee {

class TableContents : private ChangingTable {
 public:
  TableContents(sqlite3* db, QualifiedName name, Declaration declaration, const NodeFormat& format,
                std::unique_ptr<ShadowRows> rows, bool is_new, std::shared_ptr<MemoryBudget> memory);
  TableContents(const TableContents&) = delete;
  TableContents& operator=(const TableContents&) = delete;

  const Declaration& declaration() const { return declaration_; }
  const NodeFormat& format() const { return format_; }
  /// The version of the contents that this connection sees now. Cost: one look-up.
  ContentVersion read_version();
  /// Estimated number of objects, without reading: the last known count plus changes of this transaction.
  std::int64_t likely_objects() const noexcept { return totals_->count.likely(); }
  /// The number of objects at the last read_version(); nothing if only version 0.1 has written the table.
  std::optional<std::int64_t> known_objects() const noexcept { return totals_->count.sum(); }
  /// The stored stamp, even if changes are unwritten.
  std::optional<std::int64_t> stored_stamp() { return shadow_rows().read_stamp(); }
  /// The stamp under which memory holds committed contents; nothing once this transaction has written.
  std::optional<std::int64_t> committed_stamp() const {
    return version().written_here() ? std::nullopt : version().seen();
  }
  NodeCache& nodes() { return tree().nodes(); }
  [[noreturn]] void damaged(const std::string& what) const { throw_damaged(name_, what); }

 protected:
  using OwnStatements = TableTransaction::OwnStatements;
  using AtomicChange = TableTransaction::AtomicChange;

  ~TableContents();

  Version& version() { return transaction_.version(); }
  const Version& version() const { return transaction_.version(); }
  /// These two: requires that the table is usable; throws if it is not.
  ShadowRows& shadow_rows() {
    transaction_.require_usable();
    return *shadow_rows_;
  }
  TreeStore& tree() {
    transaction_.require_usable();
    return tree_;
  }
  bool has_auxiliaries() const { return !declaration_.auxiliaries.empty(); }

  /// Empties the cache if another connection has committed meanwhile. Cost: at most one look-up per statement.
  void revalidate_cache(StatementReadState* statement_state = nullptr);
  void forget_clean_nodes();
  void note_memory() noexcept;

  bool has_unwritten() const;
  /// Moves the pending objects of all its trees into them: in memory, as far as the budget allows.
  void merge_pending(TreeStore::Reason reason = TreeStore::Reason::query);
  /// merge_pending(), then writes all changes as rows, with a new stamp for the same contents.
  void flush(TreeStore::Reason reason = TreeStore::Reason::query);
  /// Stores a random stamp, under which the cache is valid. Costs one row.
  void write_new_stamp(bool same_contents = false);
  void write_count(std::int64_t objects);

  /// Reads and writes rows under this name from now on.
  void connect(const QualifiedName& name);

  void note_end() noexcept override;
  void forget_rows() override;

  QualifiedName name_;  ///< under which the rows are open
  Declaration declaration_;
  NodeFormat format_;
  std::shared_ptr<MemoryBudget> memory_;
  TableTransaction transaction_;
  std::unique_ptr<ShadowRows> shadow_rows_;
  TreeStore tree_;
  std::unique_ptr<StoredForms> forms_;  ///< null: the layout has no forms
  std::unique_ptr<StoredPlans> plans_;  ///< null: the layout has no plans
  Journaled<Totals> totals_;
  Journaled<ChosenOrigin> origin_;  ///< of a table in degrees without a declared origin
  Journaled<std::optional<std::vector<std::string>>> watch_names_;  ///< nothing: not known

 private:
  std::optional<std::int64_t> read_stamp() override { return shadow_rows_->read_stamp(); }
  void revalidate_at_begin() override;
  /// Called by another table of the connection, or by a trigger on a shadow table during a change.
  void write_out();
  bool must_merge(TreeStore::Reason reason) const;
};

}  // namespace foresee
