// Where do the bytes rest? The objects of one table in its shadow tables, behind plain calls.
//
//   store.insert(42, record, auxiliaries);                // record: record_offsets(layout).size doubles
//   store.read_all(ids, rows, interrupt);                 // everything, for a query
//
// Between SQLite and the rows stand a TPR-tree, and before it what a write transaction has changed but not
// written yet:
//
//   write  ─► PendingObjects ─► tree over NodeCache (nodes, MapChanges) ─► shadow rows, once a transaction
//   read   ─► pending, else the cache, else the tables
//
// Every double comes back bit for bit. All state lives in SQLite's tables, so transactions, WAL readers,
// VACUUM and backup are SQLite's own. Changes wait in memory until sync(), or until many MB wait in all
// tables of the connection together, and every read sees them. A savepoint is a mark in memory (undo_log.h):
// it writes nothing, and going back to it undoes what memory did since, while SQLite takes back what was
// written. What was read in one transaction is believed in the next only under the same stamp. Blobs are
// checked before they are believed.
//
// Auxiliary values are written at once. Every change is atomic (store_change.h): all or nothing. Errors:
// SQLite's result codes as StoreError; a blob that is not what this code wrote is SQLITE_CORRUPT_VTAB.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <unordered_set>

#include "index/tpr_tree/tpr_tree.h"
#include "storage/format/declaration.h"
#include "storage/nodes/memory_budget.h"
#include "storage/nodes/node_cache.h"
#include "storage/nodes/object_changes.h"
#include "storage/nodes/pending_objects.h"
#include "storage/rows/store_error.h"
#include "storage/table/store_state.h"
#include "storage/table/stored_forms.h"

namespace foresee {

class LeafView;

class Store final : private MemoryHolder, public FormSource, public std::enable_shared_from_this<Store> {
 public:
  /// Makes the shadow tables of a new table.
  static std::shared_ptr<Store> create(sqlite3* db, const std::string& schema, const std::string& table,
                                       const Declaration& declaration);
  /// Opens the shadow tables of an existing one. Reads nothing but _meta. In the middle of a transaction
  /// SQLite may connect a table again (any ALTER does it) while the old virtual table still holds unwritten
  /// changes: then both share one store, hence shared_ptr.
  static std::shared_ptr<Store> open(sqlite3* db, const std::string& schema, const std::string& table,
                                     const Declaration& declaration);

  const Declaration& declaration() const { return declaration_; }
  const NodeFormat& format() const { return format_; }

  // --- reading
  /// Of the contents as this connection sees them now. Cost: one look-up.
  ContentVersion read_version();
  bool contains(std::int64_t id);
  /// The record of `id`, or nothing.
  std::optional<std::vector<double>> read(std::int64_t id);
  /// The same for a statement that reads the table, again and again: empty if there is none, and good until
  /// the store is called again. Cost: the stamp once a statement; where the leaf is in memory some 100 ns.
  std::span<const double> find(std::int64_t id, StatementReadState& statement_state);
  /// Prefetches what memory has of `many` ids from `first` on. Changes nothing.
  void fetch_ahead(std::int64_t first, std::int64_t many) { cache_.fetch_ahead(first, many); }
  /// All ids and rows (row_from_record of each record), leaf by leaf, as this connection sees them now.
  /// SQLITE_CORRUPT_VTAB for a damaged leaf, and as expect_objects() says.
  void read_all(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt);
  /// The leaf that follows leaf number `after` (0 to begin): its number, or 0 at the end; fills ids and
  /// records.
  std::int64_t next_leaf(std::int64_t after, std::vector<std::int64_t>& ids, std::vector<double>& records);
  /// Hands the auxiliary column of `id` to `context` as the result; NULL where there is none.
  void result_auxiliary(sqlite3_context* context, std::int64_t id, int column);
  /// The tree as it is at this moment. Reads stay as of this moment while it is held, whatever this
  /// connection then writes, commits or rolls back to. It must not outlive the statement that asks.
  std::shared_ptr<NodeSource> take_snapshot();
  /// The newest reference time stored; 0 without objects or without t. Reads one node.
  double read_newest_t();
  /// Of the outlines or meshes that records name by number; null in a table without.
  FormSource* forms() { return forms_ ? this : nullptr; }
  /// One of them, as this connection sees them now.
  std::shared_ptr<const Form> form(std::int64_t number) override;
  /// The same for a statement that reads the table, again and again.
  std::shared_ptr<const Form> form(std::int64_t number, StatementReadState& statement_state);
  /// For snapshots; null in a table without.
  std::shared_ptr<const StoredForms::ByNumber> known_forms() { return forms_ ? forms_->known() : nullptr; }
  /// Whoever has read every leaf says how many objects there were: SQLITE_CORRUPT_VTAB if the map has others.
  /// While changed leaves wait to be written, nothing can be said.
  void expect_objects(std::size_t found);
  /// How many objects there are as far as memory knows: those of the stamp that was seen last and this
  /// transaction's; for a file of version 0.1 an estimate. Reads nothing.
  std::int64_t likely_objects() const noexcept { return count_.likely(); }

