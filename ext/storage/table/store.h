// Storage of one moving_objects table: a TPR-tree in shadow tables, with transactions and snapshots.
//
//   store.insert(42, record, auxiliaries);                // record: record_offsets(layout).size doubles
//   store.read_all(ids, rows, interrupt);                 // all objects, for a query
//
// A write goes through memory; a read sees everything that is still unwritten there (tree_store.h).
// Every double is returned bit for bit. All state is in SQLite's tables, so transactions, WAL readers, VACUUM
// and backup are SQLite's own. Changes wait in memory until sync(), or until the tables of the connection
// together exceed their budget. A savepoint is a mark in the journal (journal.h) and writes nothing. A rollback
// to it undoes later changes in memory, while SQLite restores the rows. The cache stays valid in the next
// transaction only under the same stamp (version.h). Blobs are checked when they are read.
//
// Auxiliary values are written at once. Every change is atomic (store_change.h). Errors: SQLite's result
// codes as StoreError; SQLITE_CORRUPT_VTAB for a blob that foresee did not write.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <unordered_set>

#include "storage/format/declaration.h"
#include "storage/journal/version.h"
#include "storage/nodes/object_changes.h"
#include "storage/rows/shadow_rows.h"
#include "storage/rows/store_error.h"
#include "storage/table/store_state.h"
#include "storage/table/stored_forms.h"
#include "storage/table/stored_plans.h"
#include "storage/tree/tree_store.h"

namespace foresee {

class Store final : public FormSource, public std::enable_shared_from_this<Store> {
 public:
  /// Creates the shadow tables of a new table.
  static std::shared_ptr<Store> create(sqlite3* db, const std::string& schema, const std::string& table,
                                       const Declaration& declaration);
  /// Opens the shadow tables of an existing table. Reads only _meta. During a transaction SQLite may connect
  /// a table again (any ALTER does) while the old virtual table has unwritten changes; then both share one
  /// store, hence shared_ptr.
  static std::shared_ptr<Store> open(sqlite3* db, const std::string& schema, const std::string& table,
                                     const Declaration& declaration);

  const Declaration& declaration() const { return declaration_; }
  const NodeFormat& format() const { return format_; }
  /// The declared frame. Without a declared origin, with the one that the first position has chosen (empty: none yet),
  /// as this connection sees it now; that costs as much as read_version().
  const Frame& frame();
  /// frame() of a table that holds objects: SQLITE_CORRUPT_VTAB for degrees without an origin.
  const Frame& frame_of_objects(StatementReadState* statement_state = nullptr);

  // --- reading
  /// The version of the contents that this connection sees now. Cost: one look-up.
  ContentVersion read_version();
  bool contains(std::int64_t id);
  std::optional<std::vector<double>> read(std::int64_t id);
  /// read() for a statement that reads repeatedly; empty if there is no object. Valid until the next call.
  /// Cost: one look-up of the stamp per statement, then about 100 ns if the leaf is in memory.
  std::span<const double> find(std::int64_t id, StatementReadState& statement_state);
  /// Prefetches `many` ids from `first` on, as far as they are in memory. Changes nothing.
  void fetch_ahead(std::int64_t first, std::int64_t many) { tree_.nodes().fetch_ahead(first, many); }
  /// All ids and rows (row_from_record of each record), one leaf after another. SQLITE_CORRUPT_VTAB for a damaged leaf,
  /// and as in expect_objects(). With `wanted`, only the objects that it accepts; leaves without one may not be read.
  /// Returns whether these are all objects.
  bool read_all(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt,
                const std::optional<KindTest>& wanted = {});
  /// Reads the leaf after leaf `after` (0: the first one). Returns its number, or 0 at the end.
  std::int64_t next_leaf(std::int64_t after, std::vector<std::int64_t>& ids, std::vector<double>& records);
  /// The ids of a range in order. Nothing if no order is wanted and a scan probably costs less than their look-ups.
  std::optional<IdWalk> walk_ids(const IdRange& range, std::optional<IdOrder> order);
  bool next_ids(IdWalk& walk, std::vector<std::int64_t>& ids);  ///< as IdWalk::next()
  /// Sets the auxiliary column of `id`, or NULL, as the result of `context`.
  void result_auxiliary(sqlite3_context* context, std::int64_t id, int column);
  /// A snapshot of the tree, which no change, commit or rollback affects. It must not outlive the statement.
  std::shared_ptr<NodeSource> take_snapshot(StatementReadState* statement_state = nullptr);
  /// The largest reference time stored; 0 without objects or without t. Reads one node.
  double read_newest_t(StatementReadState* statement_state = nullptr);
  /// The outlines or meshes, by the number in a record; null in a table without.
  FormSource* forms() { return forms_ ? this : nullptr; }
  std::shared_ptr<const Form> form(std::int64_t number) override;
  /// form() for a statement that reads the table repeatedly.
  std::shared_ptr<const Form> form(std::int64_t number, StatementReadState& statement_state);
  /// The forms in memory, for snapshots; null in a table without.
  std::shared_ptr<const StoredForms::ByNumber> known_forms() { return forms_ ? forms_->known() : nullptr; }
  /// Call it after reading every leaf: SQLITE_CORRUPT_VTAB if the map, when written, has another count.
  void expect_objects(std::size_t found);
  /// Estimated number of objects, without reading: the last known count plus changes of this transaction.
  std::int64_t likely_objects() const noexcept { return totals_->count.likely(); }
  /// The number of objects at the last read_version(); nothing if only version 0.1 has written the table.
  std::optional<std::int64_t> known_objects() const noexcept { return totals_->count.sum(); }

