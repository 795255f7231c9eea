#include "storage/rows/shadow_rows.h"

#include "database/sqlite_api.h"

namespace foresee {
namespace {

std::string insert_auxiliaries_sql(int columns) {
  std::string sql = "INSERT OR REPLACE INTO {aux} VALUES(?1";
  for (int i = 0; i < columns; ++i) sql += format_sql(", ?%d", i + 2);
  return sql + ")";
}

// ?3 has a digit per column: 1 keeps the old value, 0 sets the new one.
std::string update_auxiliaries_sql(int columns) {
  std::string sql = "UPDATE OR REPLACE {aux} SET id = ?2";
  for (int i = 0; i < columns; ++i)
    sql += format_sql(", a%d = CASE WHEN substr(?3, %d, 1) = '1' THEN a%d ELSE ?%d END", i, i + 1, i, i + 4);
  return sql + " WHERE id = ?1";
}

}  // namespace

ShadowRows::ShadowRows(const ShadowTables& tables, const Declaration& declaration)
    : db_(tables.db()), table_(tables.name().table), meta_(tables), tree_(tables, meta_) {
  const auto auxiliaries = static_cast<int>(declaration.auxiliaries.size());
  auto sql = [&](const std::string& text) { return tables.statement(text); };
  watches_ = sql("SELECT substr(key, 7) FROM {meta} WHERE key >= 'watch:' AND key < 'watch;' ORDER BY key");
  erase_watch_ = sql("DELETE FROM {meta} WHERE key = 'watch:' || ?1");
  if (auxiliaries == 0) return;
  insert_auxiliaries_ = sql(insert_auxiliaries_sql(auxiliaries));
  update_auxiliaries_ = sql(update_auxiliaries_sql(auxiliaries));
  erase_auxiliaries_ = sql("DELETE FROM {aux} WHERE id = ?");
  auxiliary_ids_ = sql("SELECT id FROM {aux} ORDER BY id");
  insert_missing_ = sql("INSERT INTO {aux}(id) VALUES(?)");
  for (int i = 0; i < auxiliaries; ++i)
    auxiliary_.push_back(sql(format_sql("SELECT a%d FROM {aux} WHERE id = ?", i)));
}

std::size_t ShadowRows::variables() const {
  return static_cast<std::size_t>(sqlite3_limit(db_, SQLITE_LIMIT_VARIABLE_NUMBER, -1));
}

/// SQLite's own message would refer to SQL that the user has not written.
void ShadowRows::require_variables(std::size_t needed) const {
  if (needed > variables())
    throw StoreError(SQLITE_ERROR, table_ + ": its auxiliary columns need " + std::to_string(needed) +
                                       " SQL variables, but this connection allows " +
                                       std::to_string(variables()) +
                                       "; raise SQLITE_LIMIT_VARIABLE_NUMBER, or declare fewer columns");
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

std::vector<std::string> ShadowRows::read_watches() {
  std::vector<std::string> names;
  for (Statement::Run run(watches_); run.step();) names.push_back(run.text(0));
  return names;
}

void ShadowRows::erase_watch(const std::string& name) {
  Statement::Run run(erase_watch_);
  run.bind(1, name);
  run.step();
}

void ShadowRows::match_auxiliaries_to_map() {
  std::vector<std::int64_t> stored, strays, missing;
  read_auxiliary_ids([&](std::int64_t id) { stored.push_back(id); });
  compare_ascending(
      stored, std::identity(), [&](auto each) { tree_.map().read(each); },
      [&](std::int64_t id) { strays.push_back(id); },
      [&](std::int64_t id, std::int64_t) { missing.push_back(id); }, [](std::int64_t, std::int64_t) {});
  for (const std::int64_t id : strays) erase_auxiliaries(id);
  for (const std::int64_t id : missing) {
    Statement::Run run(insert_missing_);
    run.bind(1, id);
    run.step();
  }
}

}  // namespace foresee
