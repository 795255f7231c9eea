#include "watches/compared_join.h"

namespace foresee::bench {

Statement* ComparedJoin::add(const std::string& sql) {
  return all_.emplace_back(std::make_unique<Statement>(db_, sql)).get();
}

ComparedJoin::ComparedJoin(Database& db, const std::string& join) : db_(db) {
  db.run(
      "CREATE TABLE pairs(a INTEGER, b INTEGER, t REAL, PRIMARY KEY(a, b)) WITHOUT ROWID;"
      "CREATE TABLE changes(seq INTEGER PRIMARY KEY, op TEXT, a INTEGER, b INTEGER, t REAL);"
      "CREATE TEMP TABLE joined(a INTEGER, b INTEGER, t REAL, dt REAL, PRIMARY KEY(a, b)) WITHOUT ROWID");
  clear_ = add("DELETE FROM joined");
  join_ = add("INSERT INTO joined SELECT a, b, t, dt FROM " + join);
  position_ = add("SELECT ifnull(max(seq), 0) FROM changes");
  log_gone_ =
      add("INSERT INTO changes(op, a, b) SELECT '-', a, b FROM pairs p "
          "WHERE NOT EXISTS (SELECT 1 FROM joined j WHERE j.a = p.a AND j.b = p.b)");
  log_others_ =
      add("INSERT INTO changes(op, a, b, t) SELECT iif(p.a IS NULL, '+', '~'), j.a, j.b, j.t "
          "FROM joined j LEFT JOIN pairs p ON p.a = j.a AND p.b = j.b "
          "WHERE p.a IS NULL OR (p.t <> j.t AND NOT (j.dt = 0 AND p.t < j.t))");
  erase_ = add("DELETE FROM pairs WHERE (a, b) IN (SELECT a, b FROM changes WHERE seq > ? AND op = '-')");
  put_ = add("INSERT OR REPLACE INTO pairs SELECT a, b, t FROM changes WHERE seq > ? AND op <> '-'");
  db.run("BEGIN");
  update();
  db.run("COMMIT");
}

void ComparedJoin::update() {
  clear_->step();
  join_->step();
  position_->step();
  const std::int64_t position = position_->integer(0);
  position_->step();
  log_gone_->step();
  log_others_->step();
  for (Statement* apply : {erase_, put_}) {
    apply->bind(1, position);
    apply->step();
  }
}

void require_same_pairs(Database& compared, Database& watched) {
  Statement now(watched, "SELECT now FROM predictive_watches");
  now.step();
  Statement kept(watched, "SELECT a, b, t FROM alerts ORDER BY a, b");
  Statement pairs(compared, "SELECT a, b, max(t, ?) FROM pairs ORDER BY a, b");
  pairs.bind(1, now.number(0));
  while (kept.step())
    if (!pairs.step() || pairs.integer(0) != kept.integer(0) || pairs.integer(1) != kept.integer(1) ||
        pairs.number(2) != kept.number(2))
      throw Error("the watch and the compared join hold other pairs");
  if (pairs.step()) throw Error("the compared join holds more pairs than the watch");
}

}  // namespace foresee::bench
