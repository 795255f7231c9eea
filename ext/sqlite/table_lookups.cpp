#include "sqlite/table_lookups.h"

#include <algorithm>

namespace foresee {
namespace {

std::string quoted_schema(const std::optional<std::string>& schema) {
  if (!schema) return "";
  std::string text = "\"";
  for (char c : *schema) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\".";
}

}  // namespace

/// Takes it off the list: while it runs SQLite may disconnect tables, and finalize() be called.
TableLookups::Kept TableLookups::take(const AskedTable& name) {
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.name == name; });
  if (found != kept_.end()) {
    Kept kept = std::move(*found);
    kept_.erase(found);
    return kept;
  }
  const char* t = name.table->c_str();
  return {name,
          std::make_unique<Select>(db_, "SELECT \"%w\" FROM %s\"%w\" WHERE \"%w\" MATCH 'foresee-handle'", t,
                                   quoted_schema(name.schema).c_str(), t, t)};
}

std::optional<std::int64_t> TableLookups::number_of(const AskedTable& name) {
  Kept kept = take(name);
  const std::optional<std::int64_t> number = kept.select->step() ? kept.select->integer(0) : std::nullopt;
  kept.select->rewind();
  if (kept_.size() == most_kept) kept_.erase(kept_.begin());
  kept_.push_back(std::move(kept));
  return number;
}

void TableLookups::forget(const AskedTable& name) noexcept {
  std::erase_if(kept_, [&](const Kept& kept) { return kept.name == name; });
}

// Finalizing one disconnects its table.
void TableLookups::finalize() noexcept {
  const std::vector<Kept> all = std::move(kept_);
  kept_.clear();
}

}  // namespace foresee