  // --- plans (store_plans.cpp); requires: a layout with plans
  /// The plan of an object as it was written. Requires: the record of the object, with a plan.
  Plan read_plan(std::int64_t id, std::span<const double> record);
  /// Its legs that exist at some of these times, in order; the object's `until` has not cut them. Cost: two look-ups.
  void read_legs(std::int64_t id, std::span<const double> record, const LegTimes& times,
                 StatementReadState& statement_state, std::vector<Leg>& legs);
  /// The plans for walks; null in a layout without. Valid until the next write. Requires: the statement has taken a
  /// snapshot since it started, and has written nothing since.
  std::shared_ptr<ChunkSource> chunks();
  using EachObject =
      std::function<void(std::int64_t id, std::span<const double> record, std::span<const Leg> legs)>;
  /// Calls each() for every object, those without a plan first, with no legs. The others have the legs of the chunks
  /// that last at some time from `from` to `until`; objects without such a chunk are left out. It reads layouts without
  /// plans too. Requires: each() reads no plan of this store. Cost: some 20 ns per leg.
  void read_objects(double from, double until, const EachObject& each, Interrupt& interrupt);

  // --- writing: each call is atomic
  /// The id that SQLite gives to a row without one: the largest plus one.
  std::int64_t find_next_id();
  /// Finds or stores the outline or mesh of a well-known text (stored_forms.h), for a record to refer to by
  /// number. Throws Error for an invalid text. Requires: a layout with `shape`.
  StoredForms::Known find_or_add_form(std::string_view text, const StoredForms::Reader& read = {});
  /// Requires: no object has this id. `auxiliaries`: one value per auxiliary column. `origin`: from now on
  /// that of a table whose frame() has none. With a plan the motion of `record` becomes that of its first leg, and the
  /// store sets its numbers `plan` and `chunks`.
  void insert(std::int64_t id, std::span<const double> record, std::span<sqlite3_value*> auxiliaries,
              const std::optional<LatLon>& origin = {}, const Plan* plan = nullptr);
  /// Requires: `id` exists. Auxiliary values that are sqlite3_value_nochange stay. Another object with
  /// `new_id` is replaced, so INSERT OR REPLACE of an existing id is update(id, id, …). Without `plan` the object keeps
  /// its plan if `record` has the number of that, and its motion; 0: it has no plan any more.
  void update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
              std::span<sqlite3_value*> auxiliaries, const Plan* plan = nullptr);
  void erase(std::int64_t id);  ///< requires: `id` exists

  // --- changes of a transaction
  /// Calls each(id, record) for every object whose record differs, bit for bit, from the start of the transaction;
  /// in the order of first changes. An empty record: no such object. Rolled-back changes are left out. Only a
  /// transaction whose first change finds the name of a watch knows its changes. Cost: a read() per object.
  void for_each_change(const std::function<void(std::int64_t id, std::span<const double> record)>& each);

