#include "sqlite/functions/function_plan.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "sqlite/functions/function_call.h"
#include "sqlite/host_sqlite.h"

namespace foresee {
namespace {

int output_count(const TableFunction& function) {
  return static_cast<int>(function.outputs.size());
}

/// Comparisons of xBestIndex: the letter in idxStr, 0: left to SQLite; and how a statement writes those that give an
/// input no value.
struct Comparison {
  int op;
  char letter;
  const char* written;
};
constexpr Comparison comparisons[] = {
    {SQLITE_INDEX_CONSTRAINT_EQ, '=', nullptr},  {SQLITE_INDEX_CONSTRAINT_GT, '>', ">"},
    {SQLITE_INDEX_CONSTRAINT_GE, 'G', ">="},     {SQLITE_INDEX_CONSTRAINT_LT, '<', "<"},
    {SQLITE_INDEX_CONSTRAINT_LE, 'L', "<="},     {SQLITE_INDEX_CONSTRAINT_NE, 0, "<>"},
    {SQLITE_INDEX_CONSTRAINT_LIKE, 0, "LIKE"},   {SQLITE_INDEX_CONSTRAINT_GLOB, 0, "GLOB"},
    {SQLITE_INDEX_CONSTRAINT_ISNOT, 0, "IS NOT"}};

const Comparison& comparison_of(int op) {
  static constexpr Comparison other = {-1, 0, nullptr};
  for (const Comparison& one : comparisons)
    if (one.op == op) return one;
  return other;
}

/// The second letter of a LIMIT or OFFSET constraint; 0 for other constraints.
char limit_letter(int op) {
  if (op == SQLITE_INDEX_CONSTRAINT_LIMIT) return 'n';
  return op == SQLITE_INDEX_CONSTRAINT_OFFSET ? 'o' : 0;
}

int op_of(char letter) {
  for (const Comparison& one : comparisons)
    if (letter && one.letter == letter) return one.op;
  return 0;
}

/// The result of one xBestIndex call, collected constraint by constraint.
struct FunctionPlan {
  std::string arguments;
  std::vector<sqlite3_value*> written;  ///< one per input: its literal in the statement, or null
  std::uint32_t inputs_given = 0, inputs_unusable = 0;
  std::uint32_t inputs_unknown = 0;      ///< not literals in the statement: bound, or computed
  std::uint32_t inputs_compared = 0;     ///< SQLite compares them again
  bool null_inputs = false;              ///< an input is NULL in the text of the statement
  bool about_ids = false;                ///< an id is compared with a value, usable in this plan or not
  std::uint32_t probed_by = 0;           ///< bit set: this id is compared with a usable value
  bool compares_other_id = false;        ///< SQLite compares the other id with a list
  int equalities = 0, inequalities = 0;  ///< conditions: on ids, and on other outputs
};

/// As in a join: `a = 3 OR b = 3` may be planned as two calls. With a single id it is a list of ids.
bool has_two_ids(const TableFunction& function) {
  return (function.probed & (function.probed - 1)) != 0;
}

bool is_id_equality(const TableFunction& function, const sqlite3_index_info& info, int i) {
  const auto& constraint = info.aConstraint[i];
  return 0 <= constraint.iColumn && constraint.iColumn < output_count(function) &&
         (function.probed >> constraint.iColumn & 1) && constraint.op == SQLITE_INDEX_CONSTRAINT_EQ;
}

/// Whether SQLite compares the list of ids of constraint i, because the call is about another id.
bool leaves_list_to_sqlite(const TableFunction& function, sqlite3_index_info& info, int i) {
  for (int j = 0; j < info.nConstraint; ++j)
    if (is_id_equality(function, info, j) && info.aConstraint[j].usable &&
        info.aConstraint[j].iColumn != info.aConstraint[i].iColumn && is_spare_list(info, i, j))
      return true;
  return false;
}

/// `within <= 50` would compare the input with itself, after a call that has not received it.
void refuse_comparison(const TableFunction& function, int input, int op) {
  const char* const written = comparison_of(op).written;
  if (!written) return;
  const std::string name = function.inputs[static_cast<std::size_t>(input)];
  throw Error(name + " is an input, not an output: write " + name + " = ..., not " + name + ' ' + written +
              " ...");
}

/// Adds constraint i to the plan. An input is consumed; a condition on a hinted output is passed to the call and SQLite
/// checks it again. SQLite alone checks any other.
void take(FunctionPlan& plan, const TableFunction& function, sqlite3_index_info& info, int i) {
  const auto& constraint = info.aConstraint[i];
  const int input = constraint.iColumn - output_count(function);
  const bool is_input = input >= 0 && !limit_letter(constraint.op);
  if (is_input && static_cast<std::size_t>(input) == function.inputs.size())
    throw Error("too many inputs: write at most " + usage(function));
  if (is_input) refuse_comparison(function, input, constraint.op);
  const bool is_null = constraint.op == SQLITE_INDEX_CONSTRAINT_ISNULL;  // xFilter gets a NULL
  const bool gives_value = is_input && (is_null || constraint.op == SQLITE_INDEX_CONSTRAINT_IS);
  const char letter = gives_value ? '=' : comparison_of(constraint.op).letter;
  if (!letter || constraint.iColumn < 0) return;
  if (is_input) {
    const std::uint32_t bit = 1u << input;
    // One side of an OR receives the arguments of a call twice, and SQLite omits the check of the first
    // sixteen constraints only.
    if ((plan.inputs_given & bit) || i >= 16) plan.inputs_compared |= bit;
    if (plan.inputs_given & bit) return;
    (constraint.usable ? plan.inputs_given : plan.inputs_unusable) |= bit;
  } else if (!(function.hinted >> constraint.iColumn & 1)) {
    return;
  }
  const bool probes = is_id_equality(function, info, i);
  plan.about_ids |= probes;
  if (!constraint.usable) return;
  if (probes && leaves_list_to_sqlite(function, info, i)) {
    plan.compares_other_id = true;
    return;
  }
  // `t IN (…)` would make one call per value; to compare the rows of one call costs almost nothing.
  if (!is_input && !probes && letter == '=' && may_be_list(info, i)) return;
  if (is_input && input > 0) {
    sqlite3_value* written = plan.written[static_cast<std::size_t>(input)] = written_value(info, i);
    if (!written && !is_null) plan.inputs_unknown |= 1u << input;
    plan.null_inputs |= is_null || (written && sqlite3_value_type(written) == SQLITE_NULL);
  }
  if (!is_input) ++(probes ? plan.equalities : plan.inequalities);
  if (probes) plan.probed_by |= 1u << constraint.iColumn;
  plan.arguments += {static_cast<char>('A' + constraint.iColumn), letter};
  info.aConstraintUsage[i].argvIndex = static_cast<int>(plan.arguments.size() / 2);
  info.aConstraintUsage[i].omit = is_input;
}

/// Whether conditions are those of an earlier call, `shift` places further on.
bool are_same(std::span<const EarlierPlans::Condition> conditions,
              std::span<const EarlierPlans::Condition> earlier, int shift) {
  return std::equal(conditions.begin(), conditions.end(), earlier.begin(), earlier.end(),
                    [shift](const auto& one, const auto& other) {
                      return one.iColumn == other.iColumn && one.op == other.op &&
                             one.iTermOffset == other.iTermOffset + shift;
                    });
}

/// Whether info is about one side of an OR of the call that was planned last. SQLite 3.46 offers a side without
/// the inputs, 3.48 with all conditions of the call behind its own.
bool is_side_of_or(const FunctionPlan& plan, const EarlierPlans& earlier, const sqlite3_index_info& info) {
  if (((plan.inputs_given | plan.inputs_unusable) & 1) == 0) return true;
  const std::span all(info.aConstraint, static_cast<std::size_t>(info.nConstraint));
  if (earlier.call.empty() || all.size() <= earlier.call.size()) return false;
  const auto shared = all.last(earlier.call.size());
  const int shift = shared[0].iTermOffset - earlier.call[0].iTermOffset;
  return shift > 0 && are_same(shared, earlier.call, shift);
}

/// Remembers a call that is not a side of an OR; `null_inputs`: an input is, or may be, NULL.
void remember(EarlierPlans& earlier, const sqlite3_index_info& info, bool null_inputs) {
  const std::span all(info.aConstraint, static_cast<std::size_t>(info.nConstraint));
  const bool again = are_same(all, earlier.call, 0);
  earlier.null_inputs = null_inputs || (again && earlier.null_inputs);
  earlier.call.assign(all.begin(), all.end());
}

/// Fills in the cost and the number of rows. A join about one id searches the tree. A call without its first input
/// fails, so that plan gets the highest cost.
/// To run `a = 42 OR b = 42`, SQLite may make a call for each side and then evaluate `input = NULL` again, which is
/// not true, and lose every row. So no side may be planned if an input is a literal NULL, or comes from another table
/// and may be NULL in some row. An input that is bound later counts as not NULL: the call refuses a NULL.
void estimate(const TableFunction& function, const Connection& connection, const FunctionPlan& plan,
              bool is_side, bool loses_rows, sqlite3_index_info& info) {
  const CallSizes sizes = call_sizes(function, connection, plan.written, plan.inputs_given);
  const bool by_first = plan.probed_by & 1,
             by_both = plan.compares_other_id || (plan.probed_by & (plan.probed_by - 1)) != 0;
  auto [cost, rows] = plan.equalities > 0 && function.estimate_probe
                          ? function.estimate_probe(sizes, by_first)
                          : function.estimate(sizes);
  if (by_both) rows = 1;
  if (plan.inequalities > 0) rows /= 4;
  rows = std::max(1.0, rows);
  // An input that is read, but not given, may be inside an OR: its sides receive it.
  if (!is_side && (inputs_read(function, info.colUsed) & ~plan.inputs_given) != 0) cost *= 1000;
  const bool fails = (plan.inputs_given & 1) == 0 && plan.equalities == 0;
  if (loses_rows || fails) cost = 1e50;
  info.estimatedCost = cost;
  info.estimatedRows = static_cast<sqlite3_int64>(rows);
}

/// The arguments in idxStr, with a mark at those that SQLite compares again.
std::string described(const FunctionPlan& plan, int output_count) {
  std::string text = plan.arguments;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    const int input = text[at] - 'A' - output_count;
    if (input >= 0 && (plan.inputs_compared >> input & 1)) text[at + 1] = '!';
  }
  return text;
}

constexpr int order_at = 4;                      // in idxNum
constexpr std::size_t columns_read_length = 16;  // in idxStr

/// The idxNum for an ORDER BY that is one of the function's orders or a prefix of one. The call
/// returns rows in that order and SQLite does not sort. 0 for any other: SQLite sorts.
int take_order(const TableFunction& function, sqlite3_index_info& info) {
  const auto wanted = std::span(info.aOrderBy, static_cast<std::size_t>(std::max(0, info.nOrderBy)));
  if (wanted.empty()) return 0;
  for (std::size_t i = 0; i < function.orders.size(); ++i) {
    const std::vector<int>& order = function.orders[i];
    if (wanted.size() > order.size()) continue;
    const bool fits =
        std::equal(wanted.begin(), wanted.end(), order.begin(),
                   [](const auto& term, int output) { return term.iColumn == output && !term.desc; });
    if (!fits) continue;
    info.orderByConsumed = 1;
    return info.nOrderBy | static_cast<int>(i) << order_at;
  }
  return 0;
}

constexpr char no_column = 'A' - 1;

/// Whether the call itself leaves out the rows that do not satisfy a constraint.
bool is_applied(const TableFunction& function, const sqlite3_index_info& info, int i) {
  const auto& constraint = info.aConstraint[i];
  if (info.aConstraintUsage[i].argvIndex == 0) return false;
  if (constraint.iColumn >= output_count(function)) return true;
  const bool probed = function.probed >> constraint.iColumn & 1;  // then only equality is applied
  return !probed || constraint.op == SQLITE_INDEX_CONSTRAINT_EQ;
}

/// Requests LIMIT and OFFSET from SQLite and appends two letters for each to the plan's arguments. Requests
/// neither if SQLite checks a condition that the call does not apply itself. Requires: all other constraints
/// have been taken.
void take_row_limit(const TableFunction& function, sqlite3_index_info& info, std::string& arguments) {
  for (int i = 0; i < info.nConstraint; ++i)
    if (!limit_letter(info.aConstraint[i].op) && !is_applied(function, info, i)) return;
  for (int i = 0; i < info.nConstraint; ++i) {
    const char letter = limit_letter(info.aConstraint[i].op);
    if (!letter || !info.aConstraint[i].usable) continue;
    arguments += {no_column, letter};
    info.aConstraintUsage[i].argvIndex = static_cast<int>(arguments.size() / 2);
  }
}

}  // namespace

