#include "watches/triggered_pairs.h"

#include "sql_ours.h"

namespace foresee::bench {
namespace {

/// "new.t, new.x, …"
std::string columns_of(const std::string& table, const Workload& w) {
  std::string columns = table + "." + columns_of(w);
  for (std::size_t at = 0; (at = columns.find(", ", at)) != std::string::npos; at += 2)
    columns.insert(at + 2, table + ".");
  return columns;
}

std::string trigger_sql(const Workload& w) {
  const std::string contact = "first_contact(" + columns_of("new", w) + ", " + columns_of("q", w) + ")";
  return "CREATE TRIGGER moved AFTER UPDATE ON base BEGIN "
         "DELETE FROM found;"
         "INSERT INTO found SELECT a, b, t FROM (SELECT min(q.id, new.id) AS a, max(q.id, new.id) AS b, " +
         contact +
         " AS t FROM boxes i CROSS JOIN boxes j CROSS JOIN base q WHERE i.id = new.id"
         "  AND j.x0 <= i.x1 AND j.x1 >= i.x0 AND j.y0 <= i.y1 AND j.y1 >= i.y0 AND j.id <> new.id"
         "  AND q.id = j.id LIMIT -1) WHERE t IS NOT NULL;"
         "INSERT INTO changes(op, a, b) SELECT '-', a, b FROM pairs p WHERE (a = new.id OR b = new.id)"
         "  AND NOT EXISTS (SELECT 1 FROM found f WHERE f.a = p.a AND f.b = p.b);"
         "INSERT INTO changes(op, a, b, t) SELECT iif(p.a IS NULL, '+', '~'), f.a, f.b, f.t"
         "  FROM found f LEFT JOIN pairs p ON p.a = f.a AND p.b = f.b WHERE p.a IS NULL OR p.t <> f.t;"
         "DELETE FROM pairs WHERE a = new.id OR b = new.id;"
         "INSERT INTO pairs SELECT a, b, t FROM found; END";
}

std::string update_sql(const Workload& w) {
  std::string columns = columns_of(w);
  for (std::size_t at = 0; (at = columns.find(',', at)) != std::string::npos; at += 5)
    columns.replace(at, 1, " = ?,");
  return "UPDATE base SET " + columns + " = ? WHERE id = ?";
}

}  // namespace

TriggeredPairs::TriggeredPairs(Database& db, const Workload& objects)
    : db_(db), columns_(objects.bodies().at.size), rival_(db, objects) {
  rival_.load();
  db.run(
      "CREATE TABLE pairs(a INTEGER, b INTEGER, t REAL, PRIMARY KEY(a, b)) WITHOUT ROWID;"
      "CREATE INDEX by_b ON pairs(b);"
      "CREATE TABLE found(a INTEGER, b INTEGER, t REAL, PRIMARY KEY(a, b)) WITHOUT ROWID;"
      "CREATE TABLE changes(seq INTEGER PRIMARY KEY, op TEXT, a INTEGER, b INTEGER, t REAL);"
      "INSERT INTO pairs " +
      rival_.join_sql() + ";" + trigger_sql(objects));
  box_ = std::make_unique<Statement>(db, Rival::move_box_sql);
  object_ = std::make_unique<Statement>(db, update_sql(objects));
}

void TriggeredPairs::update_all(const Writes& writes, std::size_t first, std::size_t count) {
  db_.run("BEGIN");
  for (std::size_t i = first; i < first + count; ++i) {
    for (int k = 0; k < 4; ++k) box_->bind(1 + k, writes.boxes[i * 4 + static_cast<std::size_t>(k)]);
    box_->bind(5, writes.ids[i]);
    box_->step();
    const auto columns = static_cast<std::size_t>(columns_);
    for (std::size_t k = 0; k < columns; ++k)
      object_->bind(1 + static_cast<int>(k), writes.rows[i * columns + k]);
    object_->bind(1 + columns_, writes.ids[i]);
    object_->step();
  }
  db_.run("COMMIT");
}

}  // namespace foresee::bench
