#include "storage/rows/shadow_rows.h"

#include "storage/rows/store_error.h"

namespace foresee::storage {
namespace {

// A statement of 16 rows costs half as much a row as one of a single row; more rows gain nothing.
constexpr std::size_t map_rows = 16, map_columns = 2;

std::string write_map_sql(std::size_t rows) {
  std::string sql = "INSERT OR REPLACE INTO {map} VALUES(?, ?)";
  for (std::size_t i = 1; i < rows; ++i) sql += ", (?, ?)";
  return sql;
}

std::string insert_auxiliaries_sql(int columns) {
  std::string sql = "INSERT OR REPLACE INTO {aux} VALUES(?1";
  for (int i = 0; i < columns; ++i) sql += format_sql(", ?%d", i + 2);
  return sql + ")";
}

// ?3 has a digit a column: 1 if it keeps its value, else the new one follows.
std::string update_auxiliaries_sql(int columns) {
  std::string sql = "UPDATE OR REPLACE {aux} SET id = ?2";
  for (int i = 0; i < columns; ++i)
    sql += format_sql(", a%d = CASE WHEN substr(?3, %d, 1) = '1' THEN a%d ELSE ?%d END", i, i + 1, i, i + 4);
  return sql + " WHERE id = ?1";
}

std::optional<std::int64_t> one_integer(Statement::Run& run) {
  if (!run.step() || !run.is_integer(0)) return std::nullopt;
  return run.integer(0);
}

}  // namespace

ShadowRows::ShadowRows(const ShadowTables& tables, const Declaration& declaration)
    : db_(tables.db()), table_(tables.name().table), meta_(tables) {
  const auto auxiliaries = static_cast<int>(declaration.auxiliaries.size());
  auto sql = [&](const std::string& text) { return tables.statement(text); };
  largest_node_ = sql("SELECT max(nodeno) FROM {node}");
  node_by_number_ = sql("SELECT data FROM {node} WHERE nodeno = ?");
  nodes_after_ = sql("SELECT nodeno, data FROM {node} WHERE nodeno > ? ORDER BY nodeno LIMIT 1");
  all_nodes_ = sql("SELECT nodeno, data FROM {node} ORDER BY nodeno");
  write_node_ = sql("INSERT OR REPLACE INTO {node} VALUES(?, ?)");
  erase_node_ = sql("DELETE FROM {node} WHERE nodeno = ?");
  node_numbers_ = sql("SELECT nodeno FROM {node} ORDER BY nodeno");
  leaf_of_ = sql("SELECT leaf FROM {map} WHERE id = ?");
  largest_id_ = sql("SELECT max(id) FROM {map}");
  count_ = sql("SELECT count(*) FROM {map}");
  all_ids_ = sql("SELECT id, leaf FROM {map} ORDER BY id");
  write_map_row_ = sql(write_map_sql(1));
  write_map_rows_ = sql(write_map_sql(map_rows));
  erase_map_row_ = sql("DELETE FROM {map} WHERE id = ?");
  erase_map_ = sql("DELETE FROM {map}");
  if (auxiliaries == 0) return;
  insert_auxiliaries_ = sql(insert_auxiliaries_sql(auxiliaries));
  update_auxiliaries_ = sql(update_auxiliaries_sql(auxiliaries));
  erase_auxiliaries_ = sql("DELETE FROM {aux} WHERE id = ?");
  auxiliary_ids_ = sql("SELECT id FROM {aux} ORDER BY id");
  erase_stray_ = sql("DELETE FROM {aux} WHERE id NOT IN (SELECT id FROM {map})");
  insert_missing_ = sql("INSERT OR IGNORE INTO {aux}(id) SELECT id FROM {map}");
  for (int i = 0; i < auxiliaries; ++i)
    auxiliary_.push_back(sql(format_sql("SELECT a%d FROM {aux} WHERE id = ?", i)));
}

std::size_t ShadowRows::variables() const {
  return static_cast<std::size_t>(sqlite3_limit(db_, SQLITE_LIMIT_VARIABLE_NUMBER, -1));
}

/// SQLite's own message would speak of SQL that nobody has written.
void ShadowRows::require_variables(std::size_t needed) const {
  if (needed > variables())
    throw StoreError(SQLITE_ERROR,
                     table_ + ": to write its auxiliary columns takes " + std::to_string(needed) +
                         " SQL variables, and this connection allows " + std::to_string(variables()) +
                         "; raise SQLITE_LIMIT_VARIABLE_NUMBER, or declare fewer columns");
}

std::int64_t ShadowRows::read_largest_node() {
  Statement::Run run(largest_node_);
  return one_integer(run).value_or(0);
}

void ShadowRows::write_node(std::int64_t number, std::span<const std::byte> blob) {
  Statement::Run run(write_node_);
  run.bind(1, number);
  run.bind(2, blob);
  run.step();
}

void ShadowRows::erase_node(std::int64_t number) {
  Statement::Run run(erase_node_);
  run.bind(1, number);
  run.step();
}

std::optional<std::int64_t> ShadowRows::find_leaf(std::int64_t id) {
  Statement::Run run(leaf_of_);
  run.bind(1, id);
  if (!run.step()) return std::nullopt;
  return run.integer(0);  // what is no integer becomes 0, which is no leaf
}

std::optional<std::int64_t> ShadowRows::read_largest_id() {
  Statement::Run run(largest_id_);
  return one_integer(run);
}

std::int64_t ShadowRows::count_ids() {
  Statement::Run run(count_);
  return one_integer(run).value_or(0);
}

bool ShadowRows::map_is_empty() {
  Statement::Run run(largest_id_);
  return !run.step() || run.is_null(0);
}

void ShadowRows::write_map(std::span<const IdHashMap::Entry> changes) {
  // Whoever reads hostile SQL may have set a limit as low as 10.
  const std::size_t together = variables() < map_rows * map_columns ? 1 : map_rows;
  std::vector<IdHashMap::Entry> waiting;
  waiting.reserve(map_rows);
  const auto write = [&](Statement& statement, std::span<const IdHashMap::Entry> rows) {
    Statement::Run run(statement);
    int place = 0;
    for (const IdHashMap::Entry& row : rows) {
      run.bind(++place, row.id);
      run.bind(++place, row.value);
    }
    run.step();
  };
  for (const IdHashMap::Entry& change : changes) {
    if (change.value == 0) {
      Statement::Run run(erase_map_row_);
      run.bind(1, change.id);
      run.step();
      continue;
    }
    waiting.push_back(change);
    if (waiting.size() < together) continue;
    write(together == 1 ? write_map_row_ : write_map_rows_, waiting);
    waiting.clear();
  }
  for (const IdHashMap::Entry& change : waiting) write(write_map_row_, {&change, 1});
}

void ShadowRows::erase_map() {
  Statement::Run(erase_map_).step();
}

void ShadowRows::insert_auxiliaries(std::int64_t id, std::span<sqlite3_value*> values) {
  require_variables(1 + values.size());
  Statement::Run run(insert_auxiliaries_);
  run.bind(1, id);
  for (std::size_t i = 0; i < values.size(); ++i) run.bind(static_cast<int>(i) + 2, values[i]);
  run.step();
}

void ShadowRows::update_auxiliaries(std::int64_t id, std::int64_t new_id, std::span<sqlite3_value*> values) {
  bool changes = id != new_id;
  for (sqlite3_value* value : values) changes |= !sqlite3_value_nochange(value);
  if (!changes) return;
  require_variables(3 + values.size());
  Statement::Run run(update_auxiliaries_);
  run.bind(1, id);
  run.bind(2, new_id);
  std::string keeps(values.size(), '0');
  for (std::size_t i = 0; i < values.size(); ++i)
    if (sqlite3_value_nochange(values[i]))
      keeps[i] = '1';
    else
      run.bind(static_cast<int>(i) + 4, values[i]);
  run.bind(3, keeps);
  run.step();
}

void ShadowRows::erase_auxiliaries(std::int64_t id) {
  Statement::Run run(erase_auxiliaries_);
  run.bind(1, id);
  run.step();
}

void ShadowRows::result_auxiliary(sqlite3_context* context, std::int64_t id, int column) {
  Statement::Run run(auxiliary_.at(static_cast<std::size_t>(column)));
  run.bind(1, id);
  if (run.step())
    sqlite3_result_value(context, run.value(0));
  else
    sqlite3_result_null(context);
}

void ShadowRows::match_auxiliaries_to_map() {
  Statement::Run(erase_stray_).step();
  Statement::Run(insert_missing_).step();
}

}  // namespace foresee::storage
