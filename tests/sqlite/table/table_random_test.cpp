// Random statements, thousands of them, against a moving_objects table and an ordinary table with the same
// columns. The contents agree after every transaction, within many transactions, after reopening and on a
// second connection.
#include <memory>
#include <random>
#include <sstream>
#include <vector>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct Shape {
  const char* columns;  ///< of moving_objects, without the id; blanks around the commas
  int motion;           ///< the number of these columns that are numeric
  int auxiliaries;
};

/// Writes the same statement against both tables, `ships` and `model`.
class Twins {
 public:
  Twins(const Shape& shape, std::uint32_t seed) : shape_(shape), random_(seed) {
    db_->exec("PRAGMA synchronous = OFF");
    db_->exec(std::string("CREATE VIRTUAL TABLE ships USING moving_objects(id, ") + shape.columns + ")");
    std::string plain = "CREATE TABLE model(id INTEGER PRIMARY KEY";
    for (const std::string& name : names()) plain += ", " + name;
    db_->exec(plain + ")");
  }

  /// One statement, or one step of a transaction. Both tables must give the same result.
  void step() {
    switch (upto(30)) {
      case 0:
        return begin();
      case 1:
        return end();
      case 2:
      case 3:
        return savepoint();
      case 4:
        return rollback_to();
      case 5:
        return release();
      case 6:
        return both("DELETE FROM TABLE WHERE id " + range());
      case 7:
      case 8:
      case 9:
        return both("DELETE FROM TABLE WHERE id = " + id());
      case 10:
        return both("UPDATE TABLE SET " + assignment() + " WHERE id " + range());
      case 11:
      case 12:
        return both("UPDATE " + clause() + "TABLE SET id = " + id() + " WHERE id = " + id());
      case 13:
        return both("UPDATE TABLE SET id = -id WHERE id " + range() + " AND id > 0");
      case 14:
        return both("INSERT " + clause() + "INTO TABLE SELECT id + 1, " + columns() +
                    " FROM TABLE WHERE id " + range() + " ORDER BY id");
      case 15:
        return compare();
      case 16:
        return db_->exec(upto(2) ? "INSERT INTO ships(ships) VALUES('rebuild')"
                                 : "INSERT INTO ships(ships) VALUES('optimize')");
      default:
        if (upto(2)) return both("UPDATE TABLE SET " + assignment() + " WHERE id = " + id());
        return both("INSERT " + clause() + "INTO TABLE VALUES(" + (upto(3) ? id() : "NULL") + ", " +
                    values() + "), (" + id() + ", " + values() + ")");
    }
  }

  void compare() {
    const std::string order = " ORDER BY id";
    ASSERT_EQ(db_->rows("SELECT * FROM ships" + order), db_->rows("SELECT * FROM model" + order)) << history_;
    const std::string some_ids = " WHERE id " + range() + " ORDER BY id DESC";
    ASSERT_EQ(db_->rows("SELECT * FROM ships" + some_ids), db_->rows("SELECT * FROM model" + some_ids))
        << history_;
    const std::string some = id();
    ASSERT_EQ(db_->rows("SELECT * FROM ships WHERE id = " + some),
              db_->rows("SELECT * FROM model WHERE id = " + some));
  }

  void finish() {
    while (!savepoints_.empty()) release();
    if (sqlite3_get_autocommit(db_->handle()) == 0) db_->exec("COMMIT");
    compare();
    db_->exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }

  void reopen() {
    finish();
    Database other(file_.path());
    EXPECT_EQ(other.rows("SELECT * FROM ships ORDER BY id"), db_->rows("SELECT * FROM model ORDER BY id"));
    db_ = std::make_unique<Database>(file_.path());
    db_->exec("PRAGMA synchronous = OFF");
    compare();
  }

 private:
  std::uint32_t upto(std::uint32_t n) { return random_() % n; }
  std::string id() { return std::to_string(static_cast<int>(upto(400)) - 50); }
  std::string range() {
    const int from = static_cast<int>(upto(400)) - 50;
    return "BETWEEN " + std::to_string(from) + " AND " + std::to_string(from + static_cast<int>(upto(60)));
  }
  std::string clause() {
    constexpr const char* clauses[] = {
        "", "", "OR ABORT ", "OR FAIL ", "OR IGNORE ", "OR REPLACE ", "OR ROLLBACK "};
    return clauses[upto(7)];
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    std::istringstream words(shape_.columns);
    for (std::string word; static_cast<int>(result.size()) < shape_.motion && words >> word;)
      if (word != ",") result.push_back(word);
    for (int i = 0; i < shape_.auxiliaries; ++i)
      result.push_back(std::string("n") + static_cast<char>('0' + i));
    return result;
  }
  std::string columns() const {
    std::string list;
    for (const std::string& name : names()) list += (list.empty() ? "" : ", ") + name;
    return list;
  }

