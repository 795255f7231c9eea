#include "sqlite/functions/join_inputs.h"

#include <cmath>

#include "query/input_checks.h"
#include "query/join/tile_scenes.h"
#include "sqlite/names/open_table.h"
#include "sqlite/stored_table.h"
#include "storage/rows/value_text.h"

namespace foresee {
namespace {

constexpr ColumnList join_inputs{"h",      "tbl",    "within", "other",  "now",    "method",  "within_z",
                                 "schema", "own_x0", "own_x1", "own_y0", "own_y1", "contacts"};
constexpr int in_h = join_inputs["h"], in_tbl = join_inputs["tbl"], in_within = join_inputs["within"],
              in_other = join_inputs["other"], in_now = join_inputs["now"], in_method = join_inputs["method"],
              in_within_z = join_inputs["within_z"], in_schema = join_inputs["schema"],
              in_own_x0 = join_inputs["own_x0"], in_own_x1 = join_inputs["own_x1"],
              in_own_y0 = join_inputs["own_y0"], in_own_y1 = join_inputs["own_y1"],
              in_contacts = join_inputs["contacts"];

/// Both tables by open_table(), of one frame. Throws Error.
OpenTables open_tables(Connection& connection, const JoinInputs& inputs) {
  OpenTables tables{open_table(connection, inputs.tbl)};
  if (inputs.other) tables.b = open_table(connection, {inputs.other, inputs.tbl.schema});
  if (tables.b) require_one_frame(tables.a, *tables.b);
  require_upright(tables.a, inputs.within_z);
  return tables;
}

/// The tile that the inputs own_x0 to own_y1 bound; nothing without a bound. An infinity is not a bound.
std::optional<Tile> read_tile(const FunctionCall& call) {
  Tile tile;
  const char* first = nullptr;
  const auto bound = [&](int input, double& of_tile) {
    const auto number = call.number(input);
    if (!number || std::isinf(*number)) return;
    of_tile = *number;
    if (!first) first = call.name_of(input);
  };
  bound(in_own_x0, tile.x0), bound(in_own_x1, tile.x1);
  bound(in_own_y0, tile.y0), bound(in_own_y1, tile.y1);
  if (!first) return {};
  if (!call.number(in_now))
    throw Error(std::string(first) + " needs an explicit now, the same for all tiles; write now = ...");
  return tile;
}

}  // namespace

std::vector<const char*> join_input_names(bool with_contacts) {
  std::vector<const char*> names = join_inputs;
  if (!with_contacts) names.pop_back();
  return names;
}

bool all_contacts_input(const FunctionCall& call, int contacts) {
  const bool all = wants_all_contacts(call.text(contacts, "'first' or 'all'").value_or("first"));
  call.used(contacts, "first");
  return all;
}

JoinInputs read_join_inputs(const FunctionCall& call, bool with_contacts) {
  JoinInputs inputs;
  if (with_contacts) inputs.all_contacts = all_contacts_input(call, in_contacts);
  inputs.h = call.required_number(in_h);
  inputs.within = call.number(in_within).value_or(inputs.within);
  inputs.within_z = call.number(in_within_z);
  if (const auto method = call.text(in_method)) inputs.method = join_method(without_nul(*method));
  inputs.now = call.number(in_now);
  inputs.tbl.schema = call.text(in_schema);
  inputs.tbl.table = call.text(in_tbl);
  inputs.other = call.text(in_other);
  inputs.tile = read_tile(call);
  return inputs;
}

JoinQuestion join_question(const FunctionCall& call, const JoinInputs& inputs, const QueriedIds& ids,
                           const JoinWants& wants, InertObjects inert) {
  Connection& connection = call.connection();
  const OpenTables open = open_tables(connection, inputs);
  const JoinedTables tables = sources_of(connection, open);
  JoinQuestion question;
  question.now = inputs.now ? *inputs.now : tables.newest_t();
  question.h = inputs.h;
  question.within = inputs.within;
  question.within_z = inputs.within_z;
  question.method = inputs.method;
  question.tile = inputs.tile;
  question.all_contacts = inputs.all_contacts;
  question.wants = wants;
  call.used(in_tbl, open.a.table), call.used(in_schema, open.a.schema);
  call.used(in_now, question.now), call.used(in_within, question.within), call.used(in_method, "auto");
  const bool by_tree = question.method == JoinMethod::automatic || question.method == JoinMethod::tree;
  if (by_tree && (ids.a || ids.b)) {
    take_object_and_near(tables, ids, question, connection.interrupt());
  } else {
    take_scenes(tables, question, connection.interrupt(), inert);
    question.only_a = ids.a, question.only_b = ids.b;
    question.space = connection.grid_space();
  }
  return question;
}

}  // namespace foresee
