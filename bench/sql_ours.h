// Our table of a workload's objects in a database: foresee is registered, the table declared and loaded.
#pragma once

#include "sql.h"
#include "workloads.h"

namespace foresee::bench {

/// Registers the extension; no table yet.
void register_foresee(Database& db);

/// CREATE VIRTUAL TABLE ships with the columns that the workload has. Throws Error for one of two tables.
void create_ours(Database& db, const Workload& w);

/// Prepared single-row INSERTs in one transaction; ids count from 1.
void load_ours(Database& db, const Workload& w);

/// "t, x, y, vx, vy, …": the columns that rows of this layout, or of a workload, have, in their order.
/// Without `until`.
std::string columns_of(const Layout& layout);
std::string columns_of(const Workload& w);

/// "(?, ?, …)" for an id and those columns.
std::string places_for(const Workload& w);

}  // namespace foresee::bench
