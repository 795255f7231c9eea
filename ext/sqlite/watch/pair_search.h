// Search for the objects that a transaction has changed, and for their current pairs.
//
//   const ChangedObjects changed = changed_objects(tables.a, state.stamp);
//   PairSearch search(connection, tables, question_of(tables, state, {clock, h}));
//   search.pairs_of(Side::a, changed.ids, [&](std::span<const JoinRow> rows) { … });
//
// Guarantee: reports every pair of these objects that is in contact within the horizon, once for each of its
// changed objects. Within one table a pair may have either order. Cost: a probe of the other side's tree per
// object; for many objects, one join of them with all others.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "index/one_with_all.h"
#include "sqlite/watch/watched_tables.h"

namespace foresee {

/// The objects of one table that this transaction has changed.
struct ChangedObjects {
  bool reported = true;           ///< false: any object may have changed
  std::vector<std::int64_t> ids;  ///< in rising order
  std::vector<double> instants;   ///< their current reference times

  bool holds(std::int64_t id) const { return std::binary_search(ids.begin(), ids.end(), id); }
};

struct ChangedSides {
  ChangedObjects a, b;  ///< equal for a watch within one table
};

/// The changes since the table's contents had this stamp.
ChangedObjects changed_objects(const Connection::OpenTable& table, const std::optional<std::int64_t>& stamp);

/// Whether the objects are so many that a join of all is cheaper than reading their old and new pairs.
bool is_majority(const ChangedObjects& changed, const Connection::OpenTable& table);

class PairSearch {
 public:
  using Take = std::function<void(std::span<const JoinRow>)>;

  /// `question`: from question_of(), with `wants` set. All arguments must outlive the search.
  PairSearch(Connection& connection, const WatchedTables& tables, JoinQuestion question);

  /// The pairs with one of these objects on this side; within one table, on either side.
  void pairs_of(Side side, std::span<const std::int64_t> ids, const Take& take);

 private:
  void probe(Side side, std::int64_t id, NodeSource& others_tree, const Take& take);
  void join(Side side, std::span<const std::int64_t> ids, const Take& take);
  const Connection::OpenTable& table(Side side) const {
    return side == Side::b && tables_.b ? *tables_.b : tables_.a;
  }

  Connection& connection_;
  const WatchedTables& tables_;
  JoinQuestion question_;
  Contact::Reach reach_;
};

}  // namespace foresee
