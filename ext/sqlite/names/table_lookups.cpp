#include "sqlite/names/table_lookups.h"

#include <algorithm>

#include "storage/table/store.h"

namespace foresee {
namespace {

std::string quoted_schema(const std::optional<std::string>& schema) {
  if (!schema) return "";
  std::string text = "\"";
  for (char c : *schema) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\".";
}

}  // namespace

/// Takes the witness off the list: while it runs SQLite may disconnect tables, and finalize() be called.
std::optional<std::int64_t> TableLookups::kept_number(const AskedTable& name) {
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.name == name; });
  if (found == kept_.end()) return std::nullopt;
  Kept kept = std::move(*found);
  kept_.erase(found);
  try {
    kept.witness->step();
  } catch (const StoreError& error) {
    const int code = error.code & 0xff;
    if (code != SQLITE_ERROR && code != SQLITE_AUTH) throw;
    return std::nullopt;  // the schema is gone, or may be read no longer
  }
  kept.witness->rewind();
  if (kept.witness->was_compiled_anew()) return std::nullopt;
  const std::int64_t number = kept.number;
  kept_.push_back(std::move(kept));
  return number;
}

std::optional<std::int64_t> TableLookups::ask(const AskedTable& name) {
  const char* t = name.table->c_str();
  Select select(db_, "SELECT \"%w\" FROM %s\"%w\" WHERE \"%w\" MATCH 'foresee-handle'", t,
                quoted_schema(name.schema).c_str(), t, t);
  return select.step() ? select.integer(0) : std::nullopt;
}

std::optional<std::int64_t> TableLookups::number_of(const AskedTable& name) {
  if (const auto number = kept_number(name)) return number;
  return ask(name);
}

void TableLookups::keep(const AskedTable& name, std::int64_t number, const std::string& schema) {
  if (!kept_.empty() && kept_.back().name == name) return;
  try {
    auto witness =
        std::make_unique<Select>(db_, "SELECT 1 FROM \"%w\".sqlite_master WHERE 0", schema.c_str());
    if (kept_.size() == most_kept) kept_.erase(kept_.begin());
    kept_.push_back({name, number, std::move(witness)});
  } catch (const StoreError&) {
    // An authorizer may forbid to read the schema: then SQLite is asked each time.
  }
}

void TableLookups::forget(const AskedTable& name) noexcept {
  std::erase_if(kept_, [&](const Kept& kept) { return kept.name == name; });
}

void TableLookups::finalize() noexcept {
  kept_.clear();
}

}  // namespace foresee
