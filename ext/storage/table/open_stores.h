// Which stores are open on which connection, and what memory do they share?
//
// SQLite may connect a virtual table a second time in the middle of a transaction, while the first object
// still holds changes that are not written. Both must then work on one store; this is where the second finds
// it.
#pragma once

#include <memory>

#include "storage/rows/shadow_schema.h"

namespace foresee {

class MemoryBudget;
class Store;

/// Null if there is none.
std::shared_ptr<Store> find_open_store(sqlite3* db, const QualifiedName& name);
/// Remembers a store under a name, as long as it lives.
void remember_open_store(sqlite3* db, const QualifiedName& name, const std::shared_ptr<Store>& store);

/// One for all stores of a connection, as long as one of them lives.
std::shared_ptr<MemoryBudget> memory_budget_of(sqlite3* db);

}  // namespace foresee
