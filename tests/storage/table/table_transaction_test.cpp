// TableTransaction: after every callback that SQLite makes or leaves out, a table has the state that its rows have.
#include "storage/table/table_transaction.h"

#include <gtest/gtest.h>

#include <memory>

#include "storage/database.h"

namespace foresee {
namespace {

/// A table whose only contents are a number, and whose only row is the stamp.
class NumberTable final : public ChangingTable {
 public:
  NumberTable(sqlite3* db, bool is_new) : transaction(db, *this, "ships", is_new) {}

  /// A change of the number that writes a stamp first, if none of this transaction is stored.
  void set(int value, bool fails = false) {
    if (!transaction.version().written_here()) {
      row = (row ? *row : 0) + 1;
      transaction.version().wrote(*row);
    }
    TableTransaction::AtomicChange change(transaction);
    number.change() = value;
    if (fails) throw StoreError(SQLITE_FULL, "no space");
    change.done();
  }
  std::string refusal() {
    try {
      transaction.require_usable();
    } catch (const StoreError& error) {
      return error.what();
    }
    return "";
  }

  std::optional<std::int64_t> read_stamp() override {
    if (error != SQLITE_OK) throw StoreError(error, "the row cannot be read");
    return row;
  }
  void revalidate_at_begin() override { transaction.version().note_valid(row.value_or(0)); }
  bool has_unwritten_changes() const override { return has_unwritten; }
  void use_name(const std::string& table) override {
    if (error != SQLITE_OK) throw StoreError(error, "the rows cannot be opened");
    name = table;
  }
  void note_end() noexcept override { ++ends; }
  void forget_rows() override { is_forgotten = true; }

  std::optional<std::int64_t> row = 10;  ///< what SQLite restores
  int error = SQLITE_OK;                 ///< of each access to rows
  bool has_unwritten = false, is_forgotten = false;
  int ends = 0;
  std::string name = "ships";
  TableTransaction transaction;
  Journaled<int> number{transaction.journal(), 1};
};

class TableCallbacks : public ::testing::Test {
 protected:
  explicit TableCallbacks(bool is_new = false) : table(db, is_new) {}

