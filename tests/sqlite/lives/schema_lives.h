// Random sequences of schema changes to tables and watches on two connections, applied to twin tables of
// plain SQLite as well.
//
//   SchemaLife life(seed);
//   life.step();                  // one statement on one of the connections, and on its twin if it succeeded
//   life.expect_equal();          // tables equal their twins, watches equal predictive_join
//
// Every statement stays prepared after it has run. Tables and watches are created, dropped, renamed and
// vacuumed inside transactions and savepoints, most of which are rolled back.
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>

#include "sqlite/lives/old_statements.h"

namespace foresee::testing {

class SchemaLife {
 public:
  explicit SchemaLife(unsigned seed);

  void step();
  /// Compares on the connection that has run the last statement.
  void expect_equal();
  /// Compares on both connections, between transactions, with integrity checks of the stored bytes.
  void expect_sound();

  /// The last statements, for the message of a failure.
  std::string history() const;
  bool in_transaction() const { return depth_ > 0; }
  int succeeded() const { return succeeded_; }
  int failed() const { return failed_; }

 private:
  struct Side {
    std::unique_ptr<KeepingDriver> driver;
    std::unique_ptr<Database> twin;
  };

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  Side& side() { return sides_[active_]; }
  std::string twin(const std::string& sql) { return side().twin->rows(sql); }
  /// A table that exists, or nothing.
  std::optional<std::string> some_table();
  std::optional<std::string> some_watch();
  std::string new_name(const char* letters);

  /// Runs `sql`, and `twin` beside it where it succeeds.
  bool run(const std::string& sql, const std::string& twin);
  void change_rows();
  void change_schema();
  void change_transaction();
  void reopen();

  TemporaryFile file_;
  std::mt19937 random_;
  Side sides_[2];
  int active_ = 0;
  int depth_ = 0;                   ///< 0: no transaction; 1: BEGIN; each savepoint one more
  int succeeded_ = 0, failed_ = 0;  ///< statements
  std::vector<std::string> history_;
};

}  // namespace foresee::testing
