// What does a store know of its table? The version of the contents, how many objects there are, what a
// savepoint goes back to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "storage/nodes/pending_objects.h"
#include "storage/nodes/undo_log.h"

namespace foresee {

/// The state of a table's contents: equal versions of one table on one connection mean equal contents.
struct ContentVersion {
  std::uint64_t stamp = 0;    ///< rewritten at random by every write transaction, stored
  std::uint64_t changes = 0;  ///< moved by this connection's uncommitted changes and by rollbacks

  friend bool operator==(const ContentVersion&, const ContentVersion&) = default;
};

/// What one statement knows of a table that it reads: in which transaction of the connection it has compared
/// memory with the stamp. Of use only while SQLite holds the statement's read transaction on the table's
/// database, which keeps other connections' commits from it.
struct StatementReadState {
  std::uint64_t transaction = 0;  ///< 0: not yet
};

// How many objects does a table have, as far as is known without reading?
//
//   ObjectCount count{.stored = 1000};
//   ++count.added;                          // an insert, not written yet
//   count.likely() == 1001
//
// For who plans: never a reason to read or to leave something out. Small enough that savepoints keep copies.

struct ObjectCount {
  /// What `_meta` says; none: nothing, since version 0.1 of foresee wrote the table, or nothing that can be.
  std::optional<std::int64_t> stored = std::nullopt;
  /// By this transaction and not yet part of what is stored; negative where it took objects away.
  std::int64_t added = 0;
  /// In place of what is not stored: at first what R*Tree assumes without statistics, then as many as were
  /// found when all were read last.
  std::int64_t estimate = 1048576;

  std::int64_t likely() const noexcept {
    return std::max<std::int64_t>(0, stored.value_or(estimate) + added);
  }
  /// All have been read, those that were added among them.
  void note_all(std::size_t found) noexcept { estimate = static_cast<std::int64_t>(found) - added; }
  /// What is to be stored; nothing if only counting tells.
  std::optional<std::int64_t> sum() const noexcept {
    return stored && *stored + added >= 0 ? std::optional(*stored + added) : std::nullopt;
  }
};

// What must a store remember to go back to a savepoint? Positions in its logs; nothing is copied.

/// The largest id, known within a write transaction only.
struct LargestId {
  bool known = false;
  bool exact = false;  ///< else no id is larger
  std::optional<std::int64_t> id = {};
};

struct StoreSavepoint {
  int level;
  UndoLog::Handle mark;
  std::size_t map_position;
  std::shared_ptr<PendingObjects> pending;
  std::size_t pending_position;
  std::size_t changes_position;
  LargestId largest;
  ObjectCount count;
  std::uint64_t undo_position;
  std::optional<std::int64_t> own_stamp;
  std::string table;
  bool waits;  ///< something that only memory knows
};

/// Two stamps of the same contents.
struct SameContents {
  std::optional<std::int64_t> stored;
  std::int64_t shown = 0;
};

}  // namespace foresee
