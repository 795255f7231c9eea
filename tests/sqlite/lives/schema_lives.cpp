#include "sqlite/lives/schema_lives.h"

#include <sstream>

namespace foresee::testing {
namespace {

/// The columns that a moving_objects table declares after the id, and its twin table too.
constexpr const char* column_lists[] = {"x", "x, y", "x, vx", "x, r, +name", "x, y, shape"};

/// The outline of a triangle, as SQL writes it.
std::string triangle(int size) {
  const std::string x = std::to_string(size + 1);
  return "'POLYGON((0 0, " + x + " 0, 0 " + x + ", 0 0))'";
}

/// The errors that random statements may cause; no other statement may fail, and no COMMIT.
bool may_fail_with(const std::string& error) {
  for (const char* expected :
       {"already exists", "already another table", "a position is needed", "cannot VACUUM", "table is locked",
        "with the same number of axes",
        "values were supplied"})  // SQLite compiles by the schema that the connection read last
    if (error.find(expected) != std::string::npos) return true;
  return false;
}

std::string without_plus(std::string columns) {
  std::erase(columns, '+');
  return columns;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

SchemaLife::SchemaLife(unsigned seed) : random_(seed) {
  for (Side& side : sides_) {
    side.driver = std::make_unique<KeepingDriver>(file_.path("life.db"), 40);
    side.twin = std::make_unique<Database>(file_.path("twin.db"));
    side.driver->exec("PRAGMA synchronous = OFF");
    side.twin->exec("PRAGMA synchronous = OFF");
  }
  if (below(2)) {
    sides_[0].driver->exec("PRAGMA journal_mode = wal");
    sides_[0].twin->exec("PRAGMA journal_mode = wal");
  }
}

std::string SchemaLife::history() const {
  std::string text;
  for (const std::string& line : history_) text += "\n  " + line;
  return text;
}

std::optional<std::string> SchemaLife::some_table() {
  const auto names = lines_of(twin("SELECT name FROM sqlite_master WHERE name < 'w' ORDER BY name"));
  if (names.empty()) return std::nullopt;
  return names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
}

std::optional<std::string> SchemaLife::some_watch() {
  const auto names = lines_of(twin("SELECT name FROM sqlite_master WHERE name >= 'w' ORDER BY name"));
  if (names.empty()) return std::nullopt;
  return names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
}

std::string SchemaLife::new_name(const char* letters) {
  return std::string(1, letters[below(3)]);
}

bool SchemaLife::run(const std::string& sql, const std::string& twin) {
  const std::string error = side().driver->error_of(sql);
  ++(error.empty() ? succeeded_ : failed_);
  history_.push_back(std::to_string(active_) + ": " + sql + (error.empty() ? "" : "   -- " + error));
  if (history_.size() > 60) history_.erase(history_.begin());
  if (!error.empty()) {
    EXPECT_TRUE(may_fail_with(error)) << history();
    // A failed COMMIT, or a failure that ended the transaction, ends it for the twin too.
    if (depth_ > 0 && sqlite3_get_autocommit(side().driver->handle()))
      side().twin->exec("ROLLBACK"), depth_ = 0;
    return false;
  }
  side().twin->exec(twin);
  return true;
}

void SchemaLife::change_rows() {
  const auto table = some_table();
  if (!table) return change_schema();
  const auto columns = lines_of(twin("SELECT name FROM pragma_table_info('" + *table + "')"));
  const auto values = [&] {
    std::string text;
    for (std::size_t i = 1; i < columns.size(); ++i)
      text += ", " + (columns[i] == "shape" ? triangle(below(4)) : std::to_string(below(12)) + ".0");
    return text;
  };
  const std::string id = std::to_string(below(9));
  switch (below(8)) {
    case 0:
    case 1: {
      const std::string sql = "DELETE FROM " + *table + " WHERE id = " + id;
      run(sql, sql);
      return;
    }
    case 2: {
      const std::string sql = "UPDATE " + *table + " SET x = x + 1 WHERE id < " + id;
      run(sql, sql);
      return;
    }
    case 3:  // fails
      run("INSERT INTO " + *table + "(id, x) VALUES(" + id + ", NULL)", "");
      return;
    case 4: {
      const std::string command = below(2) ? "rebuild" : "optimize";
      run("INSERT INTO " + *table + "(" + *table + ") VALUES('" + command + "')", "");
      return;
    }
    case 5: {
      const auto watch = some_watch();
      if (!watch) return;
      run("INSERT INTO " + *watch + "(" + *watch + ", now) VALUES('advance', " + std::to_string(below(5)) +
              ")",
          "");
      return;
    }
    default: {
      const std::string sql = "INSERT OR REPLACE INTO " + *table + " VALUES(" + id + values() + ")";
      run(sql, sql);
    }
  }
}

void SchemaLife::change_schema() {
  const auto table = some_table();
  const auto watch = some_watch();
  switch (below(9)) {
    case 0:
    case 1:
    case 2: {
      const std::string name = new_name("stu"), columns = column_lists[below(5)];
      run("CREATE VIRTUAL TABLE " + name + " USING moving_objects(id, " + columns + ")",
          "CREATE TABLE " + name + "(id INTEGER PRIMARY KEY, " + without_plus(columns) + ")");
      return;
    }
    case 3:
    case 4: {
      if (!table) return;
      const std::string name = new_name("wyz");
      const auto other = some_table();
      run("CREATE VIRTUAL TABLE " + name + " USING predictive_watch(" + *table + ", horizon = 4, within = 1" +
              (below(3) ? "" : ", clock = manual") + (below(3) ? "" : ", other = " + *other) + ")",
          "CREATE TABLE " + name + "(a)");
      return;
    }
    case 5: {
      const auto& dropped = below(2) ? table : watch;
      if (dropped) run("DROP TABLE " + *dropped, "DROP TABLE " + *dropped);
      return;
    }
    case 6: {
      const bool of_table = below(2) != 0;
      const auto& renamed = of_table ? table : watch;
      if (!renamed) return;
      const std::string sql = "ALTER TABLE " + *renamed + " RENAME TO " + new_name(of_table ? "stu" : "wyz");
      run(sql, sql);
      return;
    }
    case 7:
      run("VACUUM", "");
      return;
    default:  // of neither: SQLite reads the schema again
      run(below(2) ? "CREATE TABLE IF NOT EXISTS _q(x)" : "DROP TABLE IF EXISTS _q", "");
  }
}

void SchemaLife::change_transaction() {
  if (depth_ == 0) {
    const std::string sql = below(3) ? "BEGIN" : below(2) ? "BEGIN IMMEDIATE" : "SAVEPOINT p1";
    if (run(sql, sql)) depth_ = sql[0] == 'S' ? 2 : 1;
    return;
  }
  const std::string inner = "p" + std::to_string(depth_ - 1);
  switch (below(9)) {
    case 0:
    case 1:
    case 2: {
      const std::string sql = "SAVEPOINT p" + std::to_string(depth_);
      if (run(sql, sql)) ++depth_;
      return;
    }
    case 3:
    case 4:
    case 5: {
      if (depth_ < 2) return;
      const int level = 1 + below(depth_ - 1);
      const std::string sql = "ROLLBACK TO p" + std::to_string(level);
      if (run(sql, sql)) depth_ = level + 1;
      return;
    }
    case 6: {
      if (depth_ < 3) return;
      const std::string sql = "RELEASE " + inner;
      if (run(sql, sql)) --depth_;
      return;
    }
    case 7:
      if (run("ROLLBACK", "ROLLBACK")) depth_ = 0;
      return;
    default:
      if (run("COMMIT", "COMMIT")) depth_ = 0;
  }
}

void SchemaLife::reopen() {
  history_.push_back(std::to_string(active_) + ": opens again");
  side().driver = std::make_unique<KeepingDriver>(file_.path("life.db"), 40);
  side().driver->exec("PRAGMA synchronous = OFF");
}

void SchemaLife::step() {
  if (depth_ == 0 && below(4) == 0) active_ = 1 - active_;
  if (depth_ == 0 && below(60) == 0) return reopen();
  const int kind = below(10);
  if (kind < 5)
    change_rows();
  else if (kind < 7)
    change_schema();
  else
    change_transaction();
}

void SchemaLife::expect_equal() {
  Database& driver = side().driver->database();
  for (const std::string& name : lines_of(twin("SELECT name FROM sqlite_master ORDER BY name"))) {
    if (name < "w") {
      const std::string sql = "SELECT * FROM " + name + " ORDER BY id";
      ASSERT_EQ(driver.rows(sql), twin(sql)) << name << history();
      continue;
    }
    const std::string state =
        "SELECT 'predictive_join WHERE h = 4 AND within = 1 AND tbl = ' || quote(tbl) || "
        "ifnull(' AND other = ' || quote(other), '') || ' AND now = ' || now || ' ORDER BY a, b' "
        "FROM predictive_watches WHERE name = '" +
        name + "'";
    const std::string join = driver.rows(state);
    ASSERT_TRUE(join.starts_with("predictive_join")) << name << ": " << join << history();
    ASSERT_EQ(driver.rows("SELECT a, b, t, t_end FROM " + name + " ORDER BY a, b"),
              driver.rows("SELECT a, b, t, t_end FROM " + join))
        << name << history();
  }
  const std::string names = "SELECT name FROM sqlite_master WHERE sql LIKE 'CREATE VIRTUAL%' ORDER BY name";
  ASSERT_EQ(driver.rows(names), twin("SELECT name FROM sqlite_master ORDER BY name")) << history();
}

void SchemaLife::expect_sound() {
  for (int i = 0; i < 2; ++i) {
    active_ = 1 - active_;
    expect_equal();
    if (::testing::Test::HasFatalFailure()) return;
    Database& driver = side().driver->database();
    for (const std::string& name : lines_of(twin("SELECT name FROM sqlite_master ORDER BY name")))
      ASSERT_EQ(driver.error_of("INSERT INTO " + name + "(" + name + ") VALUES('integrity-check')"), "")
          << history();
    ASSERT_EQ(driver.rows("SELECT name, fault FROM predictive_watches WHERE fault IS NOT NULL"), "")
        << history();
  }
}

}  // namespace foresee::testing
