// Is what the shadow tables say consistent? 'integrity-check' and its SQLite 3.44 counterpart.
//
// Looks at every byte: each node's checksum and contents, no id twice, map and leaves agree both ways, one
// auxiliary row an object, every outline or mesh and each object's box around its own; then at the tree:
// levels and parents, times, every object within the bounds of all entries above it (as they are stored, so
// at every moment), no node that no way leads to. Cost: one pass over the tables, one walk, and some tens of
// bytes an object.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "storage/nodes/node_cache.h"
#include "storage/rows/shadow_rows.h"
#include "storage/rows/shape_rows.h"

namespace foresee {

/// What is wrong, a sentence each, at most some hundred; empty: nothing. `shapes`: null in a table without.
/// Requires: nothing waits in `cache`.
std::vector<std::string> check_integrity(ShadowRows& rows, NodeCache& cache, const NodeFormat& format,
                                         const QualifiedName& name, bool has_auxiliaries, ShapeRows* shapes,
                                         Interrupt& interrupt);

}  // namespace foresee
