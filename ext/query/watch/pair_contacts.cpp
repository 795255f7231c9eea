#include "query/watch/pair_contacts.h"

#include <algorithm>
#include <limits>

#include "base/float_environment.h"
#include "query/join/contact_stage.h"
#include "query/join/pair_kinds.h"
#include "query/legs/leg_scene.h"
#include "query/legs/mover_pair.h"

namespace foresee {
namespace {

constexpr std::size_t batch_size = 1024, pairs_at_once = 8192;

/// The number of an object in a scene whose ids ascend.
std::optional<std::uint32_t> object_of(const Scene& scene, std::int64_t id) {
  const auto found = std::lower_bound(scene.ids.begin(), scene.ids.end(), id);
  if (found == scene.ids.end() || *found != id) return std::nullopt;
  const auto row = static_cast<std::uint32_t>(found - scene.ids.begin());
  if (!scene.layout.has_plan) return row;
  const auto& first_rows = scene.first_rows;
  return static_cast<std::uint32_t>(std::lower_bound(first_rows.begin(), first_rows.end(), row) -
                                    first_rows.begin());
}

std::vector<std::int64_t> sorted_ids(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// The first legs of two movers that exist together at `now` or later. Requires: such legs exist.
Pair legs_together(const Movers& a, const Movers& b, const Pair& movers, double now) {
  Pair first{};
  for_leg_pairs(a, b, movers, now, [&](const Pair& legs) {
    first = legs;
    return false;
  });
  return first;
}

/// Appends the first contact of each pair of movers, as ContactStage does for objects without plans.
void append_mover_contacts(const JoinQuestion& question, std::span<const Pair> pairs, Interrupt& interrupt,
                           std::vector<JoinRow>& rows) {
  const Movers a(question.a), b(question.b ? question.b : question.a);
  const auto contact = contact_of(question);
  contact->set_interrupt(interrupt);
  MoverPair both(a, b, *contact, {question.now, question.h}, interrupt);
  const double end = leg_times_of({question.now, question.h}).until;
  std::vector<ContactTimes> contacts;
  for (const Pair& pair : pairs) {
    interrupt.check();
    if (question.kinds && !question.kinds->may_meet({a.first(pair.a), b.first(pair.b)})) continue;
    both.contacts_within(pair, question.now, end, contacts);
    if (contacts.empty()) continue;
    JoinRow& row = rows.emplace_back();
    row.a = a.id(pair.a);
    row.b = b.id(pair.b);
    row.contact = contacts.front();
    if (!question.b && row.b < row.a) std::swap(row.a, row.b);
    if (question.wants.approach)
      row.approach = both.closest_approach(legs_together(a, b, pair, question.now));
  }
}

void append_contacts(const JoinedTables& tables, JoinQuestion question, std::span<const PairIds> pairs,
                     Interrupt& interrupt, std::vector<JoinRow>& rows) {
  std::vector<std::int64_t> a, b;
  const bool one_scene = tables.is_within_one();
  for (const PairIds& pair : pairs) {
    a.push_back(pair.a);
    (one_scene ? a : b).push_back(pair.b);
  }
  const LegTimes times = leg_times_of({question.now, question.h});
  question.a = tables.a->objects(sorted_ids(std::move(a)), times);
  if (tables.b) question.b = one_scene ? question.a : tables.b->objects(sorted_ids(std::move(b)), times);
  std::vector<Pair> numbers;
  for (const PairIds& pair : pairs) {
    const auto object_a = object_of(*question.a, pair.a);
    const auto object_b = object_of(question.b ? *question.b : *question.a, pair.b);
    if (object_a && object_b) numbers.push_back({*object_a, *object_b});
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
  question.now = horizon.now;
  question.h = horizon.h;
  question.within = declaration.within;
  question.within_z = declaration.within_z;
  question.wants.approach = false;
  return question;
}

JoinQuestion question_of_all(const JoinedTables& tables, const WatchDeclaration& declaration,
                             const Horizon& horizon, const JoinResources& resources) {
  JoinQuestion question = question_of(tables, declaration, horizon);
  question.a = scene_without_inert(*tables.a, tables.side_b());
  if (tables.b) question.b = tables.are_one() ? question.a : scene_without_inert(*tables.b, *tables.a);
  question.space = resources.space;
  question.helpers = resources.helpers;
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
  if (has_plans(question)) {
    append_mover_contacts(question, pairs, interrupt, rows);
    return rows;
  }
  ContactStage stage(question, interrupt);
  const TimeSlab all{-inf, inf, {question.now, question.h}};
  std::vector<Pair> batch;
  for (std::size_t begin = 0; begin < pairs.size(); begin += batch_size) {
    interrupt.check();
    const auto part = pairs.subspan(begin, std::min(batch_size, pairs.size() - begin));
    batch.assign(part.begin(), part.end());
    if (question.kinds)
      std::erase_if(batch, [&](const Pair& pair) { return !question.kinds->may_meet(pair); });
    stage.find_and_write(batch, BatchProof::none, all, rows);
  }
  return rows;
}

}  // namespace foresee
