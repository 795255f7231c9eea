// A harbour scene with simple numbers, for the tests of the table-valued functions.
//
// Ada (1, radius 3) and Bob (2, radius 1) sail towards each other on y = 0. They touch from 3 to 7, and their
// centres meet at 5. Cid (3) is at y = 99. Crate 11 is at (5, 4) with half extents 0.5, and crate 12 is far
// away. Ada's side at y = 3 touches crate 11 from 4.5 to 5.5, for `within` >= 0.5.
#pragma once

#include "sqlite/database.h"

namespace foresee::testing {

inline void build_ships(Database& db, const std::string& name = "ships") {
  db.exec(
      "CREATE VIRTUAL TABLE " + name +
      " USING moving_objects(id, t, x, y, vx, vy, r, +name TEXT);"
      "INSERT INTO " +
      name +
      " VALUES (1, 0, 0, 0, 1, 0, 3, 'Ada'), (2, 0, 10, 0, -1, 0, 1, 'Bob'), (3, 0, 0, 99, 0, 0, 1, 'Cid')");
}

inline void build_crates(Database& db) {
  db.exec(
      "CREATE VIRTUAL TABLE crates USING moving_objects(id, x, y, hx, hy);"
      "INSERT INTO crates VALUES (11, 5, 4, 0.5, 0.5), (12, 500, 500, 1, 1)");
}

/// A database with ships.
struct Harbour : ::testing::Test {
  Harbour() { build_ships(db); }
  Database db;
};

}  // namespace foresee::testing
