// When are the contents of a table what they were?
#pragma once

#include <cstdint>

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
struct StatementBelief {
  std::uint64_t transaction = 0;  ///< 0: not yet
};

}  // namespace foresee
