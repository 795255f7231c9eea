#include "sqlite/functions/join_inputs.h"

#include <algorithm>
#include <cmath>

#include "query/join/probe.h"
#include "query/join/tile_scenes.h"
#include "sqlite/names/open_table.h"
#include "storage/rows/value_text.h"

namespace foresee {
namespace {

/// The inputs in the order of join_input_names().
enum Input {
  in_h,
  in_tbl,
  in_within,
  in_other,
  in_now,
  in_method,
  in_within_z,
  in_schema,
  in_own_x0,
  in_own_x1,
  in_own_y0,
  in_own_y1
};

using OpenTable = Connection::OpenTable;

/// The tables tbl and other. If `other` is the same table, each pair occurs in both orders.
struct JoinedTables {
  OpenTable a;
  std::optional<OpenTable> b = {};  ///< nothing: pairs within a, each once

  bool are_one() const { return b && b->store == a.store; }
};

/// Both tables by open_table(), of one frame. Throws Error.
JoinedTables open_tables(Connection& connection, const JoinInputs& inputs) {
  JoinedTables tables{open_table(connection, inputs.tbl)};
  if (inputs.other) tables.b = open_table(connection, {inputs.other, inputs.tbl.schema});
  if (tables.b) require_one_frame(tables.a, *tables.b);
  return tables;
}

/// The newest t stored in either table. Reads one node of each.
double newest_t_of(const JoinedTables& tables) {
  const double newest = tables.a.store->read_newest_t();
  return tables.b ? std::max(newest, tables.b->store->read_newest_t()) : newest;
}

std::shared_ptr<Scene> empty_scene(const OpenTable& table) {
  auto scene = std::make_shared<Scene>();
  scene->name = table.table, scene->layout = table.store->declaration().layout;
  return scene;
}

/// Throws Error for a `JoinQuestion` that is invalid for any objects.
void require_valid_between(const JoinedTables& tables, JoinQuestion question) {
  question.a = empty_scene(tables.a);
  if (tables.b) question.b = empty_scene(*tables.b);
  require_valid(question);
}

// Shares of all objects: above them the whole scene costs less than the nodes of a tile, read one by one.
constexpr double max_share = 0.5, max_share_if_cached = 0.1;

/// A scene of at least the objects that the tile needs, read through the tree. Null if the tile covers most
/// of the table: the caller then loads the whole scene, which stays cached for the next query.
std::shared_ptr<const Scene> scene_by_tree(Connection& connection, const OpenTable& table,
                                           const JoinQuestion& question) {
  const auto tree = table.store->take_snapshot();
  const double share = share_in_tile(*tree, question, connection.interrupt());
  if (share > (connection.find_scene(table) ? max_share_if_cached : max_share)) return nullptr;
  return scene_of_tile(*tree, table.table, question, connection.interrupt());
}

/// Sets both sides to scenes of all current objects, with the tree's levels for the method `tree`. With a
/// tile, a scene may hold only the objects that the tile needs. The same table on both sides is one scene.
void take_scenes(Connection& connection, const JoinedTables& tables, JoinQuestion& question) {
  const bool with_levels = question.method == JoinMethod::tree;
  const auto scene = [&](const OpenTable& table) {
    std::shared_ptr<const Scene> in_tile;
    if (question.tile && !with_levels) in_tile = scene_by_tree(connection, table, question);
    return in_tile ? in_tile : connection.load_scene(table, with_levels);
  };
  if (question.tile) require_valid_between(tables, question);
  question.a = scene(tables.a);
  if (tables.b) question.b = tables.are_one() ? question.a : scene(*tables.b);
}

/// A scene of one object with its outline or mesh; empty if the id does not exist.
std::shared_ptr<const Scene> scene_of(const OpenTable& table, std::int64_t id, Interrupt& interrupt) {
  auto scene = Connection::load_object(table, id);
  scene->take_forms(table.store->forms(), interrupt);
  return scene;
}

/// Sets one side to the queried object and the other to the objects that may touch it.
void take_object_and_near(Connection& connection, const JoinedTables& tables, const QueriedIds& ids,
                          JoinQuestion& question) {
  const bool by_a = ids.a.has_value();
  const std::int64_t id = by_a ? *ids.a : *ids.b;
  const OpenTable& last = tables.b ? *tables.b : tables.a;
  const OpenTable &one = by_a ? tables.a : last, &others = by_a ? last : tables.a;
  std::shared_ptr<const Scene>&object = by_a ? question.a : question.b,
                        &near = by_a ? question.b : question.a;
  object = scene_of(one, id, connection.interrupt());
  near = empty_scene(others);
  require_valid(question);
  const auto keep = [&](std::int64_t other) {
    if (tables.are_one()) return other != id;
    return tables.b.has_value() || (by_a ? id < other : other < id);
  };
  near = objects_near(*object, *others.store->take_snapshot(), others.table, {question.now, question.h},
                      contact_of(question)->reach(), connection.interrupt(), keep);
  question.method = JoinMethod::scan;
  if (by_a) question.only_b = ids.b;
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

std::vector<const char*> join_input_names() {
  return {"h",        "tbl",    "within", "other",  "now",    "method",
          "within_z", "schema", "own_x0", "own_x1", "own_y0", "own_y1"};
}

JoinInputs read_join_inputs(const FunctionCall& call) {
  JoinInputs inputs;
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

JoinQuestion join_question(const FunctionCall& call, const JoinInputs& inputs, const QueriedIds& ids) {
  Connection& connection = call.connection();
  const JoinedTables tables = open_tables(connection, inputs);
  JoinQuestion question;
  question.now = inputs.now ? *inputs.now : newest_t_of(tables);
  question.h = inputs.h;
  question.within = inputs.within;
  question.within_z = inputs.within_z;
  question.method = inputs.method;
  question.tile = inputs.tile;
  call.used(in_tbl, tables.a.table), call.used(in_schema, tables.a.schema);
  call.used(in_now, question.now), call.used(in_within, question.within), call.used(in_method, "auto");
  const bool by_tree = question.method == JoinMethod::automatic || question.method == JoinMethod::tree;
  if (by_tree && (ids.a || ids.b)) {
    take_object_and_near(connection, tables, ids, question);
  } else {
    take_scenes(connection, tables, question);
    question.only_a = ids.a, question.only_b = ids.b;
    question.space = connection.grid_space();
  }
  return question;
}

}  // namespace foresee
