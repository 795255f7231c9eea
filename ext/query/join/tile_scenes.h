// What does a tile need of a join's scenes? Read from the tree, or cut out of what is at hand.
//
//   auto ships = scene_of_tile(*tree, "ships", question, interrupt);      // the nodes that meet the tile
//   question = in_tile(std::move(question), interrupt);                   // and who owns what, for the join
//
// Scenes may hold more than the tile needs, never less: in_tile() looks at every object's own box.
#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "index/pages.h"
#include "query/join/question.h"

namespace foresee {

/// Every object of the tree that the question's tile needs. Requires: the question is valid and has a tile;
/// its scenes are not looked at.
std::shared_ptr<const Scene> scene_of_tile(NodeSource& tree, const std::string& name,
                                           const JoinQuestion& question, Interrupt& interrupt);

/// About which part of a tree's nodes scene_of_tile() would read: from a few of them.
double share_in_tile(NodeSource& tree, const JoinQuestion& question, Interrupt& interrupt);

/// The same question; where it has a tile, with `own`, and without most objects that the tile does not need.
/// A tile that owns all pairs of the scenes leaves no trace. Throws Error as require_valid() does. Cost: a
/// swept box an object.
JoinQuestion in_tile(JoinQuestion question, Interrupt& interrupt);

}  // namespace foresee
