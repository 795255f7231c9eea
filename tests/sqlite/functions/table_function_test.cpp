// The common implementation of all table-valued functions, tested with a function that only counts.
#include "sqlite/functions/table_function.h"

#include "sqlite/callback.h"
#include "sqlite/database.h"
#include "sqlite/functions/columns.h"

namespace foresee {
namespace {

using testing::Database;

/// countdown(from, step, label): n = from, from - step, … 0; half = n / 2; label || n.
class Countdown final : public FunctionRows {
 public:
  Countdown(double from, double step, std::string label)
      : n_(from + step), step_(step), label_(std::move(label)) {}

  bool next() override {
    n_ -= step_;
    if (label_ == "fall" && n_ < 2) throw Error("fell at " + std::to_string(static_cast<int>(n_)));
    return n_ >= 0;
  }
  void output(sqlite3_context* context, int output) const override {
    if (output == 0) sqlite3_result_int64(context, static_cast<std::int64_t>(n_));
    if (output == 1) sqlite3_result_double(context, n_ / 2);
    if (output == 2)
      sqlite3_result_text(context, (label_ + std::to_string(static_cast<int>(n_))).c_str(), -1,
                          SQLITE_TRANSIENT);
  }

 private:
  double n_, step_;
  std::string label_;
};

struct Seen {
  int calls = 0;
  bool reads_half = false, above_zero = false;
  std::optional<std::int64_t> only_n;
} seen;

const TableFunction countdown = {.name = "countdown",
                                 .outputs = {"n INTEGER", "half REAL", "labelled TEXT"},
                                 .inputs = {"start", "step", "label"},
                                 .key = "n",
                                 .hinted = 0b11,
                                 .estimate = estimate_positions,
                                 .start = [](const FunctionCall& call) -> std::unique_ptr<FunctionRows> {
                                   ++seen.calls;
                                   seen.reads_half = call.reads(1);
                                   seen.only_n = call.only(0);
                                   seen.above_zero = call.bounds(1).min > 0;
                                   return std::make_unique<Countdown>(call.required_number(0),
                                                                      call.number(1).value_or(1),
                                                                      call.text(2).value_or("#"));
                                 },
                                 .probed = 0b1};

struct TableFunctionTest : ::testing::Test {
  TableFunctionTest() {
    register_table_function(db.handle(), countdown, std::make_shared<Connection>(db.handle()));
    seen = {};
  }
  Database db;
};

TEST_F(TableFunctionTest, TakesInputsByPlaceAndByNameInAnyOrder) {
  EXPECT_EQ(db.rows("SELECT * FROM countdown(2)"), "2|1.0|#2\n1|0.5|#1\n0|0.0|#0");
  EXPECT_EQ(db.rows("SELECT labelled FROM countdown(4, 2, 'x')"), "x4\nx2\nx0");
  EXPECT_EQ(db.rows("SELECT labelled FROM countdown WHERE label = 'x' AND step = 2 AND start = 4"),
            "x4\nx2\nx0");
  EXPECT_EQ(db.rows("SELECT labelled FROM countdown(4) WHERE 'x' = label AND step = 2"), "x4\nx2\nx0");
}

TEST_F(TableFunctionTest, CountsANullInputAsLeftOut) {
  EXPECT_EQ(db.rows("SELECT labelled FROM countdown(1, NULL, NULL)"), "#1\n#0");
  EXPECT_EQ(db.rows("SELECT labelled FROM countdown WHERE start = 1 AND label = NULL"), "#1\n#0");
}

TEST_F(TableFunctionTest, ReturnsItsInputsAsHiddenColumns) {
  EXPECT_EQ(db.rows("SELECT start, step, label FROM countdown('1', NULL, 'x') LIMIT 1"), "1|NULL|x");
  EXPECT_EQ(db.rows("SELECT n FROM countdown(1) WHERE start = 2"), "") << "both must hold";
}

TEST_F(TableFunctionTest, SaysWhatIsMissingOrWrong) {
  EXPECT_EQ(db.error_of("SELECT * FROM countdown"),
            "countdown: start is missing or NULL: write countdown(start, step, label)");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(NULL)"),
            "countdown: start is missing or NULL: write countdown(start, step, label)");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown('soon')"),
            "countdown: start must be a number, not 'soon': write countdown(start, step, label)");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(x'00')"),
            "countdown: start must be a number, not a blob of 1 bytes");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(9007199254740993)"),
            "countdown: start must be a number that a double holds exactly, not 9007199254740993");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(1, 1, 2)"),
            "countdown: label must be a name in quotes, or NULL to leave it out, not 2: write "
            "countdown(start, step, label)");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(1, 1, 'x', 4)"),
            "countdown: too many inputs: write at most countdown(start, step, label)");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(4, 1, 'fall')"), "countdown: fell at 1");
}

