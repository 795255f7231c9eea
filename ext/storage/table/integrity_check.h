// Integrity check of the shadow tables: 'integrity-check', and PRAGMA integrity_check since SQLite 3.44.
//
// Of the bytes it checks checksum and contents of each node, that no id is stored twice, and that map and
// leaves agree in both directions. It also checks for one auxiliary row per object, every outline or mesh,
// and the box of each object with one. Chunks of plans, objects and the tree of chunks agree, and each box contains its
// legs. Of a tree it checks levels, parents and times. Every object must be
// within the stored bounds of all entries above it at every time, and no node may be unreachable. Cost: one
// pass over the tables, one tree traversal, and some tens of bytes per object.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "storage/nodes/node_cache.h"
#include "storage/rows/shadow_rows.h"
#include "storage/rows/shape_rows.h"
#include "storage/table/stored_plans.h"

namespace foresee {

/// Returns what is wrong, one sentence each, at most some hundred; empty: nothing. `shapes`, `plans`: null in a
/// table without. Requires: no unwritten changes in `cache`.
std::vector<std::string> check_integrity(ShadowRows& rows, NodeCache& cache, const NodeFormat& format,
                                         const QualifiedName& name, bool has_auxiliaries, ShapeRows* shapes,
                                         StoredPlans* plans, Interrupt& interrupt);

}  // namespace foresee
