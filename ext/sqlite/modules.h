// Registration functions that sqlite3_foresee_init calls; the file that defines each is named beside it.
#pragma once

#include <memory>

#include "sqlite/connection.h"

namespace foresee {

// Each returns an SQLite result code.
int register_scalars(sqlite3* db);  // scalar_functions.cpp
int register_moving_objects(sqlite3* db,
                            const std::shared_ptr<Connection>& connection);  // moving_objects.cpp
int register_predictive_watch(sqlite3* db,
                              const std::shared_ptr<Connection>& connection);  // predictive_watch.cpp
int register_table_functions(sqlite3* db,
                             const std::shared_ptr<Connection>& connection);  // table_functions.cpp

}  // namespace foresee