TEST_F(TableFunctionTest, TakesNumbersFromText) {
  EXPECT_EQ(db.rows("SELECT n FROM countdown('1')"), "1\n0");
}

TEST_F(TableFunctionTest, PassesConstraintsAndColumnsToTheFunction) {
  db.exec("SELECT n FROM countdown(3)");
  EXPECT_FALSE(seen.reads_half);
  EXPECT_FALSE(seen.only_n);
  EXPECT_FALSE(seen.above_zero);
  EXPECT_EQ(db.rows("SELECT half FROM countdown(3) WHERE n = '2'"), "1.0");
  EXPECT_TRUE(seen.reads_half);
  EXPECT_EQ(seen.only_n, 2);
  db.exec("SELECT n FROM countdown(3) WHERE n = 2.0 AND half > 0");
  EXPECT_EQ(seen.only_n, 2);
  EXPECT_TRUE(seen.above_zero);
  db.exec("SELECT n FROM countdown(3) WHERE n = 2.5 AND half > -1");
  EXPECT_FALSE(seen.only_n);
  EXPECT_FALSE(seen.above_zero);
  db.exec("SELECT n FROM countdown(3) WHERE n = 1e300 AND half >= 0");
  EXPECT_FALSE(seen.only_n);
  EXPECT_FALSE(seen.above_zero);
}

TEST_F(TableFunctionTest, IsNotCalledWhereNothingCanMatch) {
  EXPECT_EQ(db.rows("SELECT n FROM countdown(3) WHERE n = NULL"), "");
  EXPECT_EQ(seen.calls, 0);
}

TEST_F(TableFunctionTest, LosesNoRowOfAnOr) {
  EXPECT_EQ(db.rows("SELECT n FROM countdown(5) WHERE n = 4 OR half = 1 OR half = 2"), "4\n2");
  EXPECT_EQ(
      db.rows(
          "SELECT n, label FROM countdown WHERE (start = 1 AND label = 'x') OR (start = 2 AND label = 'y')"),
      "1|x\n0|x\n2|y\n1|y\n0|y")
      << "equal keys of different calls are different rows";
}

TEST_F(TableFunctionTest, KeepsDuplicatesApartWhereInputsAreLists) {
  EXPECT_EQ(db.rows("SELECT n FROM countdown WHERE start IN (0, 1)"), "0\n1\n0");
  EXPECT_EQ(db.rows("SELECT DISTINCT n FROM countdown WHERE start IN (0, 1)"), "0\n1");
}

TEST_F(TableFunctionTest, LeavesLimitToSqlite) {
  EXPECT_EQ(db.rows("SELECT n FROM countdown(9) WHERE half < 2 LIMIT 2"), "3\n2");
  EXPECT_EQ(db.rows("SELECT n FROM countdown(9) WHERE n % 4 = 1 LIMIT 2"), "9\n5");
  EXPECT_EQ(db.rows("SELECT n FROM countdown(9) ORDER BY n LIMIT 2 OFFSET 1"), "1\n2");
}

