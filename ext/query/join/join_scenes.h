// Scenes of a join, read from its tables: all objects, those that a tile needs, or one object and those near it.
//
//   load_scenes(tables, question, interrupt);                             // question.a and question.b
//   auto near = objects_near(*one, {"ships", nullptr, tree}, {now, h}, reach_of(question), interrupt,
//                            [](std::int64_t id) { return id != 42; });
#pragma once

#include <functional>
#include <memory>

#include "base/error.h"
#include "contact/pair_rule.h"
#include "index/pages.h"
#include "query/join/pair_kinds.h"
#include "query/join/question.h"
#include "query/table_source.h"

namespace foresee {

/// Sets both sides to scenes of all current objects, with the tree's levels for the method `tree`. With a tile, a scene
/// may hold only the objects that the tile needs. Inert objects (pair_kinds.h) may be left out unless they are to be
/// counted. The same table on both sides is one scene.
///
/// With `only_a` or `only_b`, and a method that may use the tree, one side has the object of this id and the other the
/// objects that may touch it. That id is then cleared, and the method becomes `scan`.
///
/// Throws Error as require_valid() does, if there is a tile or such an id.
void load_scenes(const JoinedTables& tables, JoinQuestion& question, Interrupt& interrupt,
                 InertObjects inert = InertObjects::left_out);

/// Objects of a tree near the one object of a scene, which may be empty. Guarantee: every object that `keep`
/// accepts and that touches it during the horizon is in the result, once; others may be too. Those that may not
/// meet it (shape/kinds.h) are not. Of objects with plans the result has the legs that may touch, and others.
/// `others`: with a tree. Cost: the nodes whose bounds intersect the moving boxes of the object's legs. Memory:
/// the result.
std::shared_ptr<const Scene> objects_near(const Scene& one, const SearchTarget& others,
                                          const Horizon& horizon, const PairRule::Reach& reach,
                                          Interrupt& interrupt,
                                          const std::function<bool(std::int64_t)>& keep);

}  // namespace foresee