  // --- watches of this table (sqlite/watch/)
  /// Names of the watches to update at each commit, as this connection sees them now. Cost: one look-up, and
  /// a scan of the names if another connection has written.
  const std::vector<std::string>& watch_names();
  /// Adds or removes a name. Writes a stamp, so that every connection reads the names again.
  void add_watch(const std::string& name);
  void remove_watch(const std::string& name);
  /// The stored stamp; nothing while changes are unwritten. Equal stamps: equal contents.
  std::optional<std::int64_t> stamp_if_written();
  /// The stamp under which memory holds committed contents; nothing once this transaction has written.
  std::optional<std::int64_t> committed_stamp() const {
    return version_.written_here() ? std::nullopt : version_.seen();
  }
  /// The stored stamp, even if changes are unwritten.
  std::optional<std::int64_t> stored_stamp() { return shadow_rows().read_stamp(); }
  /// The stamp before all changes of for_each_change(); nothing if these are unknown (after 'rebuild').
  std::optional<std::int64_t> stamp_before_changes();

  // --- commands
  /// Rebuilds tree and map from the leaves alone, clustered by position and velocity; deletes auxiliary
  /// values of missing objects.
  void rebuild(Interrupt& interrupt);
  /// rebuild() of a table without damage; SQLITE_CORRUPT_VTAB if integrity_check() finds any.
  void optimize(Interrupt& interrupt);
  /// What is wrong with the stored bytes, one sentence each; empty: nothing.
  std::vector<std::string> integrity_check(Interrupt& interrupt);

  // --- callbacks of the virtual table, named as SQLite names them
  void begin();
  /// Writes all that waits in memory. Does nothing if nothing waits, so a COMMIT may repeat it.
  void sync();
  void commit();
  void rollback();
  void savepoint(int level);
  void release(int level);
  void rollback_to(int level) noexcept;
  void rename(const std::string& new_table);
  void drop();

  /// For create() and open().
  Store(sqlite3* db, QualifiedName name, Declaration declaration, const NodeFormat& format,
        std::unique_ptr<ShadowRows> rows, bool is_new, std::shared_ptr<MemoryBudget> memory);

  /// True if the table was dropped, or its creation was rolled back: then every callback does nothing.
  bool is_gone() const { return gone_; }
  /// Throws SQLITE_CORRUPT_VTAB.
  [[noreturn]] void damaged(const std::string& what) const;

  // For open() and for snapshots.
  bool is_named(const std::string& table) const { return !gone_ && name_.table == table; }
  /// True if SQLite has rolled back all that this transaction wrote, without a callback.
  bool was_rolled_back();
  NodeCache& nodes() { return tree().nodes(); }
  void give_up(NodeHistory::Snapshot snapshot) noexcept { tree_.nodes().give_up(snapshot); }

 private:
  class OwnStatements;
  class AtomicChange;

  /// Called by another table of the connection, or by a trigger on a shadow table during a change.
  void write_out();
  /// Returns this store. Throws SQLITE_ABORT if it is torn, until SQLite rolls back; SQLITE_SCHEMA if the table is
  /// gone, so that SQLite prepares the statement again.
  Store& require_usable();
  ShadowRows& shadow_rows() { return *require_usable().shadow_rows_; }
  TreeStore& tree() { return require_usable().tree_; }
  bool has_auxiliaries() const { return !declaration_.auxiliaries.empty(); }
  /// Empties the cache if another connection has committed meanwhile. Cost: at most one look-up per statement.
  void revalidate_cache(StatementReadState* statement_state = nullptr);
  void revalidate_at_begin();
  void note_memory() noexcept;
  /// Forgets what was read of nodes and forms.
  void forget_nodes();

  // reading (store_read.cpp)
  /// From the cache while this connection writes, else from the rows. Does not find pending objects.
  std::optional<std::int64_t> find_leaf(std::int64_t id);

  // watches (store_watches.cpp)
  /// Reads the names of the watches unless they are known.
  void load_watch_names();
  void write_stamp_of_watches();

