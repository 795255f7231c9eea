// A database in memory with one store in it, and the calls that SQLite makes around a transaction.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "database/statement.h"
#include "storage/table/store.h"

namespace foresee {

inline Declaration ships() {
  return {.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true}};  // t x y vx vy r
}

inline Declaration named_ships() {
  Declaration declaration = ships();
  declaration.auxiliaries = {{"name", "TEXT"}, {"cargo", ""}};
  return declaration;
}

/// SQL values without a row.
class SqlValues {
 public:
  SqlValues(sqlite3* db, std::initializer_list<const char*> texts) {
    for (const char* text : texts) {
      sqlite3_stmt* statement = nullptr;
      sqlite3_prepare_v2(db, "SELECT ?", -1, &statement, nullptr);
      sqlite3_bind_text(statement, 1, text, -1, SQLITE_STATIC);
      sqlite3_step(statement);
      values_.push_back(sqlite3_value_dup(sqlite3_column_value(statement, 0)));
      sqlite3_finalize(statement);
    }
  }
  ~SqlValues() {
    for (sqlite3_value* value : values_) sqlite3_value_free(value);
  }
  operator std::span<sqlite3_value*>() { return values_; }

 private:
  std::vector<sqlite3_value*> values_;
};

class Database {
 public:
  explicit Database(const std::string& file = ":memory:") {
    EXPECT_EQ(sqlite3_open(file.c_str(), &db_), SQLITE_OK);
  }
  ~Database() { EXPECT_EQ(sqlite3_close(db_), SQLITE_OK) << "a statement is still open"; }
  Database(const Database&) = delete;

  operator sqlite3*() const { return db_; }
  void run(const std::string& sql) const { execute(db_, sql); }
  std::int64_t number(const std::string& sql) const {
    Statement statement(db_, sql);
    Statement::Run run(statement);
    return run.step() ? run.integer(0) : -1;
  }
  std::string text(const std::string& sql) const {
    Statement statement(db_, sql);
    Statement::Run run(statement);
    return run.step() ? run.text(0) : "(no row)";
  }

 private:
  sqlite3* db_ = nullptr;
};

/// Creates a table as SQLite does, in a transaction of its own.
inline std::shared_ptr<Store> make_store(Database& db, const Declaration& declaration = ships(),
                                         const std::string& table = "ships",
                                         const std::string& schema = "main") {
  db.run("BEGIN IMMEDIATE");
  auto store = Store::create(db, schema, table, declaration);
  store->sync();
  db.run("COMMIT");
  store->commit();
  return store;
}

inline void begin(Database& db, Store& store) {
  db.run("BEGIN IMMEDIATE");
  store.begin();
}

inline void commit(Database& db, Store& store) {
  store.sync();
  db.run("COMMIT");
  store.commit();
}

inline void roll_back(Database& db, Store& store) {
  db.run("ROLLBACK");
  store.rollback();
}

inline void open_savepoint(Database& db, Store& store, int level) {
  store.savepoint(level);
  db.run("SAVEPOINT s" + std::to_string(level));
}

inline void roll_back_to(Database& db, Store& store, int level) {
  db.run("ROLLBACK TO s" + std::to_string(level));
  store.rollback_to(level);
}

/// A record of ships() with coordinates that identify the object.
inline std::vector<double> ship(double mark) {
  return {100, mark, -mark, 1, 0.5, 2};
}

/// The stored map: each id and its leaf.
inline std::vector<IdHashMap::Entry> stored_map(Database& db, const Declaration& declaration = ships(),
                                                const std::string& table = "ships") {
  std::vector<IdHashMap::Entry> all;
  MapRows(shadow_tables(db, {"main", table}, declaration)).read([&](std::int64_t id, std::int64_t leaf) {
    all.push_back({id, leaf});
  });
  return all;
}

/// Stores each object in a row of its own in the map, as version 0.1 did.
inline void write_map_as_version_0_1(Database& db) {
  const std::vector<IdHashMap::Entry> all = stored_map(db);
  db.run("DELETE FROM ships_map");
  for (const auto& [id, leaf] : all)
    db.run("INSERT INTO ships_map VALUES(" + std::to_string(id) + ", " + std::to_string(leaf) + ")");
}

inline std::vector<std::string> faults(Store& store) {
  NeverInterrupt never;
  return store.integrity_check(never);
}

/// Every id and its first coordinate, as read_all() returns them.
inline std::vector<std::pair<std::int64_t, double>> contents(Store& store) {
  NeverInterrupt never;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  store.read_all(ids, rows, never);
  const Offsets at = row_offsets(store.declaration().layout);
  std::vector<std::pair<std::int64_t, double>> result;
  for (std::size_t i = 0; i < ids.size(); ++i)
    result.emplace_back(ids[i], rows[i * static_cast<std::size_t>(at.size) + static_cast<std::size_t>(at.x)]);
  std::sort(result.begin(), result.end());
  return result;
}

inline std::int64_t count_of(Store& store) {
  return static_cast<std::int64_t>(contents(store).size());
}

/// Expects a StoreError of this code whose message contains `words`.
template <class Call>
void expect_store_error(int code, const std::string& words, Call call) {
  try {
    call();
    ADD_FAILURE() << "no error, expected: " << words;
  } catch (const StoreError& error) {
    EXPECT_EQ(error.code, code) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

}  // namespace foresee