  // --- writing: each is atomic, all or nothing
  /// The id that SQLite would give to a row without one: one more than the largest.
  std::int64_t find_next_id();
  /// The outline or mesh of a well-known text, stored if it is not yet: for a record to name it by number.
  /// Throws Error for a text that is none. Requires: the layout is one whose shapes are stored apart.
  StoredForms::Known find_or_add_form(std::string_view text);
  /// Requires: no object has this id. `auxiliaries`: one value per auxiliary column.
  void insert(std::int64_t id, std::span<const double> record, std::span<sqlite3_value*> auxiliaries);
  /// Requires: `id` exists. Auxiliary values that are sqlite3_value_nochange stay as they are. Another object
  /// that has `new_id` is replaced; so INSERT OR REPLACE of an existing id is update(id, id, …).
  void update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
              std::span<sqlite3_value*> auxiliaries);
  /// Requires: `id` exists.
  void erase(std::int64_t id);

  // --- what a transaction has changed
  /// From now on for_each_change() knows; where nobody wants it nothing is kept. Not wanted any more: from
  /// the end of this transaction on. After a schema change SQLite may open another store of the table, but
  /// never while this one has changes: whoever wants them says so at each begin().
  void keep_changes(bool wanted);
  /// Calls each(id, before, after) for every object whose record is not bit for bit what it was when the
  /// transaction began, or keep_changes() within it; an empty record: there was, or is, no such object. What
  /// was taken back is no change. In the order of the first changes. Cost: a read() for each.
  void for_each_change(const std::function<void(std::int64_t id, std::span<const double> before,
                                                std::span<const double> after)>& each);
  std::size_t changes_memory() const { return object_changes_.memory(); }

  // --- who watches this table (sqlite/watch/)
  /// Names of the watches that are to be told of each commit, as this connection sees them now. Cost: a
  /// look-up, and a scan of them where another connection has written.
  const std::vector<std::string>& watches();
  /// One more, or one less. Writes a stamp, so that every connection that can write the table learns of it.
  void add_watch(const std::string& name);
  void remove_watch(const std::string& name);
  /// The stamp of what is stored; nothing while changes wait in memory. Equal stamps: equal contents.
  std::optional<std::int64_t> settled_stamp();
  /// The stamp that is in the rows, whatever waits in memory.
  std::optional<std::int64_t> stored_stamp() { return shadow_rows().read_stamp(); }
  /// The stamp from before all that for_each_change() tells: what is stored, where this transaction has
  /// changed nothing; nothing if it cannot be told what has changed ('rebuild').
  std::optional<std::int64_t> stamp_before_changes();

  // --- commands
  /// Writes tree and map anew from what the leaves hold, whatever else says, neighbours in space and velocity
  /// together; drops auxiliary values that belong to no object.
  void rebuild(Interrupt& interrupt);
  /// The same for a table without fault; SQLITE_CORRUPT_VTAB if integrity_check() finds any.
  void optimize(Interrupt& interrupt);
  /// What is wrong with the stored bytes, a sentence each; empty: nothing.
  std::vector<std::string> integrity_check(Interrupt& interrupt);

