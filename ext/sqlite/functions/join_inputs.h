// What predictive_join and predictive_explain are called with: h, tbl, within, other, now, method, within_z,
// schema.
#pragma once

#include "query/join/join.h"
#include "sqlite/functions/table_function.h"

namespace foresee {

/// Their names, in call order.
std::vector<const char*> join_inputs();

/// The ids that the query wants in columns a and b.
struct AskedIds {
  std::optional<std::int64_t> a = {}, b = {};
};

/// Reads the inputs and opens the tables. A question about one id comes back as one about that object and
/// those near it, looked up in the tree, unless another method was asked for. Throws Error where an input is
/// missing or of the wrong kind.
JoinQuestion read_join_inputs(const Call& call, const AskedIds& ids = {});

}  // namespace foresee
