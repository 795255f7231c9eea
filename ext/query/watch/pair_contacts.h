// The join queries of a watch, and the contact times of given pairs: the exact stage of a join without a search.
//
//   const JoinQuestion question = question_of(tables, state, {clock, state.horizon});
//   for (const JoinRow& row : contacts_of(tables, question, pairs, interrupt)) use(row.a, row.b, row.contact.t);
//
// Guarantee: a row for each pair that may meet and touches during [now, now + h], with the same numbers as
// the join gives; the others are left out. Objects with plans have the contacts of their legs, joined
// (legs/mover_contacts.h). Rows come in the order of the pairs, within one scene the smaller id first.
// Cost: some hundred nanoseconds per pair, and a look-up per object.
#pragma once

#include <span>
#include <vector>

#include "query/join/question.h"
#include "query/table_source.h"
#include "query/watch/watch_state.h"

namespace foresee {

/// The join query of the watch during `horizon`, with empty scenes. It wants the times of contacts, not the closest
/// approach.
JoinQuestion question_of(const JoinedTables& tables, const WatchDeclaration& declaration,
                         const Horizon& horizon);
/// question_of() with the scenes of all objects but inert ones (pair_kinds.h).
JoinQuestion question_of_all(const JoinedTables& tables, const WatchDeclaration& declaration,
                             const Horizon& horizon, const JoinResources& resources);

struct PairIds {
  std::int64_t a, b;

  friend auto operator<=>(const PairIds&, const PairIds&) = default;
};

/// One row for each of the pairs that is in contact within the horizon of `question`, with the fields that it
/// wants. Pairs of an object that does not exist are left out.
std::vector<JoinRow> contacts_of(const JoinedTables& tables, const JoinQuestion& question,
                                 std::span<const PairIds> pairs, Interrupt& interrupt);

/// `pairs`: numbers of objects in the scenes of `queried` (Scene::rows_of). Throws Error as Join does.
std::vector<JoinRow> pair_contacts(const JoinQuestion& queried, std::span<const Pair> pairs,
                                   Interrupt& interrupt);

}  // namespace foresee
