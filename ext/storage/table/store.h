// Storage of one moving_objects table: a TPR-tree in shadow tables, with transactions, watches and commands.
//
//   const auto store = Store::create(db, "main", "ships", declaration);
//   store->insert(42, record, auxiliaries);               // table_writer.h
//   store->read_all(ids, rows, interrupt);                // table_reader.h
//   store->sync();
//
// All state is in SQLite's tables, so transactions, WAL readers, VACUUM and backup are SQLite's own.
#pragma once

#include "storage/table/table_writer.h"

namespace foresee {

class Store final : public TableWriter {
 public:
  /// Creates the shadow tables of a new table.
  static std::shared_ptr<Store> create(sqlite3* db, const std::string& schema, const std::string& table,
                                       const Declaration& declaration);
  /// Opens the shadow tables of an existing table, or returns the open store. Reads only _meta.
  static std::shared_ptr<Store> open(sqlite3* db, const std::string& schema, const std::string& table,
                                     const Declaration& declaration);
  using TableWriter::TableWriter;  ///< for create() and open()

  // --- watches of this table (sqlite/watch/)
  /// Names of the watches to update at each commit, as this connection sees them now. Cost: one look-up, and
  /// a scan of the names if another connection has written.
  const std::vector<std::string>& watch_names();
  /// Adds or removes a name. Writes a stamp, so that every connection reads the names again.
  void add_watch(const std::string& name);
  void remove_watch(const std::string& name);
  /// The stored stamp; nothing while changes are unwritten. Equal stamps: equal contents.
  std::optional<std::int64_t> stamp_if_written();

  // --- commands
  /// Rebuilds tree and map from the leaves alone, clustered by position and velocity; deletes auxiliary
  /// values of missing objects.
  void rebuild(Interrupt& interrupt);
  /// rebuild() of a table without damage; SQLITE_CORRUPT_VTAB if integrity_check() finds any.
  void optimize(Interrupt& interrupt);
  /// What is wrong with the stored bytes, one sentence each; empty: nothing.
  std::vector<std::string> integrity_check(Interrupt& interrupt);

  // --- callbacks of the virtual table, named as SQLite names them
  void begin() { transaction_.begin(); }
  /// Writes all that waits in memory. Does nothing if nothing waits, so a COMMIT may repeat it.
  void sync();
  void commit();
  void rollback() { transaction_.rollback(); }
  void savepoint(int level) { transaction_.savepoint(level); }
  void release(int level) { transaction_.release(level); }
  bool rollback_to(int level) noexcept { return transaction_.rollback_to(level); }
  void rename(const std::string& new_table);
  void drop();
  /// True if the table was dropped, or its creation was rolled back: then every callback does nothing.
  bool is_gone() const { return transaction_.is_gone(); }

 private:
  bool is_named(const std::string& table) const { return !is_gone() && name_.table == table; }
  void use_name(const std::string& table) override;
  void write_stamp_of_watches();
  void pack(Interrupt& interrupt);
  void pack_plans(Interrupt& interrupt);
};

// --- the open stores of all connections
// SQLite may connect a virtual table a second time during a transaction, while the first object still has unwritten
// changes. Both must use one store; the second finds it here.

/// Null if no such store is open.
std::shared_ptr<Store> find_open_store(sqlite3* db, const QualifiedName& name);
/// Registers a store under a name, as long as it exists.
void remember_open_store(sqlite3* db, const QualifiedName& name, const std::shared_ptr<Store>& store);

/// The budget of all stores of a connection, as long as one of them exists.
std::shared_ptr<MemoryBudget> memory_budget_of(sqlite3* db);

}  // namespace foresee
