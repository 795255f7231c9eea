#include "sqlite/functions/join_inputs.h"

#include <cmath>

#include "database/value_text.h"
#include "query/input_checks.h"
#include "sqlite/functions/columns.h"
#include "sqlite/names/open_table.h"
#include "sqlite/stored_table.h"

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
  bound(in_own_x0, tile.x0);
  bound(in_own_x1, tile.x1);
  bound(in_own_y0, tile.y0);
  bound(in_own_y1, tile.y1);
  if (!first) return {};
  if (!call.number(in_now))
    throw Error(std::string(first) + " needs an explicit now, the same for all tiles; write WHERE now = ...");
  return tile;
}

}  // namespace

std::uint32_t unread_join_inputs() {
  return 1u << in_other | 1u << in_within_z | 0xfu << in_own_x0;
}

std::vector<const char*> join_input_names(bool with_contacts) {
  std::vector<const char*> names = join_inputs;
  if (!with_contacts) names.pop_back();
  return names;
}

bool all_contacts_input(const FunctionCall& call, int contacts) {
  const bool all = wants_all_contacts(call.text(contacts, "'first' or 'all'").value_or("first"));
  call.reads_back_as(contacts, "first");
  return all;
}

JoinedTables read_join_inputs(const FunctionCall& call, JoinQuestion& question) {
  Connection& connection = call.connection();
  if (call.has(in_contacts)) question.all_contacts = all_contacts_input(call, in_contacts);
  question.h = call.required_number(in_h);
  question.within = call.number(in_within).value_or(0);
  question.within_z = call.number(in_within_z);
  if (const auto method = call.text(in_method)) question.method = join_method(without_nul(*method));
  const std::optional<double> now = call.number(in_now);
  const std::optional<std::string> schema = call.text(in_schema), table = call.text(in_tbl),
                                   other = call.text(in_other);
  question.tile = read_tile(call);

  OpenTables open{open_table(connection, {table, schema})};
  if (other) open.b = open_table(connection, {other, schema});
  if (open.b) require_one_frame(open.a, *open.b);
  require_upright(open.a, question.within_z);
  JoinedTables tables = sources_of(connection, open);
  question.now = now ? *now : tables.newest_t();
  call.reads_back_as(in_tbl, open.a.table);
  call.reads_back_as(in_schema, open.a.schema);
  call.reads_back_as(in_now, question.now);
  call.reads_back_as(in_within, question.within);
  call.reads_back_as(in_method, "auto");
  question.space = connection.grid_space();
  return tables;
}

}  // namespace foresee
