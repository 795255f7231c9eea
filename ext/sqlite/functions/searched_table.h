// What do predictive_window and predictive_nearest search, and what is `now`?
#pragma once

#include "query/search_target.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// The inputs that both functions have, by their places.
struct SearchInputs {
  int tbl, now, method, schema;
};

struct SearchedTable {
  SearchTarget objects;
  double now;  ///< as given, or the newest t stored
};

/// Throws Error where no such table is to be found, and for an unknown method.
SearchedTable searched_table(const FunctionCall& call, const SearchInputs& inputs);

}  // namespace foresee
