// Inputs of predictive_join by name, read into a JoinQuestion.
//
//   Join join(join_question(call), call.connection().interrupt());
//
// An input that SQL leaves out has the default of its field in JoinQuestion; `now` is then the newest t stored.
#pragma once

#include <vector>

#include "query/join/join_scenes.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// The inputs' SQL names in call order; `contacts` is the last one, of predictive_join alone.
std::vector<const char*> join_input_names(bool with_contacts = false);

/// The input `contacts` of this number: true for 'all'. Throws Error for any other text than 'first', the default.
bool all_contacts_input(const FunctionCall& call, int contacts);

/// The same `JoinQuestion` with the inputs of the call, and with current scenes. `outputs` has what the conditions
/// on outputs determine: only_a, only_b, wants, order and times. For a query about one id it holds that object and
/// the objects near it, found through the tree, unless another method was given. The call records the values used
/// for inputs that were left out. The method then reads back as 'auto', since one statement may use two (a = ? OR
/// t < ?). Throws Error if an input is missing or of the wrong kind, or if a table does not exist (open_table.h).
JoinQuestion join_question(const FunctionCall& call, JoinQuestion outputs = {},
                           InertObjects inert = InertObjects::left_out);

}  // namespace foresee
