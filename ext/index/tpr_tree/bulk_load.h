// How is a whole tree written at once? Level by level from the leaves up, each node once, from the objects in
// leaf order.
#pragma once

#include "base/error.h"
#include "index/tpr_tree/state.h"

namespace foresee::index {

/// Frees every node of the tree.
void free_all(Pages& pages, Interrupt& interrupt);

/// A clock that does not run yet is set by the objects. Requires: the tree is empty.
template <int D>
void bulk_load_tree(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                    Interrupt& interrupt);

}  // namespace foresee::index