  Database db;
  NumberTable table;
  TableTransaction& transaction = table.transaction;
};

class CallbacksOfNewTables : public TableCallbacks {
 protected:
  CallbacksOfNewTables() : TableCallbacks(true) {}
};

TEST_F(TableCallbacks, ARollbackToASavepointRestoresItsState) {
  transaction.begin();
  table.set(2);
  transaction.savepoint(0);
  table.set(3);
  transaction.savepoint(1);
  table.set(4);
  transaction.rollback_to(1);
  EXPECT_EQ(table.number.get(), 3);
  table.set(5);
  transaction.release(1);
  EXPECT_EQ(table.number.get(), 5);
  transaction.rollback_to(0);
  transaction.rollback_to(0);  // the savepoint stays
  EXPECT_EQ(table.number.get(), 2);
  transaction.rollback();
  EXPECT_EQ(table.number.get(), 1);
  EXPECT_FALSE(transaction.is_open());
  EXPECT_EQ(table.ends, 1);
}

TEST_F(TableCallbacks, ChangesThatFailLeaveNothing) {
  transaction.begin();
  table.set(2);
  const ContentVersion before = transaction.version().shown(*table.row);
  EXPECT_THROW(table.set(3, true), StoreError);
  EXPECT_EQ(table.number.get(), 2);
  EXPECT_EQ(transaction.version().shown(*table.row), before);
  EXPECT_EQ(table.refusal(), "");
  transaction.commit();
  EXPECT_EQ(table.number.get(), 2);
}

// SQLite makes no callback for a savepoint that was set before the table joined the transaction.
TEST_F(TableCallbacks, RollbacksToAnOlderSavepointAreFoundByTheStamp) {
  transaction.begin();
  table.set(2);  // stamp 11
  transaction.savepoint(3);
  transaction.release(3);
  transaction.rollback_to(1);
  EXPECT_EQ(table.number.get(), 2) << "the stamp of this transaction is still stored";
  table.row = 10;
  transaction.rollback_to(1);
  EXPECT_EQ(table.number.get(), 1);
  EXPECT_TRUE(transaction.is_open());
  table.set(7);
  transaction.commit();
  EXPECT_EQ(table.number.get(), 7);
}

TEST_F(TableCallbacks, AStampThatCannotBeReadIsReadBeforeTheNextAccess) {
  transaction.begin();
  table.set(2);
  table.error = SQLITE_IOERR;
  transaction.rollback_to(1);
  EXPECT_EQ(table.refusal(), "the row cannot be read");
  table.error = SQLITE_OK;
  table.row = 10;
  EXPECT_EQ(table.refusal(), "");
  EXPECT_EQ(table.number.get(), 1);
}

TEST_F(TableCallbacks, ATableThatCannotFollowIsTornUntilTheRollback) {
  transaction.begin();
  transaction.savepoint(0);
  table.set(2);
  table.error = SQLITE_CORRUPT;
  transaction.rollback_to(0);
  table.error = SQLITE_OK;
  EXPECT_EQ(table.refusal(), "ships: a write failed half-way; roll back");
  transaction.rollback();
  EXPECT_EQ(table.refusal(), "");
  EXPECT_EQ(table.number.get(), 1);
}

TEST_F(TableCallbacks, RollbacksDuringOwnStatementsWaitForTheirEnd) {
  transaction.begin();
  table.set(2);
  {
    const TableTransaction::OwnStatements own(transaction);
    transaction.savepoint(0);
    transaction.rollback();
    EXPECT_TRUE(transaction.rolled_back_within());
    EXPECT_EQ(table.number.get(), 2);
  }
  EXPECT_EQ(table.number.get(), 1);
  EXPECT_FALSE(transaction.is_open());
  EXPECT_FALSE(transaction.rolled_back_within());
}

TEST_F(TableCallbacks, NamesAreRolledBack) {
  transaction.begin();
  transaction.savepoint(0);
  table.set(2);
  transaction.rename("boats");
  EXPECT_EQ(table.name, "boats");
  transaction.rollback_to(0);
  EXPECT_EQ(table.name, "ships");
  transaction.rename("boats");
  transaction.rollback();
  EXPECT_EQ(table.name, "ships");
}

TEST_F(TableCallbacks, ANameThatCannotBeRolledBackIsSoAtTheNextAccess) {
  transaction.begin();
  transaction.rename("boats");
  {
    const TableTransaction::OwnStatements own(transaction);
    transaction.rollback();
    table.error = SQLITE_NOMEM;
  }
  EXPECT_EQ(table.name, "boats");
  EXPECT_EQ(table.refusal(), "the rows cannot be opened");
  table.error = SQLITE_OK;
  EXPECT_EQ(table.refusal(), "");
  EXPECT_EQ(table.name, "ships");
}

TEST_F(TableCallbacks, ADropRefusesChangesFromBeforeASavepoint) {
  transaction.begin();
  table.has_unwritten = true;
  transaction.savepoint(0);  // the newest one belongs to the DROP
  EXPECT_NO_THROW(transaction.require_droppable());
  transaction.savepoint(1);
  EXPECT_THROW(transaction.require_droppable(), StoreError);
  transaction.rollback_to(1);
  transaction.release(0);
  EXPECT_NO_THROW(transaction.require_droppable());
}

TEST_F(CallbacksOfNewTables, OpenATransactionAndCloseTheTableAtARollback) {
  EXPECT_TRUE(transaction.is_open());
  table.set(2);
  transaction.rollback();
  EXPECT_TRUE(transaction.is_gone());
  EXPECT_TRUE(table.is_forgotten);
  EXPECT_EQ(table.refusal(), "ships: the table is dropped; prepare the statement again");
  transaction.begin();
  EXPECT_FALSE(transaction.is_open());
}

TEST_F(CallbacksOfNewTables, CloseATableThatASavepointBeforeItTakesBack) {
  table.set(2);
  table.error = SQLITE_ERROR;  // no such table
  transaction.rollback_to(0);
  EXPECT_TRUE(transaction.is_gone());
}

TEST_F(CallbacksOfNewTables, KeepTheTableAfterTheCommit) {
  table.set(2);
  transaction.commit();
  transaction.begin();
  table.set(3);
  transaction.rollback();
  EXPECT_FALSE(transaction.is_gone());
  EXPECT_EQ(table.number.get(), 2);
}

}  // namespace
}  // namespace foresee
