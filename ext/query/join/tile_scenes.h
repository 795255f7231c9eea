// Objects that a tile needs, read from the tree or selected from a scene, and the pairs that the tile owns.
//
//   auto ships = scene_of_tile(*tree, "ships", question, interrupt);      // the nodes that meet the tile
//   question = in_tile(std::move(question), interrupt);                   // and the ownership of pairs
//
// A scene may hold more than the tile needs, never less: in_tile() tests the exact box of every object.
#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "index/pages.h"
#include "query/join/question.h"

namespace foresee {

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
