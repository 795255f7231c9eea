// Registry of the open stores of all connections, and of the memory budget of each connection.
//
// SQLite may connect a virtual table a second time during a transaction, while the first object still has
// unwritten changes. Both must use one store; the second finds it here.
#pragma once

#include <memory>

#include "storage/rows/shadow_schema.h"

namespace foresee {

class MemoryBudget;
class Store;

/// Null if no such store is open.
std::shared_ptr<Store> find_open_store(sqlite3* db, const QualifiedName& name);
/// Registers a store under a name, as long as it exists.
void remember_open_store(sqlite3* db, const QualifiedName& name, const std::shared_ptr<Store>& store);

/// The budget of all stores of a connection, as long as one of them exists.
std::shared_ptr<MemoryBudget> memory_budget_of(sqlite3* db);

}  // namespace foresee
