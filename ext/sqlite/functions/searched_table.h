// Table and time `now` of a search, as the inputs of predictive_window and predictive_nearest give them.
#pragma once

#include "geography/frame.h"
#include "query/scene.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// The numbers of the inputs that both functions have.
struct SearchInputs {
  int tbl, now, method, schema;
};

struct SearchedTable {
  SearchTarget objects;
  double now;  ///< the input, or else the newest t stored
  Frame frame;
};

/// Throws Error if the table does not exist, and for an unknown method.
SearchedTable searched_table(const FunctionCall& call, const SearchInputs& inputs);

}  // namespace foresee