  // writing (store_write.cpp)
  /// Checks the record, starts the transaction, writes its stamp, frees memory. Throws before any change.
  void start_change(std::span<const double> record);
  /// Throws Error for a record that would be damage in a leaf.
  void require_sound(std::span<const double> record) const;
  /// Stores a random stamp, under which the cache is valid. Costs one row.
  void write_new_stamp(bool same_contents = false);
  /// For watches: logs the record of `id`, or that it does not exist, before its first change in a transaction. Does
  /// nothing for later changes, nor in a table without watches.
  void log_before_change(std::int64_t id);
  [[noreturn]] void throw_missing(std::int64_t id) const;
  /// The plans of an update(); returns the record to store.
  std::span<const double> change_plans(StoredPlans::Change& plans, std::int64_t id, std::int64_t new_id,
                                       std::span<const double> record, const Plan* plan);
  void remove(std::int64_t id);
  void add(std::int64_t id, std::span<const double> record);
  const LargestId& read_largest();
  void write_count(std::int64_t objects);

  /// Moves the pending objects of all its trees into them: in memory, as far as the budget allows.
  void merge_pending(TreeStore::Reason reason = TreeStore::Reason::query);
  bool must_merge(TreeStore::Reason reason) const;
  /// merge_pending(), then writes all changes as rows, with a new stamp for the same contents.
  void flush(TreeStore::Reason reason = TreeStore::Reason::query);

  // commands (store_commands.cpp)
  void pack(Interrupt& interrupt);
  void pack_plans(Interrupt& interrupt);
  /// Calls plain() for every object without a plan. Returns the others; appends their records, in this order.
  std::vector<StoredPlans::Head> read_heads(const EachObject& plain, std::vector<double>& records,
                                            Interrupt& interrupt);

  // transactions (store_transactions.cpp)
  struct Savepoint {
    int level;
    Journal::Mark mark;
    bool has_unwritten;  ///< it has unwritten changes
  };

  bool has_unwritten() const;
  void restore(const Savepoint& savepoint);
  /// Forgets what this transaction has changed. It goes on.
  void restart_transaction();
  /// restart_transaction(), but closes a table that this transaction has created.
  void undo_transaction();
  /// Finds out by the stored stamp whether SQLite has rolled back all that this transaction wrote, if in doubt. What
  /// reads changes in memory calls it first; revalidate_cache() and require_usable() do.
  void resolve_doubt();
  void use_table_name(const std::string& table);
  std::size_t savepoints_before(int level) const noexcept;
  void give_up_savepoints(std::size_t from) noexcept;
  void end_transaction(Journal::Ended how);
  /// The table is gone. An old prepared statement may keep this store, so it forgets everything at once.
  void close();

  sqlite3* db_;
  QualifiedName name_;
  Declaration declaration_;
  NodeFormat format_;
  std::unique_ptr<ShadowRows> shadow_rows_;
  std::shared_ptr<MemoryBudget> memory_;
  Journal journal_;
  Version version_{journal_};
  TreeStore tree_;
  std::unique_ptr<StoredForms> forms_;  ///< null: the layout has no forms
  std::unique_ptr<StoredPlans> plans_;  ///< null: the layout has no plans
  Journaled<Totals> totals_{journal_};
  ObjectChanges changes_{journal_};
  Journaled<std::optional<std::vector<std::string>>> watch_names_{journal_};  ///< nothing: not known
  Frame frame_ = declaration_.frame;                                          ///< what frame() returns
  Journaled<ChosenOrigin> origin_{journal_};  ///< of a table in degrees without a declared origin
  Journaled<std::string> table_{journal_, name_.table};

  bool is_new_;               ///< this transaction has created the table
  bool gone_ = false;         ///< the table is dropped, or its creation was rolled back
  bool torn_ = false;         ///< a change failed after it wrote rows: only a rollback helps
  bool in_doubt_ = false;     ///< a rollback to a savepoint without a mark: the next access reads the stamp
  int own_statements_ = 0;    ///< own statements in progress: callbacks now are due to them
  bool rolled_back_ = false;  ///< … during which SQLite rolled everything back
  std::vector<Savepoint> savepoints_;
  std::vector<double> first_found_;  ///< the record that find() has read without the cache
};

}  // namespace foresee
