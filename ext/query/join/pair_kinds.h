// Kinds in a join: collision filtering of its pairs by category and mask (shape/kinds.h).
//
//   JoinQuestion question = with_kinds(in_tile(without_inert(queried, interrupt), interrupt));
//   auto candidates = meeting_candidates(make_all_pairs(count, interrupt), question.kinds);
//
// An object is inert if no object of the other side may meet it: then it is not read (scene_without_inert()). Where a
// scene of all objects has it, the index does not get it (without_inert()). Of the other pairs the grid and the tree
// keep those that may meet; a filter does the same for the other methods.
//
// Guarantee: of the queried pairs exactly those remain that may meet. Cost: one pass over the rows of a
// scene, which keeps the result; without the columns none. Join, explain and watch call these functions.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "index/candidates.h"
#include "query/join/question.h"
#include "query/table_source.h"
#include "shape/kinds.h"

namespace foresee {

/// The kinds of a scene's objects, by row number.
struct SceneKinds {
  std::vector<Kinds> of;
  Kinds all = Kinds::none();                ///< or-ed
  Kinds common = {every_kind, every_kind};  ///< and-ed

  /// The scene without the objects that may meet none of `partner_kinds`, of the last join that left some out.
  std::shared_ptr<const Scene> active = nullptr;
  Kinds partner_kinds = Kinds::none();
};

/// Whether a scene has the objects that may meet none of the other side.
enum class InertObjects : std::uint8_t { left_out, counted };

/// The kinds of both sides.
struct PairKinds {
  std::shared_ptr<const SceneKinds> a, b;  ///< equal where both sides are one scene

  /// Whether all pairs may meet, by the bits that all objects have: then candidates need no test.
  bool all_meet() const { return foresee::may_meet(a->common, b->common); }
  bool may_meet(const Pair& pair) const { return foresee::may_meet(a->of[pair.a], b->of[pair.b]); }
};

/// table.all(needs), where objects that may meet none of `others` may be missing. Without category and mask, and with
/// plans, all() itself. Cost: as all(), without the rows and subtrees that are left out.
std::shared_ptr<const Scene> scene_without_inert(TableSource& table, TableSource& others,
                                                 SceneNeeds needs = {});

/// Whether a side has category or mask.
bool has_kinds(const JoinQuestion& question);

/// Leaves out the inert objects of both scenes. A scene with outlines or meshes keeps them.
JoinQuestion without_inert(JoinQuestion question, Interrupt& interrupt);

/// Sets `kinds` if a side has category or mask. Row numbers must not change afterwards.
JoinQuestion with_kinds(JoinQuestion question);

/// The candidates that may meet, in their order.
std::unique_ptr<Candidates> meeting_candidates(std::unique_ptr<Candidates> all,
                                               std::shared_ptr<const PairKinds> kinds);

/// The number of queried pairs that may meet; in a tile, of the objects that it needs. Requires: `kinds` is set.
/// Cost: the square of the number of different kinds.
std::uint64_t count_meeting(const JoinQuestion& question, Interrupt& interrupt);

}  // namespace foresee
