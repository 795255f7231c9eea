#include "sqlite/watch/pair_search.h"

#include "query/join/join.h"
#include "query/join/probe.h"
#include "query/watch/pair_contacts.h"

namespace foresee {
namespace {

// A probe costs about ten microseconds. The join of a few objects with all decodes all of them, at about a
// hundred nanoseconds per object. Either way the pairs of a changed object are read and written.
constexpr double few = 32, share_of_few = 1.0 / 50, many = 64, share_of_many = 0.3;

double objects_of(const Connection::OpenTable& table) {
  return static_cast<double>(table.store->likely_objects());
}

}  // namespace

ChangedObjects changed_objects(const Connection::OpenTable& table, const std::optional<std::int64_t>& stamp) {
  ChangedObjects changed;
  changed.reported = stamp && stamp == table.store->stamp_before_changes();
  if (!changed.reported) return changed;
  const int t = table.store->format().at.t;
  table.store->for_each_change([&](std::int64_t id, std::span<const double>, std::span<const double> after) {
    changed.ids.push_back(id);
    if (!after.empty() && t >= 0) changed.instants.push_back(after[static_cast<std::size_t>(t)]);
  });
  std::sort(changed.ids.begin(), changed.ids.end());
  return changed;
}

bool is_majority(const ChangedObjects& changed, const Connection::OpenTable& table) {
  return static_cast<double>(changed.ids.size()) > std::max(many, share_of_many * objects_of(table));
}

PairSearch::PairSearch(Connection& connection, const WatchedTables& tables, JoinQuestion question)
    : connection_(connection),
      tables_(tables),
      question_(std::move(question)),
      reach_(contact_of(question_)->reach()) {}

void PairSearch::pairs_of(Side side, std::span<const std::int64_t> ids, const Take& take) {
  if (ids.empty()) return;
  const Connection::OpenTable& others = table(side == Side::a ? Side::b : Side::a);
  if (static_cast<double>(ids.size()) > std::max(few, share_of_few * objects_of(others)))
    return join(side, ids, take);
  const auto tree = others.store->take_snapshot();
  for (const std::int64_t id : ids) probe(side, id, *tree, take);
}

void PairSearch::probe(Side side, std::int64_t id, NodeSource& others_tree, const Take& take) {
  const bool by_a = side == Side::a;
  const std::shared_ptr<const Scene> object = scene_of(connection_, table(side), std::span(&id, 1));
  if (object->size() == 0) return;
  const bool within_one = !tables_.b || tables_.are_one();
  const auto near = objects_near(*object, others_tree, table(by_a ? Side::b : Side::a).table,
                                 {question_.now, question_.h}, reach_, connection_.interrupt(),
                                 [&](std::int64_t other) { return !within_one || other != id; });
  if (near->size() == 0) return;
  JoinQuestion question = question_;
  question.a = by_a ? object : near, question.b = by_a ? near : object;
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < near->size(); ++i) pairs.push_back(by_a ? Pair{0, i} : Pair{i, 0});
  take(pair_contacts(question, pairs, connection_.interrupt()));
}

void PairSearch::join(Side side, std::span<const std::int64_t> ids, const Take& take) {
  JoinQuestion question = question_;
  question.a = connection_.load_scene(tables_.a);
  question.b = !tables_.b || tables_.are_one() ? question.a : connection_.load_scene(*tables_.b);
  question.space = connection_.grid_space(), question.helpers = connection_.helper_threads();
  (side == Side::a ? question.a : question.b) = scene_of(connection_, table(side), ids);
  const bool within_one = !tables_.b || tables_.are_one();
  Join join(std::move(question), connection_.interrupt());
  std::vector<JoinRow> others;
  for (auto rows = join.next(); !rows.empty(); rows = join.next()) {
    if (!within_one) {
      take(rows);
      continue;
    }
    others.clear();  // without each object's contact with itself
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(others),
                 [](const JoinRow& row) { return row.a != row.b; });
    take(others);
  }
}

}  // namespace foresee
