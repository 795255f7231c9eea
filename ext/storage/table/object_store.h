// Where do the bytes rest? The objects of one table in its shadow tables, behind plain calls.
//
//   store.insert(42, record, auxiliaries);                // record: record_offsets(layout).size doubles
//   store.load(ids, rows, interrupt);                     // everything, for a query
//
// Every double comes back bit for bit. All state lives in SQLite's tables, so transactions, WAL readers,
// VACUUM and backup are SQLite's own; what a transaction has not written yet waits in memory until sync(),
// and every read sees it. Blobs are checked before they are believed.
//
// Errors: SQLite's result codes as StoreError; a blob that is not what this code wrote is
// SQLITE_CORRUPT_VTAB.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "index/pages.h"
#include "storage/format/declaration.h"
#include "storage/rows/store_error.h"

namespace foresee {

/// The state of a table's contents: equal versions of one table on one connection mean equal contents.
struct ContentVersion {
  std::uint64_t stamp = 0;    ///< rewritten at random by every write transaction, stored
  std::uint64_t changes = 0;  ///< moved by this connection's uncommitted changes and by rollbacks

  friend bool operator==(const ContentVersion&, const ContentVersion&) = default;
};

class ObjectStore {
 public:
  /// Makes the shadow tables of a new table.
  static std::shared_ptr<ObjectStore> create(sqlite3* db, const std::string& schema, const std::string& table,
                                             const Declaration& declaration);
  /// Opens the shadow tables of an existing one. Reads nothing but _meta. In the middle of a transaction
  /// SQLite may connect a table again (any ALTER does it) while the old virtual table still holds unwritten
  /// changes: then both share one store, hence shared_ptr.
  static std::shared_ptr<ObjectStore> open(sqlite3* db, const std::string& schema, const std::string& table,
                                           const Declaration& declaration);
  virtual ~ObjectStore() = default;

  virtual const Declaration& declaration() const = 0;

  // --- reading
  // ---------------------------------------------------------------------------------------------------------
  virtual ContentVersion version() = 0;
  virtual bool contains(std::int64_t id) = 0;
  /// The record of `id`, or nothing.
  virtual std::optional<std::vector<double>> read(std::int64_t id) = 0;
  /// All ids and rows (row_from_record of each record), leaf by leaf.
  virtual void load(std::vector<std::int64_t>& ids, std::vector<double>& rows, Interrupt& interrupt) = 0;
  /// The leaf that follows leaf number `after` (0 to begin): its number, or 0 at the end; fills ids and
  /// records.
  virtual std::int64_t next_leaf(std::int64_t after, std::vector<std::int64_t>& ids,
                                 std::vector<double>& records) = 0;
  /// Hands the auxiliary column of `id` to `context` as the result; NULL where there is none.
  virtual void result_auxiliary(sqlite3_context* context, std::int64_t id, int column) = 0;
  /// The tree as it is at this moment. Reads stay as of this moment while it is held, whatever this
  /// connection then writes, commits or rolls back to. It must not outlive the statement that asks.
  virtual std::shared_ptr<NodeSource> snapshot() = 0;
  /// The newest reference time stored; 0 without objects or without t. Reads one node.
  virtual double newest_t() = 0;
  /// Whoever has read every leaf says how many objects there were: SQLITE_CORRUPT_VTAB if the map has others.
  /// While changed leaves wait to be written, nothing can be said.
  virtual void expect_objects(std::size_t found) = 0;

  // --- writing: each call is all or nothing
  // ----------------------------------------------------------------------------
  /// The id that SQLite would give to a row without one: one more than the largest.
  virtual std::int64_t next_id() = 0;
  /// Requires: no object has this id. `auxiliaries`: one value per auxiliary column.
  virtual void insert(std::int64_t id, std::span<const double> record,
                      std::span<sqlite3_value*> auxiliaries) = 0;
  /// Requires: `id` exists. Auxiliary values that are sqlite3_value_nochange stay as they are. Another object
  /// that has `new_id` is replaced; so INSERT OR REPLACE of an existing id is update(id, id, …).
  virtual void update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
                      std::span<sqlite3_value*> auxiliaries) = 0;
  /// Requires: `id` exists.
  virtual void erase(std::int64_t id) = 0;

  // --- commands
  // --------------------------------------------------------------------------------------------------------
  /// Writes tree and map anew from what the leaves hold, whatever else says, neighbours in space and velocity
  /// together; drops auxiliary values that belong to no object.
  virtual void rebuild(Interrupt& interrupt) = 0;
  /// The same for a table without fault; SQLITE_CORRUPT_VTAB if check() finds any.
  virtual void optimize(Interrupt& interrupt) = 0;
  /// What is wrong with the stored bytes, a sentence each; empty: nothing.
  virtual std::vector<std::string> check(Interrupt& interrupt) = 0;

  // --- the virtual table's life, named as SQLite's callbacks
  // -----------------------------------------------------------
  virtual void begin() = 0;
  virtual void sync() = 0;
  virtual void commit() = 0;
  virtual void rollback() = 0;
  virtual void savepoint(int level) = 0;
  virtual void release(int level) = 0;
  virtual void rollback_to(int level) = 0;
  virtual void rename(const std::string& new_table) = 0;
  virtual void drop() = 0;
};

}  // namespace foresee
