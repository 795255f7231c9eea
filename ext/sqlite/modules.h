// What sqlite3_foresee_init registers, one function a file.
#pragma once

#include <memory>

#include "sqlite/connection.h"

namespace foresee {

/// Each returns an SQLite result code. A module shares the connection's state and lets go of it when SQLite
/// destroys it.
int register_scalars(sqlite3* db);  // scalars.cpp
// int register_moving_objects(sqlite3* db, std::shared_ptr<Connection>);    moving_objects.cpp
// int register_table_functions(sqlite3* db, std::shared_ptr<Connection>);   table_functions.cpp

}  // namespace foresee
