// Scenes of a join, read from its tables: all objects, those that a tile needs, or one object and those near it.
//
//   load_scenes(tables, question, interrupt);                             // question.a and question.b
//   auto near = objects_near(*one, {"ships", nullptr, tree}, {now, h}, reach_of(question), interrupt,
//                            [](std::int64_t id) { return id != 42; });
#pragma once

#include <functional>
#include <memory>
#include <string>

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

// Objects that a tile needs, read from the tree or selected from a scene, and the pairs that the tile owns
// (tile_scenes.cpp).
//
//   auto ships = scene_of_tile(*tree, "ships", question, interrupt);      // the nodes that meet the tile
//   question = in_tile(std::move(question), interrupt);                   // and the ownership of pairs
//
// A scene may hold more than the tile needs, never less: in_tile() tests the exact box of every object.

/// Every object of the tree that `question.tile` needs. Requires: `question` is valid and has a tile; its
/// scenes are not read.
std::shared_ptr<const Scene> scene_of_tile(NodeSource& tree, const std::string& name,
                                           const JoinQuestion& question, Interrupt& interrupt);

/// Estimated fraction of the tree's nodes that scene_of_tile() would read, from a few of them.
double share_in_tile(NodeSource& tree, const JoinQuestion& question, Interrupt& interrupt);

/// If the query has a tile: sets `own`, and leaves out most objects that the tile does not need. If the tile owns all
/// pairs of the scenes, `own` stays null. Requires: `question` is valid. Cost: one swept box per object.
JoinQuestion in_tile(JoinQuestion question, Interrupt& interrupt);

}  // namespace foresee
