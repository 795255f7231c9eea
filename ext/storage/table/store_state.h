// State of a store besides its objects: version of the contents, number of objects, and what a savepoint
// restores.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "geography/geodesic.h"
#include "storage/nodes/pending_objects.h"
#include "storage/nodes/undo_log.h"

namespace foresee {

/// Version of a table's contents: equal versions of one table on one connection mean equal contents.
struct ContentVersion {
  std::uint64_t stamp = 0;    ///< stored; every write transaction replaces it by a random number
  std::uint64_t changes = 0;  ///< advances with uncommitted changes of this connection and with rollbacks

  friend bool operator==(const ContentVersion&, const ContentVersion&) = default;
};

/// Read state of one statement: the transaction of the connection in which it has last checked the stamp.
/// Valid only while SQLite holds the statement's read transaction on the database, which excludes commits of
/// other connections.
struct StatementReadState {
  std::uint64_t transaction = 0;  ///< 0: not yet
};

// Number of objects of a table, as far as it is known without reading.
//
//   ObjectCount count{.stored = 1000};
//   ++count.added;                          // an unwritten insert
//   count.likely() == 1001
//
// For the query planner: it never causes a read, and no result depends on it. Small enough for every
// savepoint to keep a copy.
struct ObjectCount {
  /// The count in `_meta`; nothing if version 0.1 of foresee wrote the table, or if it is out of range.
  std::optional<std::int64_t> stored = std::nullopt;
  /// Added by this transaction and not in `stored` yet; negative if objects were removed.
  std::int64_t added = 0;
  /// Used without `stored`: at first what R*Tree assumes without statistics, then the number found by the
  /// last complete read.
  std::int64_t estimate = 1048576;

  std::int64_t likely() const noexcept {
    return std::max<std::int64_t>(0, stored.value_or(estimate) + added);
  }
  /// All objects were read, including the added ones.
  void note_all(std::size_t found) noexcept { estimate = static_cast<std::int64_t>(found) - added; }
  /// The count to store; nothing if the objects must be counted.
  std::optional<std::int64_t> sum() const noexcept {
    return stored && *stored + added >= 0 ? std::optional(*stored + added) : std::nullopt;
  }
};

/// The largest id, known within a write transaction only.
struct LargestId {
  bool known = false;
  bool exact = false;  ///< else an upper bound
  std::optional<std::int64_t> id = {};
};

/// The origin that the first position of a table in degrees has chosen, as far as it is known.
struct ChosenOrigin {
  bool known = false;
  bool unwritten = false;  ///< by this transaction, and not in `_meta` yet
  std::optional<LatLon> value = {};
};

/// State that a savepoint restores: positions in logs; no objects are copied.
struct StoreSavepoint {
  int level;
  UndoLog::Handle mark;
  std::size_t map_position;
  std::shared_ptr<PendingObjects> pending;
  std::size_t pending_position;
  std::size_t changes_position;
  LargestId largest;
  ObjectCount count;
  ChosenOrigin origin;
  std::uint64_t undo_position;
  std::optional<std::int64_t> own_stamp;
  std::string table;
  bool has_unwritten;  ///< it has unwritten changes
};

/// Two stamps of the same contents.
struct SameContents {
  std::optional<std::int64_t> stored;
  std::int64_t shown = 0;
};

}  // namespace foresee
