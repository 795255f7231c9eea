// Making, opening, transactions, renaming and dropping.
#include <atomic>

#include "storage/open_stores.h"
#include "storage/store.h"
#include "storage/store_own_statements.h"

namespace foresee {
namespace {

bool same_columns(const Declaration& a, const Declaration& b) {
  return a.horizon == b.horizon && describe_columns(a) == describe_columns(b);
}

}  // namespace

std::shared_ptr<ObjectStore> ObjectStore::create(sqlite3* db, const std::string& schema,
                                                 const std::string& table, const Declaration& declaration) {
  const QualifiedName name{schema, table};
  const NodeFormat format = create_shadow_tables(db, name, declaration);
  auto store = std::make_shared<Store>(db, name, declaration, format, true);
  remember_open_store(db, name, store);
  return store;
}

std::shared_ptr<ObjectStore> ObjectStore::open(sqlite3* db, const std::string& schema,
                                               const std::string& table, const Declaration& declaration) {
  const QualifiedName name{schema, table};
  const NodeFormat format = read_node_format(db, name, declaration);
  if (auto live = find_open_store(db, name);
      live && same_columns(live->declaration(), declaration) && live->format().node_size == format.node_size)
    return live;
  auto store = std::make_shared<Store>(db, name, declaration, format, false);
  remember_open_store(db, name, store);
  return store;
}

// SQLite makes a table inside a write transaction and does not call begin() for it.
Store::Store(sqlite3* db, QualifiedName name, Declaration declaration, const NodeFormat& format, bool is_new)
    : db_(db),
      name_(std::move(name)),
      declaration_(std::move(declaration)),
      format_(format),
      rows_(std::make_unique<ShadowRows>(db, name_, static_cast<int>(declaration_.auxiliaries.size()))),
      in_transaction_(is_new) {}

ShadowRows& Store::rows() {
  if (half_packed_)
    throw StoreError(SQLITE_ABORT, name_.table + ": writing the leaves anew failed half-way; roll back");
  return *rows_;
}

void Store::damaged(const std::string& what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": " + what);
}

void Store::begin() {
  if (in_transaction_) return;
  forget();
  in_transaction_ = true;
}

void Store::sync() {
  rows();
  flush();
}

void Store::commit() {
  forget();
  in_transaction_ = false;
}

void Store::rollback() {
  forget();
  in_transaction_ = false;
  half_packed_ = false;
  changed_ = false;
  changes_ = 0;  // with the stamp that is stored again: the contents of that commit
}

void Store::savepoint(int) {
  if (own_statements_ > 0) return;
  rows();
  flush();
}

void Store::release(int) {}

void Store::rollback_to(int) {
  if (own_statements_ > 0) return;
  forget();
  half_packed_ = false;
  changed_ = true;
}

// What the transaction knew; its changes too.
void Store::forget() noexcept {
  stamped_ = false;
  largest_known_ = false;
  forget_after_ = own_statements_ > 0;
  if (forget_after_) return;
  pending_.clear();
  newest_ = nullptr;
}

ContentVersion Store::version() {
  static std::atomic<std::uint64_t> last_change{0};
  if (changed_) changes_ = ++last_change;
  changed_ = false;
  const auto stamp = rows().stamp();
  if (!stamp) damaged("the stamp is missing");
  return {static_cast<std::uint64_t>(*stamp), changes_};
}

void Store::rename(const std::string& new_table) {
  flush();
  const OwnStatements own(*this);
  rename_shadow_tables(db_, name_, new_table, declaration_);
  name_.table = new_table;
  rows_ = std::make_unique<ShadowRows>(db_, name_, static_cast<int>(declaration_.auxiliaries.size()));
  remember_open_store(db_, name_, shared_from_this());
}

void Store::drop() {
  const OwnStatements own(*this);
  drop_shadow_tables(db_, name_, declaration_);
  pending_.clear();
  newest_ = nullptr;
}

}  // namespace foresee
