#include "storage/table/store.h"

#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "storage/table/integrity_check.h"

namespace foresee {
namespace {

// Process-wide, because SQLite 3.40 has no means to attach an object to a connection and find it again.
struct OpenStores {
  std::mutex mutex;
  std::map<std::tuple<sqlite3*, std::string, std::string>, std::weak_ptr<Store>> stores;
  std::map<sqlite3*, std::weak_ptr<MemoryBudget>> budgets;
};

OpenStores& open_stores() {
  static OpenStores all;
  return all;
}

bool same_columns(const Declaration& a, const Declaration& b) {
  return a.horizon == b.horizon && a.frame == b.frame && describe_columns(a) == describe_columns(b);
}

}  // namespace

std::shared_ptr<Store> find_open_store(sqlite3* db, const QualifiedName& name) {
  OpenStores& all = open_stores();
  const std::lock_guard lock(all.mutex);
  const auto found = all.stores.find({db, name.schema, name.table});
  return found == all.stores.end() ? nullptr : found->second.lock();
}

void remember_open_store(sqlite3* db, const QualifiedName& name, const std::shared_ptr<Store>& store) {
  OpenStores& all = open_stores();
  const std::lock_guard lock(all.mutex);
  std::erase_if(all.stores, [](const auto& entry) { return entry.second.expired(); });
  all.stores.insert_or_assign({db, name.schema, name.table}, store);
}

std::shared_ptr<MemoryBudget> memory_budget_of(sqlite3* db) {
  OpenStores& all = open_stores();
  const std::lock_guard lock(all.mutex);
  std::erase_if(all.budgets, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<MemoryBudget>& known = all.budgets[db];
  std::shared_ptr<MemoryBudget> budget = known.lock();
  if (!budget) known = budget = std::make_shared<MemoryBudget>();
  return budget;
}

std::shared_ptr<Store> Store::create(sqlite3* db, const std::string& schema, const std::string& table,
                                     const Declaration& declaration) {
  const QualifiedName name{schema, table};
  const NodeFormat format = create_shadow_tables(db, name, declaration);
  // A rollback to a savepoint has removed a table of this name, which SQLite does not report.
  if (const auto other = find_open_store(db, name); other && other->is_named(table))
    other->transaction_.close();
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, declaration), declaration);
  auto store =
      std::make_shared<Store>(db, name, declaration, format, std::move(rows), true, memory_budget_of(db));
  store->totals_.change().count.stored = 0;
  remember_open_store(db, name, store);
  return store;
}

std::shared_ptr<Store> Store::open(sqlite3* db, const std::string& schema, const std::string& table,
                                   const Declaration& declaration) {
  const QualifiedName name{schema, table};
  const ShadowTables tables = shadow_tables(db, name, declaration);
  auto rows = std::make_unique<ShadowRows>(tables, declaration);
  const NodeFormat format = read_node_format(tables, rows->meta(), declaration);
  if (auto live = find_open_store(db, name);
      live && live->is_named(name.table) && same_columns(live->declaration(), declaration) &&
      live->format().node_size == format.node_size && !live->transaction_.was_rolled_back())
    return live;
  auto store =
      std::make_shared<Store>(db, name, declaration, format, std::move(rows), false, memory_budget_of(db));
  store->totals_.change().count.stored = store->shadow_rows().read_objects();
  remember_open_store(db, name, store);
  return store;
}

// --- watches

const std::vector<std::string>& Store::watch_names() {
  revalidate_cache();
  load_watch_names();
  return watch_names_->value();
}

// SQLite may not have called begin() for this transaction, and then calls neither commit() nor rollback(). So
// memory is left unchanged, and the cache is revalidated when the new stamp is read.
void Store::write_stamp_of_watches() {
  watch_names_.change().reset();
  if (version().written_here()) return write_new_stamp();
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  shadow_rows().write_stamp(stamp);
}

void Store::add_watch(const std::string& name) {
  const OwnStatements own(transaction_);
  shadow_rows().write_watch(name);
  write_stamp_of_watches();
}

void Store::remove_watch(const std::string& name) {
  const OwnStatements own(transaction_);
  shadow_rows().erase_watch(name);
  write_stamp_of_watches();
}

std::optional<std::int64_t> Store::stamp_if_written() {
  if (has_unwritten()) return std::nullopt;
  return shadow_rows().read_stamp();
}

// --- commands

void Store::rebuild(Interrupt& interrupt) {
  note_unknown_changes();  // in a damaged table it may recover objects
  pack(interrupt);
  const OwnStatements own(transaction_);
  if (!has_auxiliaries()) return;
  flush();
  shadow_rows().match_auxiliaries_to_map();
}

void Store::optimize(Interrupt& interrupt) {
  const std::vector<std::string> faults = integrity_check(interrupt);
  if (!faults.empty()) throw StoreError(SQLITE_CORRUPT_VTAB, faults.front());
  pack(interrupt);
}

// Forms stay while a snapshot may still read them.
void Store::pack(Interrupt& interrupt) {
  start_change({});
  flush();
  TreeStore::Rebuild rebuild(tree(), interrupt);
  AtomicChange atomic_change(transaction_);
  rebuild.write();
  if (plans_) pack_plans(interrupt);
  if (forms_ && !tree_.nodes().has_snapshots()) forms_->keep_only(rebuild.forms());
  write_count(static_cast<std::int64_t>(rebuild.objects()));
  atomic_change.done();
}

void Store::pack_plans(Interrupt& interrupt) {
  std::vector<double> records;
  const auto ignore = [](std::int64_t, std::span<const double>, std::span<const Leg>) {};
  std::vector<StoredPlans::Head> heads = read_heads(ignore, records, interrupt);
  plans_->rebuild(heads, records, interrupt);
}

std::vector<std::string> Store::integrity_check(Interrupt& interrupt) {
  flush();
  forget_clean_nodes();
  std::vector<std::string> faults = tree_.reporting_damage([&] {
    return check_integrity(shadow_rows(), tree_.nodes(), format_, name_, has_auxiliaries(),
                           forms_ ? &forms_->rows() : nullptr, plans_.get(), interrupt);
  });
  origin_.change() = {};
  try {
    frame();
  } catch (const StoreError& error) {
    if (!error.is_damage()) throw;
    faults.push_back(without_name(name_, error.what()));
  }
  return faults;
}

// --- callbacks of the virtual table

void Store::sync() {
  if (is_gone()) return;
  transaction_.require_usable();
  flush(TreeStore::Reason::commit);
}

void Store::commit() {
  if (is_gone()) return;
  if (plans_ && version().written_here() && version().seen())
    plans_->note_commit(version().before_first_change(), *version().seen());
  transaction_.commit();
}

void Store::rename(const std::string& new_table) {
  flush();
  const OwnStatements own(transaction_);
  shadow_tables(transaction_.db(), name_, declaration_).rename(new_table);
  transaction_.rename(new_table);
}

void Store::use_name(const std::string& table) {
  if (name_.table == table) return;
  const QualifiedName name{name_.schema, table};
  connect(name);
  remember_open_store(transaction_.db(), name, std::static_pointer_cast<Store>(shared_from_this()));
  name_ = name;  // last: if anything has thrown, the next call repeats it all
}

void Store::drop() {
  transaction_.require_droppable();
  const OwnStatements own(transaction_);
  shadow_tables(transaction_.db(), name_, declaration_).drop();
  transaction_.close();
}

}  // namespace foresee
