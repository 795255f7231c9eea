#include "sql_rival.h"

#include "sql_ours.h"

namespace foresee::bench {

Rival::Rival(Database& db, const Workload& workload, Tables tables) : db_(db), workload_(workload) {
  if (workload.layout.axes != 2) throw Error("'" + workload.name + "' has three axes: the rival's boxes two");
  const int numbers = workload.bodies().at.size;
  // Any two objects with their sizes, since contact treats balls of radius 0 as points.
  for (int i = 0; i < 2; ++i)
    pair_rows_.insert(pair_rows_.end(), workload.rows.begin(), workload.rows.begin() + numbers);
  const Bodies pair(workload.layout, pair_rows_.data(), 2);
  contact_ = make_contact(pair, pair, {.horizon = {0, workload.h}}, "base", "base");
  db.require_ok(sqlite3_create_function(db.handle(), "first_contact", 2 * numbers,
                                        SQLITE_UTF8 | SQLITE_DETERMINISTIC, this, first_contact, nullptr,
                                        nullptr));
  if (tables == stands_ready) return;
  NeverInterrupt never;
  boxes_ = swept_boxes<2>(workload.bodies(), {0, workload.h}, Vec<2>::zero(), never);
  db.run("CREATE TABLE base(id INTEGER PRIMARY KEY, " + columns_of(workload) + ")");
  db.run("CREATE VIRTUAL TABLE boxes USING rtree(id, x0, x1, y0, y1)");
}

void Rival::load() {
  Statement object(db_, "INSERT INTO base VALUES" + places_for(workload_));
  Statement box(db_, "INSERT INTO boxes VALUES(?, ?, ?, ?, ?)");
  db_.run("BEGIN");
  for (std::size_t i = 0; i < workload_.count; ++i) {
    const auto id = static_cast<std::int64_t>(i + 1);
    const double* row = workload_.bodies().row(i);
    object.bind(1, id);
    for (int k = 0; k < workload_.bodies().at.size; ++k) object.bind(2 + k, row[k]);
    object.step();
    box.bind(1, id);
    for (int axis = 0; axis < 2; ++axis) {
      box.bind(2 + 2 * axis, boxes_[i].lower[axis]);
      box.bind(3 + 2 * axis, boxes_[i].upper[axis]);
    }
    box.step();
  }
  db_.run("COMMIT");
}

void Rival::store_box(Statement& box, std::size_t row, const Box<2>& swept) {
  for (int axis = 0; axis < 2; ++axis) {
    box.bind(1 + 2 * axis, swept.lower[axis]);
    box.bind(2 + 2 * axis, swept.upper[axis]);
  }
  box.bind(5, static_cast<std::int64_t>(row + 1));
  box.step();
}

void Rival::move(Statement& object, Statement& box, std::size_t row, double dx, double dy) {
  const double* const position = workload_.bodies().row(row);
  const Vec<2> by(dx, dy);
  object.bind(1, position[0] + dx);
  object.bind(2, position[1] + dy);
  object.bind(3, static_cast<std::int64_t>(row + 1));
  object.step();
  store_box(box, row, {boxes_[row].lower + by, boxes_[row].upper + by});
}

// LIMIT -1 keeps SQLite from flattening the subquery, which would call the function twice for every hit.
std::string Rival::join_sql() const {
  const auto columns_of_table = [&](const std::string& table) {
    std::string columns = table + "." + columns_of(workload_);
    for (std::size_t at = 0; (at = columns.find(", ", at)) != std::string::npos; at += 2 + table.size())
      columns.insert(at + 2, table + ".");
    return columns;
  };
  return "SELECT a, b, t FROM (SELECT p.id AS a, q.id AS b, first_contact(" + columns_of_table("p") + ", " +
         columns_of_table("q") +
         ") AS t"
         "  FROM boxes i CROSS JOIN base p CROSS JOIN boxes j CROSS JOIN base q"
         "  WHERE j.x0 <= i.x1 AND j.x1 >= i.x0 AND j.y0 <= i.y1 AND j.y1 >= i.y0 AND i.id < j.id"
         "    AND p.id = i.id AND q.id = j.id LIMIT -1) WHERE t IS NOT NULL";
}

void Rival::first_contact(sqlite3_context* context, int count, sqlite3_value** values) {
  auto* rival = static_cast<Rival*>(sqlite3_user_data(context));
  for (int i = 0; i < count; ++i)
    rival->pair_rows_[static_cast<std::size_t>(i)] = sqlite3_value_double(values[i]);
  const Pair pair{0, 1};
  std::vector<Pair> hits;
  std::vector<ContactTimes> times;
  rival->contact_->first_contacts({&pair, 1}, TimesWanted::starts, hits, times);
  if (!times.empty()) sqlite3_result_double(context, times[0].t);
}

}  // namespace foresee::bench
