// Inputs of predictive_join by name, read into a JoinQuestion.
//
//   JoinQuestion question;
//   const JoinedTables tables = read_join_inputs(call, question);
//   load_scenes(tables, question, call.connection().interrupt());
//   Join join(std::move(question), call.connection().interrupt());
//
// An input that SQL leaves out has the default of its field in JoinQuestion; `now` is then the newest t stored.
#pragma once

#include <vector>

#include "query/join/join_scenes.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

/// The inputs' SQL names in call order; `contacts` is the last one, of predictive_join alone.
std::vector<const char*> join_input_names(bool with_contacts = false);

/// The bits of TableFunction::unread_if_left_out for these inputs.
std::uint32_t unread_join_inputs();

/// The input `contacts` of this number: true for 'all'. Throws Error for any other text than 'first', the default.
bool all_contacts_input(const FunctionCall& call, int contacts);

/// Sets the fields of `question` that inputs determine, and `space`; opens the tables, whose scenes are not loaded. The
/// call records the values used for inputs that were left out. The method then reads back as 'auto': load_scenes() may
/// choose one, and one statement may use two (a = ? OR t < ?). Throws Error if an input is missing or of the wrong
/// kind, or if a table does not exist (open_table.h).
JoinedTables read_join_inputs(const FunctionCall& call, JoinQuestion& question);

}  // namespace foresee
