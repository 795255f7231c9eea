#include "query/watch/pair_search.h"

#include "query/join/join.h"
#include "query/join/join_scenes.h"
#include "query/join/pair_kinds.h"
#include "query/watch/pair_contacts.h"

namespace foresee {
namespace {

// A probe costs about ten microseconds. The join of a few objects with all decodes all of them, at about a
// hundred nanoseconds per object. Either way the pairs of a changed object are read and written.
// So many objects are probed for, or this share of the other table if that is more.
constexpr double probed_always = 32;
constexpr double probed_share = 1.0 / 50;

// Changed objects are a majority if they are more than both.
constexpr double majority_above = 64;
constexpr double majority_share = 0.3;

}  // namespace

ChangedSides changed_sides(const JoinedTables& tables, const WatchState& state) {
  ChangedSides changed{.a = tables.a->changes_since(state.stamp), .b = {}};
  changed.b = tables.is_within_one() ? changed.a : tables.b->changes_since(state.other_stamp);
  return changed;
}

bool any_object(const JoinedTables& tables) {
  return tables.a->tree()->find_root() != 0 ||
         (!tables.is_within_one() && tables.b->tree()->find_root() != 0);
}

bool is_majority(const ChangedObjects& changed, const TableSource& table) {
  return static_cast<double>(changed.ids.size()) >
         std::max(majority_above, majority_share * table.likely_objects());
}

PairSearch::PairSearch(const JoinedTables& tables, JoinQuestion question, const JoinResources& resources)
    : tables_(tables), question_(std::move(question)), resources_(resources), reach_(reach_of(question_)) {}

void PairSearch::find_pairs_of(Side side, std::span<const std::int64_t> ids, const UseRow& use) {
  if (ids.empty()) return;
  TableSource& others = table(side == Side::a ? Side::b : Side::a);
  if (static_cast<double>(ids.size()) > std::max(probed_always, probed_share * others.likely_objects()))
    return join(side, ids, use);
  const SearchTarget trees = trees_of(others);
  for (const std::int64_t id : ids) probe(side, id, trees, use);
}

void PairSearch::probe(Side side, std::int64_t id, const SearchTarget& others, const UseRow& use) {
  const bool by_a = side == Side::a;
  const std::shared_ptr<const Scene> object = table(side).objects(std::span(&id, 1), times());
  if (object->size() == 0) return;
  const bool finds_itself = tables_.is_within_one();
  const auto found = objects_near(*object, others, {question_.now, question_.h}, reach_, resources_.interrupt,
                                  [&](std::int64_t other) { return !finds_itself || other != id; });
  if (found->size() == 0) return;
  JoinQuestion question = question_;
  question.a = by_a ? object : found;
  question.b = by_a ? found : object;
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < found->object_count(); ++i) pairs.push_back(by_a ? Pair{0, i} : Pair{i, 0});
  pass_on(pair_contacts(question, pairs, resources_.interrupt), use);
}

void PairSearch::join(Side side, std::span<const std::int64_t> ids, const UseRow& use) {
  JoinQuestion question = question_;
  const auto changed = table(side).objects(ids, times());
  const auto all = scene_without_inert(table(side == Side::a ? Side::b : Side::a), table(side));
  question.a = side == Side::a ? changed : all;
  question.b = side == Side::a ? all : changed;
  question.space = resources_.space;
  question.helpers = resources_.helpers;
  Join join(std::move(question), resources_.interrupt);
  for (auto rows = join.next(); !rows.empty(); rows = join.next()) pass_on(rows, use);
}

/// The search is between the changed objects and all, which are the same table perhaps.
void PairSearch::pass_on(std::span<const JoinRow> found, const UseRow& use) const {
  for (JoinRow row : found) {
    if (tables_.is_within_one() && row.a == row.b) continue;
    if (!tables_.b && row.b < row.a) std::swap(row.a, row.b);
    use(row);
  }
}

}  // namespace foresee