  // --- the virtual table's life, named as SQLite's callbacks
  void begin();
  void sync();
  void commit();
  void rollback();
  void savepoint(int level);
  void release(int level);
  void rollback_to(int level);
  void rename(const std::string& new_table);
  void drop();

  /// For create() and open().
  Store(sqlite3* db, QualifiedName name, Declaration declaration, const NodeFormat& format,
        std::unique_ptr<ShadowRows> rows, bool is_new, std::shared_ptr<MemoryBudget> memory);

  /// The table was dropped, or its creation was rolled back: every callback does nothing.
  bool is_gone() const { return gone_; }

  // For a table that is connected again.
  bool is_named(const std::string& table) const { return !gone_ && name_.table == table; }
  /// Everything that this transaction did here is gone, and nobody said so.
  bool is_taken_back();

  // For snapshots.
  NodeCache& nodes();
  void give_up(UndoLog::Handle mark) noexcept { cache_.give_up(mark); }

 private:
  class OwnStatements;
  class AtomicChange;

  void write_out() override;
  void drop_nodes(bool all) override { cache_.drop_nodes(all); }
  /// Tells the budget how much this table holds and how much waits.
  void note_memory() noexcept;

  /// The rows, unless the store is torn: then SQLITE_ABORT, until SQLite rolls back. SQLITE_SCHEMA for a
  /// table that is gone: SQLite prepares the statement again.
  ShadowRows& shadow_rows();
  bool has_auxiliaries() const { return !declaration_.auxiliaries.empty(); }
  [[noreturn]] void damaged(const std::string& what) const;
  template <class Body>
  auto with_sound_tree(Body body);
  /// Forgets all nodes if another connection has committed since they were read. Cost: one look-up, none
  /// where this connection is writing.
  void revalidate_cache();
  void revalidate_at_begin();
  bool read_stored(std::int64_t id, std::vector<double>& record);

  // reading (store_read.cpp)
  /// As the cache knows it while this connection writes, else as the rows say: not for pending objects.
  std::optional<std::int64_t> find_leaf(std::int64_t id);
  /// Every leaf once by ascending number, pending objects apart: as it waits in memory, or else as it is
  /// stored, checked. SQLITE_CORRUPT_VTAB for a damaged one.
  void read_leaves(Interrupt& interrupt, const std::function<void(const LeafView&)>& stored,
                   const std::function<void(const Node&)>& waiting);
  /// Hands a sound leaf to `use`; false for a sound inner node. Anything else is SQLITE_CORRUPT_VTAB.
  bool read_stored_leaf(std::int64_t number, std::span<const std::byte> blob,
                        const std::function<void(const LeafView&)>& use) const;

  // watches (store_watches.cpp)
  /// Reads their names where memory does not know them any more.
  void know_watches();
  void write_stamp_of_watches();

  // writing (store_write.cpp)
  /// What every change begins with: the record is fit to be stored, the transaction has begun and its stamp
  /// is written, memory has room. Throws before anything changes.
  void start_change(std::span<const double> record);
  /// Stores a random stamp and believes it. Costs one row.
  void write_new_stamp();
  /// The stamp that read_version() tells: a flush, which changes no object, does not move it.
  std::int64_t shown(std::int64_t stored_stamp) const;
  void about_to_change(std::int64_t id);
  [[noreturn]] void throw_missing(std::int64_t id) const;
  void take_out(std::int64_t id);
  void add(std::int64_t id, std::span<const double> record);
  /// Asks the map once a transaction.
  const LargestId& read_largest();
  void write_count(std::int64_t objects);

  // from memory to the tables (store_flush.cpp)
  /// All objects are in the tree from now on: in memory, as far as there is room. Costs nothing where none is
  /// pending.
  void merge_pending();
  void merge_into_tree(Interrupt& interrupt);
  void reload(Interrupt& interrupt);
  void append_pending(std::vector<std::int64_t>& ids, std::vector<double>& records) const;
  void flush();

