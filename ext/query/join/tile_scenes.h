// Scenes of a join: all objects, or those that a tile needs, read from the tree or selected from a scene.
//
//   take_scenes(tables, question, interrupt);                             // question.a and question.b
//   auto ships = scene_of_tile(*tree, "ships", question, interrupt);      // the nodes that meet the tile
//   question = in_tile(std::move(question), interrupt);                   // and the ownership of pairs
//
// A scene may hold more than the tile needs, never less: in_tile() tests the exact box of every object.
#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "index/pages.h"
#include "query/join/pair_kinds.h"
#include "query/join/question.h"
#include "query/table_source.h"

namespace foresee {

/// Sets both sides to scenes of all current objects, with the tree's levels for the method `tree`. With a
/// tile, a scene may hold only the objects that the tile needs. The same table on both sides is one scene.
/// Inert objects (pair_kinds.h) may be left out unless they are to be counted. Throws Error as require_valid() does,
/// if there is a tile.
void take_scenes(const JoinedTables& tables, JoinQuestion& question, Interrupt& interrupt,
                 InertObjects inert = InertObjects::left_out);

/// Every object of the tree that `question.tile` needs. Requires: `question` is valid and has a tile; its
/// scenes are not read.
std::shared_ptr<const Scene> scene_of_tile(NodeSource& tree, const std::string& name,
                                           const JoinQuestion& question, Interrupt& interrupt);

/// Estimated fraction of the tree's nodes that scene_of_tile() would read, from a few of them.
double share_in_tile(NodeSource& tree, const JoinQuestion& question, Interrupt& interrupt);

/// The same query; if it has a tile, with `own`, and without most objects that the tile does not need. If the
/// tile owns all pairs of the scenes, `own` stays null. Throws Error as require_valid() does. Cost: one swept
/// box per object.
JoinQuestion in_tile(JoinQuestion question, Interrupt& interrupt);

}  // namespace foresee
