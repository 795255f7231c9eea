// Store: names of the watches of a table, in its `_meta`, so that every connection that can write it knows
// them.
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {

void Store::load_watch_names() {
  if (!watch_names_.get()) watch_names_.change() = shadow_rows().read_watches();
}

const std::vector<std::string>& Store::watch_names() {
  revalidate_cache();
  load_watch_names();
  return watch_names_->value();
}

// SQLite may not have called begin() for this transaction, and then calls neither commit() nor rollback(). So
// memory is left unchanged, and the cache is revalidated when the new stamp is read.
void Store::write_stamp_of_watches() {
  watch_names_.change().reset();
  if (version_.written_here()) return write_new_stamp();
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  shadow_rows().write_stamp(stamp);
}

void Store::add_watch(const std::string& name) {
  const OwnStatements own(*this);
  shadow_rows().write_watch(name);
  write_stamp_of_watches();
}

void Store::remove_watch(const std::string& name) {
  const OwnStatements own(*this);
  shadow_rows().erase_watch(name);
  write_stamp_of_watches();
}

std::optional<std::int64_t> Store::stamp_if_written() {
  if (has_unwritten()) return std::nullopt;
  return shadow_rows().read_stamp();
}

std::optional<std::int64_t> Store::stamp_before_changes() {
  if (!changes_.are_complete()) return std::nullopt;
  return version_.written_here() ? version_.before_first_change() : shadow_rows().read_stamp();
}

}  // namespace foresee