  /// A number that both tables store as the same value, always a REAL.
  std::string number() {
    constexpr const char* special[] = {"0.0", "-0.0", "1e300", "5e-324", "-1e-300", "0.1"};
    if (upto(8) == 0) return special[upto(6)];
    return std::to_string(static_cast<double>(random_()) / 1024.0);
  }
  std::string anything() {
    switch (upto(5)) {
      case 0:
        return "NULL";
      case 1:
        return "'text " + std::string(upto(60), 'x') + "'";
      case 2:
        return "x'00ff" + std::string(2 * upto(40), 'a') + "'";
      case 3:
        return std::to_string(random_());
      default:
        return number();
    }
  }
  std::string values() {
    std::string list;
    for (int i = 0; i < shape_.motion + shape_.auxiliaries; ++i)
      list += (i == 0 ? "" : ", ") + (i < shape_.motion ? number() : anything());
    return list;
  }
  std::string assignment() {
    const std::vector<std::string> all = names();
    const std::uint32_t column = upto(static_cast<std::uint32_t>(all.size()));
    const bool motion = static_cast<int>(column) < shape_.motion;
    return all[column] + " = " + (motion ? number() : anything());
  }

  void both(const std::string& sql) {
    history_ += sql + ";\n";
    if (history_.size() > 4000) history_.erase(0, 1000);
    const bool in_transaction = sqlite3_get_autocommit(db_->handle()) == 0;
    const bool guarded = !in_transaction || sql.find("OR ROLLBACK") != std::string::npos;
    if (!guarded) {
      EXPECT_EQ(run(sql, "ships"), run(sql, "model")) << history_;
      return;
    }
    // OR ROLLBACK rolls back the whole transaction, also the changes to the other table: end it first.
    if (in_transaction) finish_transaction();
    EXPECT_EQ(run(sql, "ships"), run(sql, "model")) << history_;
    savepoints_.clear();
  }

  std::string run(std::string sql, const std::string& table) {
    for (auto at = sql.find("TABLE"); at != std::string::npos; at = sql.find("TABLE"))
      sql.replace(at, 5, table);
    std::string error = db_->error_of(sql);
    if (const auto at = error.find(table); at != std::string::npos) error.replace(at, table.size(), "TABLE");
    return error;
  }

  void begin() {
    if (sqlite3_get_autocommit(db_->handle()) != 0) transaction("BEGIN");
  }
  void end() {
    if (sqlite3_get_autocommit(db_->handle()) != 0) return;
    transaction(upto(3) ? "COMMIT" : "ROLLBACK");
    savepoints_.clear();
    compare();
  }
  void finish_transaction() {
    transaction("COMMIT");
    savepoints_.clear();
  }
  void savepoint() {
    savepoints_.push_back("s" + std::to_string(savepoints_.size()));
    transaction("SAVEPOINT " + savepoints_.back());
  }
  void rollback_to() {
    if (savepoints_.empty()) return;
    const std::uint32_t kept = upto(static_cast<std::uint32_t>(savepoints_.size()));
    savepoints_.resize(kept + 1);
    transaction("ROLLBACK TO " + savepoints_.back());
    if (upto(2)) compare();
  }
  void release() {
    if (savepoints_.empty()) return;
    const std::uint32_t kept = upto(static_cast<std::uint32_t>(savepoints_.size()));
    transaction("RELEASE " + savepoints_[kept]);
    savepoints_.resize(kept);
  }
  void transaction(const std::string& sql) {
    history_ += sql + ";\n";
    db_->exec(sql);
  }

  Shape shape_;
  std::mt19937 random_;
  TemporaryFile file_;
  std::unique_ptr<Database> db_ = std::make_unique<Database>(file_.path());
  std::vector<std::string> savepoints_;
  std::string history_;
};

void run_random(const Shape& shape, std::uint32_t seed) {
  Twins twins(shape, seed);
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 700; ++i) {
      twins.step();
      if (::testing::Test::HasFailure()) return;
    }
    twins.reopen();
  }
}

TEST(TableRandom, PointsWithoutAuxiliaryColumns) {
  run_random({"x , y , vx , vy", 4, 0}, 1);
}

TEST(TableRandom, OneAxisWithAuxiliaryColumns) {
  run_random({"x , vx , +n0 , +n1", 2, 2}, 2);
}

TEST(TableRandom, WideRecords) {
  run_random({"t , x , y , z , vx , vy , vz , ax , ay , az , +n0", 10, 1}, 3);
}

}  // namespace
}  // namespace foresee::testing
