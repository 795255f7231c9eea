// Integrity check of the shadow tables: 'integrity-check', and PRAGMA integrity_check since SQLite 3.44.
//
// docs/developers/storage_format.md#corruption-detection lists what it checks. Cost: one pass over the tables, one tree
// traversal, and some tens of bytes per object.
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
