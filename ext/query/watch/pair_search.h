// Search for the objects that a transaction has changed, and for their current pairs.
//
//   const ChangedSides changed = changed_sides(tables, state);
//   PairSearch search(tables, question_of(tables, state, {clock, h}), resources);
//   search.find_pairs_of(Side::a, changed.a.ids, [&](const JoinRow& row) { … });
//
// Guarantee: reports every pair of these objects that is in contact within the horizon, once for each of its
// changed objects. No object is paired with itself; for pairs within a table the smaller id is first. Cost: a probe
// of the other side's tree per object; for many objects, one join of them with all others.
#pragma once

#include <functional>
#include <span>

#include "index/all_pairs.h"
#include "query/join/question.h"
#include "query/legs/leg_scene.h"
#include "query/table_source.h"
#include "query/watch/watch_state.h"

namespace foresee {

/// The objects that differ, perhaps, from those of a watch's rows.
struct ChangedSides {
  ChangedObjects a, b;  ///< equal within one table
};
ChangedSides changed_sides(const JoinedTables& tables, const WatchState& state);

/// Whether either table has an object. Cost: a node per table.
bool any_object(const JoinedTables& tables);

/// Whether the objects are so many that a join of all is cheaper than reading their old and new pairs.
bool is_majority(const ChangedObjects& changed, const TableSource& table);

class PairSearch {
 public:
  using UseRow = std::function<void(const JoinRow&)>;

  /// `question`: from question_of(), with `wants` as needed. All arguments must outlive the search.
  PairSearch(const JoinedTables& tables, JoinQuestion question, const JoinResources& resources);

  /// Calls use() for the pairs with one of these objects on this side; within one table, on either side.
  void find_pairs_of(Side side, std::span<const std::int64_t> ids, const UseRow& use);

 private:
  /// Searches the tree of the other side for one object.
  void probe(Side side, std::int64_t id, const SearchTarget& others, const UseRow& use);
  /// Joins these objects with all of the other side.
  void join(Side side, std::span<const std::int64_t> ids, const UseRow& use);
  /// Calls use() for these rows, as the guarantee has them: no object with itself, the smaller id first.
  void pass_on(std::span<const JoinRow> found, const UseRow& use) const;
  LegTimes times() const { return leg_times_of({question_.now, question_.h}); }
  TableSource& table(Side side) const { return side == Side::b ? tables_.side_b() : *tables_.a; }

  const JoinedTables& tables_;
  JoinQuestion question_;
  const JoinResources& resources_;
  PairRule::Reach reach_;
};

}  // namespace foresee
