// Table and time `now` of a search, as the inputs of predictive_window and predictive_nearest give them; and the
// default of `now` in tables with plans.
#pragma once

#include <optional>
#include <span>

#include "geography/frame.h"
#include "query/scene.h"
#include "sqlite/functions/function_call.h"
#include "sqlite/stored_table.h"

namespace foresee {

/// The numbers of the inputs that both functions have.
struct SearchInputs {
  int tbl, now, method, schema;
};

/// The one object that a search is about, and the horizon, from which its plan is read.
struct SearchedObject {
  std::int64_t id;
  double h;
};

struct SearchedTable {
  SearchTarget objects;
  double now;  ///< the input, or else the newest t stored
  Frame frame;
};

/// Throws Error if the table does not exist, and for an unknown method. With `only`, of that object
/// alone, in a scene, whatever the method.
SearchedTable searched_table(const FunctionCall& call, const SearchInputs& inputs,
                             const std::optional<SearchedObject>& only = {});

/// In a table with plans the newest t is a start, perhaps in an hour: before it nothing would be examined. Throws Error
/// if there are plans, and the object with this record has an earlier t than `now`, the default.
void require_default_now(const OpenTables& tables, std::span<const double> record, double now);

}  // namespace foresee
