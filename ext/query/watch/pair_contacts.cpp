#include "query/watch/pair_contacts.h"

#include <algorithm>
#include <limits>

#include "base/float_environment.h"
#include "query/join/contact_stage.h"
#include "query/join/pair_kinds.h"

namespace foresee {
namespace {

constexpr std::size_t batch_size = 1024, pairs_at_once = 8192;

/// Stands for pairs that the caller gives: no search.
class NoCandidates final : public Candidates {
 public:
  bool next(std::vector<Pair>&) override { return false; }
};

std::optional<std::uint32_t> row_of(const Scene& scene, std::int64_t id) {
  const auto found = std::lower_bound(scene.ids.begin(), scene.ids.end(), id);
  if (found == scene.ids.end() || *found != id) return std::nullopt;
  return static_cast<std::uint32_t>(found - scene.ids.begin());
}

std::vector<std::int64_t> sorted_ids(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void append_contacts(const JoinedTables& tables, JoinQuestion question, std::span<const PairIds> pairs,
                     Interrupt& interrupt, std::vector<JoinRow>& rows) {
  std::vector<std::int64_t> a, b;
  const bool one_scene = tables.is_within_one();
  for (const PairIds& pair : pairs) a.push_back(pair.a), (one_scene ? a : b).push_back(pair.b);
  question.a = tables.a->objects(sorted_ids(std::move(a)));
  if (tables.b) question.b = one_scene ? question.a : tables.b->objects(sorted_ids(std::move(b)));
  std::vector<Pair> numbers;
  for (const PairIds& pair : pairs) {
    const auto row_a = row_of(*question.a, pair.a);
    const auto row_b = row_of(question.b ? *question.b : *question.a, pair.b);
    if (row_a && row_b) numbers.push_back({*row_a, *row_b});
  }
  const std::vector<JoinRow> found = pair_contacts(question, numbers, interrupt);
  rows.insert(rows.end(), found.begin(), found.end());
}

}  // namespace

JoinQuestion question_of(const JoinedTables& tables, const WatchDeclaration& declaration,
                         const Horizon& horizon) {
  JoinQuestion question;
  question.a = empty_scene(*tables.a);
  if (tables.b) question.b = tables.are_one() ? question.a : empty_scene(*tables.b);
  question.now = horizon.now, question.h = horizon.h;
  question.within = declaration.within, question.within_z = declaration.within_z;
  return question;
}

JoinQuestion question_of_all(const JoinedTables& tables, const WatchDeclaration& declaration,
                             const Horizon& horizon, const JoinResources& resources) {
  JoinQuestion question = question_of(tables, declaration, horizon);
  question.a = tables.a->all();
  if (tables.b) question.b = tables.are_one() ? question.a : tables.b->all();
  question.space = resources.space, question.helpers = resources.helpers;
  return question;
}

std::vector<JoinRow> contacts_of(const JoinedTables& tables, const JoinQuestion& question,
                                 std::span<const PairIds> pairs, Interrupt& interrupt) {
  std::vector<JoinRow> rows;
  for (std::size_t begin = 0; begin < pairs.size(); begin += pairs_at_once)
    append_contacts(tables, question, pairs.subspan(begin, std::min(pairs_at_once, pairs.size() - begin)),
                    interrupt, rows);
  return rows;
}

std::vector<JoinRow> pair_contacts(const JoinQuestion& queried, std::span<const Pair> pairs,
                                   Interrupt& interrupt) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const FloatEnvironment environment;
  require_valid(queried);
  std::vector<JoinRow> rows;
  if (pairs.empty()) return rows;
  std::optional<JoinQuestion> with;
  if (has_kinds(queried)) with = with_kinds(queried);
  const JoinQuestion& question = with ? *with : queried;
  ContactStage stage(question, interrupt);
  const TimeSlab all{-inf, inf, {question.now, question.h}};
  const NoCandidates none;
  std::vector<Pair> batch;
  for (std::size_t begin = 0; begin < pairs.size(); begin += batch_size) {
    interrupt.check();
    const auto part = pairs.subspan(begin, std::min(batch_size, pairs.size() - begin));
    batch.assign(part.begin(), part.end());
    if (question.kinds)
      std::erase_if(batch, [&](const Pair& pair) { return !question.kinds->may_meet(pair); });
    stage.answer(none, batch, all, rows);
  }
  return rows;
}

}  // namespace foresee
