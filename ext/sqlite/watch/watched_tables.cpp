#include "sqlite/watch/watched_tables.h"

#include <algorithm>

#include "base/float_environment.h"
#include "query/watch/pair_contacts.h"
#include "sqlite/names/open_table.h"

namespace foresee {
namespace {

constexpr std::size_t pairs_at_once = 8192;

Connection::OpenTable find_table(Connection& connection, const std::string& schema, const std::string& name) {
  const TableName table{name, schema};
  if (const auto number = connection.lookups().kept_number(table))
    if (const Connection::OpenTable* open = connection.find(*number)) return *open;
  // A damaged file may name a watch, or a view of one: a query of it would recurse into this function.
  require_moving_objects(connection.db(), name, schema);
  return open_table(connection, table);
}

std::shared_ptr<Scene> empty_scene(const Connection::OpenTable& table) {
  auto scene = std::make_shared<Scene>();
  scene->name = table.table, scene->layout = table.store->declaration().layout;
  return scene;
}

std::optional<std::uint32_t> row_of(const Scene& scene, std::int64_t id) {
  const auto found = std::lower_bound(scene.ids.begin(), scene.ids.end(), id);
  if (found == scene.ids.end() || *found != id) return std::nullopt;
  return static_cast<std::uint32_t>(found - scene.ids.begin());
}

std::vector<std::int64_t> sorted_ids(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void append_contacts(Connection& connection, const WatchedTables& tables, JoinQuestion question,
                     std::span<const PairIds> pairs, std::vector<JoinRow>& rows) {
  std::vector<std::int64_t> a, b;
  const bool one_scene = !tables.b || tables.are_one();
  for (const PairIds& pair : pairs) a.push_back(pair.a), (one_scene ? a : b).push_back(pair.b);
  question.a = scene_of(connection, tables.a, sorted_ids(std::move(a)));
  if (tables.b)
    question.b = one_scene ? question.a : scene_of(connection, *tables.b, sorted_ids(std::move(b)));
  std::vector<Pair> numbers;
  for (const PairIds& pair : pairs) {
    const auto row_a = row_of(*question.a, pair.a);
    const auto row_b = row_of(question.b ? *question.b : *question.a, pair.b);
    if (row_a && row_b) numbers.push_back({*row_a, *row_b});
  }
  const std::vector<JoinRow> found = pair_contacts(question, numbers, connection.interrupt());
  rows.insert(rows.end(), found.begin(), found.end());
}

}  // namespace

WatchedTables watched_tables(Connection& connection, const std::string& schema,
                             const WatchDeclaration& declaration) {
  WatchedTables tables{find_table(connection, schema, declaration.tbl)};
  if (declaration.other) tables.b = find_table(connection, schema, *declaration.other);
  return tables;
}

JoinQuestion question_of(const WatchedTables& tables, const WatchDeclaration& declaration,
                         const Horizon& horizon) {
  JoinQuestion question;
  question.a = empty_scene(tables.a);
  if (tables.b) question.b = tables.are_one() ? question.a : empty_scene(*tables.b);
  question.now = horizon.now, question.h = horizon.h;
  question.within = declaration.within, question.within_z = declaration.within_z;
  return question;
}

JoinQuestion question_of_all(Connection& connection, const WatchedTables& tables,
                             const WatchDeclaration& declaration, const Horizon& horizon) {
  JoinQuestion question = question_of(tables, declaration, horizon);
  question.a = connection.load_scene(tables.a);
  if (tables.b) question.b = tables.are_one() ? question.a : connection.load_scene(*tables.b);
  question.space = connection.grid_space();
  question.helpers = connection.helper_threads();
  return question;
}

std::shared_ptr<Scene> scene_of(Connection& connection, const Connection::OpenTable& table,
                                std::span<const std::int64_t> ids) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  auto scene = empty_scene(table);
  const auto row_size = static_cast<std::size_t>(row_offsets(scene->layout).size);
  StatementReadState statement_state;
  for (const std::int64_t id : ids) {
    const std::span<const double> record = table.store->find(id, statement_state);
    if (record.empty()) continue;
    scene->ids.push_back(id);
    scene->rows.resize(scene->rows.size() + row_size);
    row_from_record(scene->layout, record.data(), scene->rows.data() + scene->rows.size() - row_size);
  }
  scene->take_forms(table.store->forms(), connection.interrupt());
  return scene;
}

std::vector<JoinRow> contacts_of(Connection& connection, const WatchedTables& tables,
                                 const JoinQuestion& question, std::span<const PairIds> pairs) {
  std::vector<JoinRow> rows;
  for (std::size_t begin = 0; begin < pairs.size(); begin += pairs_at_once)
    append_contacts(connection, tables, question,
                    pairs.subspan(begin, std::min(pairs_at_once, pairs.size() - begin)), rows);
  return rows;
}

}  // namespace foresee
