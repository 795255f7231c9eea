// Inputs of predictive_join by their names, and the JoinQuestion that they make.
//
//   const JoinInputs inputs{.h = 600, .tbl = {.table = "ships", .schema = {}}, .within = 926};
//   Join join(join_question(call, inputs), call.connection().interrupt());
//
// A field is what the input of its name means: where SQL leaves an input out, the field is as it is here.
// join_question() opens the tables, so it throws Error where there is no such table (open_table.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "query/join/question.h"
#include "sqlite/functions/function_call.h"

namespace foresee {

struct JoinInputs {
  double h = 0;
  QueriedTable tbl = {};  ///< with `schema`, where `other` is too
  double within = 0;
  std::optional<std::string> other = {};  ///< none: pairs within tbl, each once
  std::optional<double> now = {};         ///< none: the newest t stored
  JoinMethod method = {};                 ///< automatic
  std::optional<double> within_z = {};
  std::optional<Tile> tile = {};  ///< own_x0, own_x1, own_y0, own_y1; none: all pairs
};

/// As SQL names them, in call order.
std::vector<const char*> join_input_names();

/// Throws Error where an input is missing or of the wrong kind.
JoinInputs read_join_inputs(const FunctionCall& call);

/// The ids that the query wants in columns a and b.
struct QueriedIds {
  std::optional<std::int64_t> a = {}, b = {};
};

/// The JoinQuestion of these inputs, with the scenes as they are now and `now` where it was left out. The
/// caller adds order, times and outputs. A query about one id becomes one about that object and those near it,
/// looked up in the tree, unless another method was given. The call records the values used for inputs that
/// were left out. The method is 'auto' then, since one statement may use two methods (a = ? OR t < ?).
JoinQuestion join_question(const FunctionCall& call, const JoinInputs& inputs, const QueriedIds& ids = {});

}  // namespace foresee