int plan_call(const TableFunction& function, const Connection& connection, EarlierPlans& earlier,
              sqlite3_index_info& info) {
  FunctionPlan plan;
  plan.written.resize(function.inputs.size());
  for (int i = 0; i < info.nConstraint; ++i) take(plan, function, info, i);
  const std::uint32_t missing = plan.inputs_unusable & ~plan.inputs_given;  // from a table that is read later
  sqlite3_stmt* statement = statement_in_preparation(connection.db());
  if (earlier.statement != statement) earlier = {statement, {}, false, false};
  const bool is_side = is_side_of_or(plan, earlier, info);
  if (is_side) {
    earlier.side_was_planned = true;
  } else {
    remember(earlier, info, plan.null_inputs || (missing & ~1u) != 0);
    if (!plan.about_ids) earlier.side_was_planned = false;  // another call of the statement
  }
  if (missing) return SQLITE_CONSTRAINT;
  if (earlier.side_was_planned) plan.inputs_compared |= plan.inputs_unknown;
  info.idxNum = take_order(function, info);
  if (info.idxNum != 0) take_row_limit(function, info, plan.arguments);
  const bool loses_rows = is_side && (earlier.null_inputs || !has_two_ids(function));
  estimate(function, connection, plan, is_side, loses_rows, info);
  info.idxStr = sqlite3_mprintf("%016llx%s", info.colUsed, described(plan, output_count(function)).c_str());
  if (!info.idxStr) return SQLITE_NOMEM;
  info.needToFreeIdxStr = 1;
  return SQLITE_OK;
}

PlannedArgument planned_argument(const char* plan, std::size_t argument) {
  const char* letters = plan + columns_read_length + 2 * argument;
  return {letters[0] - 'A', op_of(letters[1]), letters[1] == '!'};
}

bool read_row_limit(const char* plan, std::size_t argument, sqlite3_value* value, RowLimit& limit) {
  const char* letters = plan + columns_read_length + 2 * argument;
  if (letters[0] != no_column) return false;
  (letters[1] == 'n' ? limit.rows : limit.skipped) = sqlite3_value_int64(value);
  return true;
}

std::uint64_t planned_columns(const char* plan) {
  std::uint64_t columns = 0;
  std::from_chars(plan, plan + columns_read_length, columns, 16);
  return columns;
}

std::span<const int> planned_order(const TableFunction& function, int order) {
  const int length = order & ((1 << order_at) - 1);
  if (length == 0) return {};
  return std::span(function.orders[static_cast<std::size_t>(order >> order_at)])
      .first(static_cast<std::size_t>(length));
}

}  // namespace foresee
