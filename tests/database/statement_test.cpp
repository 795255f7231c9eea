#include "database/statement.h"

#include <gtest/gtest.h>

#include "database/sqlite_api.h"
#include "storage/database.h"

namespace foresee {
namespace {

TEST(Statement, FindsATableByItsQuotedNameWhateverIsInIt) {
  EXPECT_EQ(quoted_name("my ships"), "\"my ships\"");
  Database db;
  const std::string name = "a \"b\" '; --%w";
  db.run("CREATE TABLE " + quoted_name(name) + "(x)");
  db.run("INSERT INTO " + quoted_name(name) + " VALUES(7)");
  EXPECT_EQ(db.number("SELECT x FROM " + quoted_name(name)), 7);
}

TEST(Statement, ReadsVirtualTablesOnlyIfAllowed) {
  Database db;
  const std::string sql = "SELECT seq FROM pragma_database_list";
  Statement only_tables(db, sql);
  EXPECT_THROW(only_tables.prepare(), StoreError);
  Statement all(db, sql, Statement::Reads::virtual_tables_too);
  EXPECT_TRUE(Statement::Run(all).step());
}

TEST(Statement, KnowsWhetherItWasRecompiled) {
  Database db;
  Statement select(db, "SELECT 1 FROM main.sqlite_master WHERE 0");
  select.prepare();
  EXPECT_FALSE(Statement::Run(select).step());
  EXPECT_FALSE(select.was_recompiled());
  db.run("CREATE TABLE t(x)");
  Statement::Run(select).step();
  EXPECT_TRUE(select.was_recompiled());
}

}  // namespace
}  // namespace foresee
