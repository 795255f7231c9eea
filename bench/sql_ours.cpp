#include "sql_ours.h"

#include "sqlite/foresee.h"

namespace foresee::bench {

std::string columns_of(const Layout& layout) {
  std::string columns = layout.has_t ? "t" : "";
  const auto add = [&](const char* prefix) {
    for (int axis = 0; axis < layout.axes; ++axis)
      columns += (columns.empty() ? "" : ", ") + std::string(prefix) + "xyz"[axis];
  };
  add("");
  add("v");
  if (layout.law == Law::accelerated) add("a");
  const Shape shape = layout.shape;
  if (shape == Shape::box) add("h");
  if (shape == Shape::ball || shape == Shape::cylinder) columns += ", r";
  if (shape == Shape::cylinder) columns += ", hz";
  return columns;
}

std::string columns_of(const Workload& w) {
  return columns_of(w.layout);
}

std::string places_for(const Workload& w) {
  std::string places = "(?";
  for (int i = 0; i < w.bodies().at.size; ++i) places += ", ?";
  return places + ")";
}

void register_foresee(Database& db) {
  db.require_ok(sqlite3_foresee_init(db.handle(), nullptr, nullptr));
}

void create_ours(Database& db, const Workload& w) {
  if (w.other) throw Error("'" + w.name + "' has two tables: joined without SQL only");
  register_foresee(db);
  db.run("CREATE VIRTUAL TABLE ships USING moving_objects(id, " + columns_of(w) + ")");
}

void load_ours(Database& db, const Workload& w) {
  Statement insert(db, "INSERT INTO ships VALUES" + places_for(w));
  db.run("BEGIN");
  for (std::size_t i = 0; i < w.count; ++i) {
    const double* row = w.bodies().row(i);
    insert.bind(1, static_cast<std::int64_t>(i + 1));
    for (int k = 0; k < w.bodies().at.size; ++k) insert.bind(2 + k, row[k]);
    insert.step();
  }
  db.run("COMMIT");
}

}  // namespace foresee::bench
