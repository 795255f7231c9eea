#include "sqlite/names/table_lookups.h"

#include <algorithm>

#include "storage/table/store.h"

namespace foresee {
// Removes the witness from the list while it runs: SQLite may disconnect tables then, which calls finalize().
std::optional<std::int64_t> TableLookups::kept_number(const TableName& name) {
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.name == name; });
  if (found == kept_.end()) return std::nullopt;
  Kept kept = std::move(*found);
  kept_.erase(found);
  try {
    Statement::Run(kept.witness).step();
  } catch (const StoreError& error) {
    if (error.primary() != SQLITE_ERROR && error.primary() != SQLITE_AUTH) throw;
    return std::nullopt;  // the schema no longer exists, or an authorizer forbids reading it
  }
  if (kept.witness.was_recompiled()) return std::nullopt;
  const std::int64_t number = kept.number;
  kept_.push_back(std::move(kept));
  return number;
}

std::optional<std::int64_t> TableLookups::query_sqlite(const TableName& name) {
  const std::string table = quoted_name(*name.table);
  const std::string schema = name.schema ? quoted_name(*name.schema) + "." : "";
  Statement select(
      db_, "SELECT " + table + " FROM " + schema + table + " WHERE " + table + " MATCH 'foresee-handle'",
      Statement::Reads::virtual_tables_too);
  Statement::Run run(select);
  if (!run.step() || !run.is_integer(0)) return std::nullopt;
  return run.integer(0);
}

std::optional<std::int64_t> TableLookups::number_of(const TableName& name) {
  if (const auto number = kept_number(name)) return number;
  return query_sqlite(name);
}

void TableLookups::keep(const TableName& name, std::int64_t number, const std::string& schema) {
  if (!kept_.empty() && kept_.back().name == name) return;
  try {
    Statement witness(db_, "SELECT 1 FROM " + quoted_name(schema) + ".sqlite_master WHERE 0");
    witness.prepare();
    if (kept_.size() == max_kept) kept_.erase(kept_.begin());
    kept_.push_back({name, number, std::move(witness)});
  } catch (const StoreError& error) {
    // An authorizer may forbid reading the schema: then SQLite resolves the name each time.
    if (error.primary() != SQLITE_ERROR && error.primary() != SQLITE_AUTH) throw;
  }
}

void TableLookups::forget(const TableName& name) noexcept {
  std::erase_if(kept_, [&](const Kept& kept) { return kept.name == name; });
}

void TableLookups::finalize() noexcept {
  kept_.clear();
}

}  // namespace foresee
