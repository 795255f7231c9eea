// Inputs of predictive_join by name, and the JoinQuestion built from them.
//
//   const JoinInputs inputs{.h = 600, .tbl = {.table = "ships", .schema = {}}, .within = 926};
//   Join join(join_question(call, inputs), call.connection().interrupt());
//
// Each field holds the input of its name, or its default below if SQL leaves the input out. join_question()
// opens the tables, so it throws Error if one does not exist (open_table.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "query/join/pair_kinds.h"
#include "query/join/probe.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

struct JoinInputs {
  double h = 0;
  TableName tbl = {};  ///< with `schema`, which is also that of `other`
  double within = 0;
  std::optional<std::string> other = {};  ///< nothing: pairs within tbl, each once
  std::optional<double> now = {};         ///< nothing: the newest t stored
  JoinMethod method = {};                 ///< by default automatic
  std::optional<double> within_z = {};
  bool all_contacts = false;
  std::optional<Tile> tile = {};  ///< own_x0, own_x1, own_y0, own_y1; nothing: all pairs
};

/// The inputs' SQL names in call order; `contacts` is the last one, of predictive_join alone.
std::vector<const char*> join_input_names(bool with_contacts = false);

/// The input `contacts` of this number: true for 'all'. Throws Error for any other text than 'first', the default.
bool all_contacts_input(const FunctionCall& call, int contacts);

/// Throws Error if an input is missing or of the wrong kind.
JoinInputs read_join_inputs(const FunctionCall& call, bool with_contacts = false);

/// The JoinQuestion of these inputs, with current scenes, and with the newest t as `now` if that was left
/// out. `wants`: the outputs that are read. The caller adds order and times. For a query about one id it holds that
/// object and the objects near it, found through the tree, unless another method was given. The call records the values
/// used for inputs that were left out. The method then reads back as 'auto', since one statement may use two (a =
/// ? OR t < ?).
JoinQuestion join_question(const FunctionCall& call, const JoinInputs& inputs, const QueriedIds& ids = {},
                           const JoinWants& wants = {}, InertObjects inert = InertObjects::left_out);

}  // namespace foresee
