// What predictive_join and predictive_explain are called with: h, tbl, within, other, now, method, within_z,
// schema.
#pragma once

#include "query/join.h"
#include "sqlite/table_function.h"

namespace foresee {

/// Their names, in call order.
std::vector<const char*> join_inputs();

/// Reads the inputs and opens the tables. Throws Error where an input is missing or of the wrong kind.
JoinQuestion read_join_inputs(const Call& call);

}  // namespace foresee
