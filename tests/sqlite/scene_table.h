// Builds a moving_objects table from a seeded scene.
#pragma once

#include <string>

#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {

/// "t, x, y, vx, vy, r": the columns of a stored record, in its order.
inline std::string columns_of(const Layout& layout) {
  const Offsets at = record_offsets(layout);
  std::string columns;
  auto add = [&](const std::string& name) { columns += ", " + name; };
  auto add_axes = [&](const char* before) {
    for (int axis = 0; axis < layout.axes; ++axis) add(std::string(before) + "xyz"[axis]);
  };
  if (at.t != Offsets::absent) add("t");
  add_axes("");
  if (at.v != Offsets::absent) add_axes("v");
  if (at.a != Offsets::absent) add_axes("a");
  if (at.force != Offsets::absent) add_axes("f");
  if (at.mass != Offsets::absent) add("m");
  if (at.half != Offsets::absent) add_axes("h");
  if (at.r != Offsets::absent) add("r");
  if (at.hz != Offsets::absent) add("hz");
  if (at.growth != Offsets::absent) add("growth");
  if (at.growth_z != Offsets::absent) add("growth_z");
  if (at.until != Offsets::absent) add("until");
  if (at.category != Offsets::absent) add("category");
  if (at.mask != Offsets::absent) add("mask");
  return columns.substr(2);
}

/// Creates `table` with every object of the scene.
inline void build_table(Database& db, const std::string& table, const RandomScene& scene) {
  const int size = record_offsets(scene.layout).size;
  db.exec("CREATE VIRTUAL TABLE " + table + " USING moving_objects(id, " + columns_of(scene.layout) + ")");
  std::string places;
  for (int i = 0; i < size; ++i) places += ", ?";
  sqlite3_stmt* insert = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(db.handle(), ("INSERT INTO " + table + " VALUES (?" + places + ")").c_str(),
                               -1, &insert, nullptr),
            SQLITE_OK)
      << sqlite3_errmsg(db.handle());
  db.exec("BEGIN");
  for (std::size_t i = 0; i < scene.size(); ++i) {
    sqlite3_bind_int64(insert, 1, scene.ids[i]);
    for (int column = 0; column < size; ++column) {
      const double value =
          scene.records[i * static_cast<std::size_t>(size) + static_cast<std::size_t>(column)];
      if (std::isinf(value))
        sqlite3_bind_null(insert, column + 2);  // until: unbounded
      else
        sqlite3_bind_double(insert, column + 2, value);
    }
    ASSERT_EQ(sqlite3_step(insert), SQLITE_DONE) << sqlite3_errmsg(db.handle());
    sqlite3_reset(insert);
  }
  sqlite3_finalize(insert);
  db.exec("COMMIT");
}

}  // namespace foresee::testing