TEST_F(TableFunctionTest, IsJoinedLaterally) {
  db.exec("CREATE TABLE starts(s, l); INSERT INTO starts VALUES (1, 'a'), (0, NULL)");
  EXPECT_EQ(db.rows("SELECT s, labelled FROM starts, countdown(s, 1, l)"), "1|a1\n1|a0\n0|#0");
  EXPECT_EQ(db.rows("SELECT s, labelled FROM countdown c JOIN starts ON c.start = s AND c.label = l"),
            "1|a1\n1|a0\n0|#0")
      << "an input that only the other table knows makes that table the outer one";
  EXPECT_EQ(db.rows("SELECT s, labelled FROM starts LEFT JOIN countdown(s, NULL, l) ON n = 1"),
            "1|a1\n0|NULL");
  EXPECT_EQ(db.error_of("SELECT * FROM countdown(d.start) c, countdown(c.start) d"), "no query solution");
}

TEST_F(TableFunctionTest, KeepsTwoCursorsApart) {
  EXPECT_EQ(db.rows("SELECT c.n, d.n FROM countdown(1) c, countdown(2) d"), "1|2\n1|1\n1|0\n0|2\n0|1\n0|0");
}

TEST_F(TableFunctionTest, WorksInViewsOfAnUntrustedSchema) {
  db.exec("PRAGMA trusted_schema = OFF; CREATE VIEW v AS SELECT n FROM countdown(1)");
  EXPECT_EQ(db.rows("SELECT * FROM v"), "1\n0");
}

TEST_F(TableFunctionTest, IsReadOnlyAndNeedsNoCreate) {
  EXPECT_EQ(db.error_of("DELETE FROM countdown"), "table countdown may not be modified");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE c USING countdown"), "no such module: countdown");
  EXPECT_EQ(db.error_of("SELECT rowid FROM countdown(1)"), "no such column: rowid");
}

std::vector<const char*> columns_named(const char* pattern, std::size_t count) {
  static std::vector<std::string> names;
  names.reserve(1000);
  std::vector<const char*> columns;
  for (std::size_t i = 0; i < count; ++i)
    columns.push_back(names.emplace_back(pattern + std::to_string(i)).c_str());
  return columns;
}

std::uint64_t outputs_that_are_read = 0;

/// A function of 50 outputs and 12 inputs, of which 9 are left out.
TableFunction wide_function(const char* name, std::vector<std::vector<int>> orders) {
  return {.name = name,
          .outputs = columns_named("o", 50),
          .inputs = columns_named("i", 12),
          .key = nullptr,
          .hinted = 0,
          .estimate = estimate_positions,
          .start = [](const FunctionCall& call) -> std::unique_ptr<FunctionRows> {
            outputs_that_are_read = 0;
            for (int output = 0; output < 50; ++output)
              if (call.reads(output)) outputs_that_are_read |= std::uint64_t{1} << output;
            return std::make_unique<Countdown>(0, 1, "#");
          },
          .orders = std::move(orders)};
}

TEST_F(TableFunctionTest, KnowsOfEachOfManyOutputsWhetherItIsRead) {
  static const TableFunction wide = wide_function("wide", {}),
                             sorted = wide_function("sorted", {{0}, {1, 0}});
  register_table_function(db.handle(), wide, std::make_shared<Connection>(db.handle()));
  register_table_function(db.handle(), sorted, std::make_shared<Connection>(db.handle()));
  for (int output = 0; output < 50; ++output)
    for (const char* name : {"wide(1, 2, 3)", "sorted(1, 2, 3)"}) {
      db.exec("SELECT o" + std::to_string(output) + ", i11 FROM " + name);
      EXPECT_EQ(outputs_that_are_read, std::uint64_t{1} << output) << name << " " << output;
    }
  db.exec("SELECT o49 FROM sorted(1, 2, 3) ORDER BY o1, o0");
  EXPECT_EQ(outputs_that_are_read, std::uint64_t{1} << 49 | 0b11);
}

constexpr ColumnList three_columns{"id INTEGER", "t REAL", "t_end REAL"};
static_assert(three_columns["id"] == 0 && three_columns["t"] == 1 && three_columns["t_end"] == 2);
constexpr ColumnList one_name{"h"};
static_assert(one_name["h"] == 0);

TEST(ColumnList, TheDeclarationHasThemInOrder) {
  const std::vector<const char*> declared = three_columns;
  ASSERT_EQ(declared.size(), 3u);
  EXPECT_STREQ(declared[static_cast<std::size_t>(three_columns["t"])], "t REAL");
}

}  // namespace
}  // namespace foresee