  // the tree anew (store_pack.cpp)
  class PartitionedLoad;
  /// Every stored leaf, sound, until use() says false; false: it did.
  bool read_stored_leaves(Interrupt& interrupt, const std::function<bool(const LeafView&)>& use);
  /// Sorts them.
  void require_unique(std::vector<std::int64_t>& ids, Interrupt& interrupt) const;
  void pack(Interrupt& interrupt);
  void pack_partitioned(Interrupt& interrupt);
  void load_partitioned(Interrupt& interrupt);
  std::int64_t form_of(const double* record) const;
  /// Outlines that none of these numbers names go, unless a snapshot may still ask for them.
  void keep_only_forms(const std::unordered_set<std::int64_t>& used);

  // transactions (store_transactions.cpp)
  /// Something is not stored yet.
  bool waits() const { return cache_.waits() || pending_->count() > 0 || count_.added != 0; }
  void back_to(const StoreSavepoint& savepoint);
  void back_to_begin() noexcept;
  void set_table_name(const std::string& table);
  std::size_t savepoints_before(int level) const noexcept;
  void give_up_savepoints(std::size_t from) noexcept;
  /// Memory knows of no transaction any more: no savepoint, nothing pending, not torn.
  void end_transaction() noexcept;
  /// SQLite has no such table any more. It reports the end of the transaction only to tables that exist,
  /// while a statement that was prepared before may keep this store: so the store forgets everything at once.
  void close() noexcept;
  void note_change() noexcept { ++undo_position_, differs_from_version_ = true; }

  sqlite3* db_;
  QualifiedName name_;
  Declaration declaration_;
  NodeFormat format_;
  std::unique_ptr<ShadowRows> shadow_rows_;
  std::shared_ptr<MemoryBudget> memory_;
  MemoryShare share_;
  NodeCache cache_;
  std::unique_ptr<TprTree> tree_;
  std::shared_ptr<PendingObjects> pending_;  ///< shared with savepoints that would take it back
  std::unique_ptr<StoredForms> forms_;       ///< null: the layout has none
  ObjectChanges object_changes_;             ///< empty where nobody wants them
  bool keeps_changes_ = false, wants_changes_ = false;
  bool changes_unknown_ = false;      ///< more than object_changes_ tells may have changed
  std::vector<std::string> watches_;  ///< under the believed stamp
  bool watches_known_ = false;

  bool in_transaction_;
  bool is_new_;               ///< this transaction has made the table
  bool gone_ = false;         ///< the table is dropped, or was never made: nothing is read or written
  bool writing_ = false;      ///< this transaction has changed something: nobody else can
  bool stamped_ = false;      ///< … and what is stored now has a stamp of its own
  bool torn_ = false;         ///< rows were written by a change that then failed: only rolling back helps
  int own_statements_ = 0;    ///< our own statements under way: callbacks that come now are about them
  bool rolled_back_ = false;  ///< … SQLite rolled everything back among them
  std::vector<StoreSavepoint> savepoints_;
  std::uint64_t transaction_ = 1;             ///< moves whenever one ends
  std::vector<double> first_found_;           ///< what find() read past the cache, if it ever did
  std::optional<std::int64_t> cached_stamp_;  ///< the cache is as the tables were under this stamp
  std::optional<std::int64_t> stamp_before_;  ///< … before this transaction
  std::optional<std::int64_t> own_stamp_;     ///< what this transaction has written last and not taken back
  /// … by a flush, which changes no object: read_version() goes on showing the stamp from before it.
  SameContents same_contents_;
  std::string table_at_begin_;  ///< the table's name then: renaming can be taken back

  LargestId largest_;
  ObjectCount count_;         ///< under the believed stamp
  ObjectCount count_before_;  ///< … before this transaction

  bool differs_from_version_ = false;  ///< something changed since read_version() was last asked
  std::uint64_t version_changes_ = 0;  ///< the `changes` that it told then
  std::uint64_t synced_position_ = 0;  ///< of undo_position_, where all was written last
  std::uint64_t undo_position_ = 0;    ///< moves with everything that a savepoint would have to take back
};

}  // namespace foresee
