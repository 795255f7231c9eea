#include "storage/table/open_stores.h"

#include <map>
#include <mutex>
#include <tuple>

#include "storage/table/store.h"

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

}  // namespace foresee
