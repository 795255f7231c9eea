// The virtual-table side of every table-valued function.
//
// Plan of one call, from xBestIndex to xFilter:
//   idxNum   the outputs that the statement reads, one bit each; from bit 16 on the order that rows must come
//            in: how many of its outputs, and from bit 20 on which of the function's orders
//   idxStr   two letters per argument: 'A' + column, then the comparison ('=' '>' 'G' '<' 'L'), or '!' for an
//            input that SQLite compares once more
// Constraints on inputs are consumed; those on outputs are hints that SQLite checks again. Where it does so
// with an input, a NULL would lose every row, since no comparison with NULL is true: reading that column is
// an error. LIMIT is left to SQLite: 3.40 offers it even where other constraints remain to be checked.
#include "sqlite/functions/table_function.h"

#include <algorithm>

#include "sqlite/callback.h"
#include "sqlite/host.h"

namespace foresee {
namespace {

struct Registration {
  const TableFunction& function;
  std::shared_ptr<Connection> connection;
};

struct FunctionTable : sqlite3_vtab {
  const Registration* registration = nullptr;
  // What xBestIndex was asked before, in planning the same statement: see estimate().
  bool or_loses_rows = false;
  bool one_side_was_planned = false;

  const TableFunction& function() const { return registration->function; }
  int output_count() const { return static_cast<int>(function().outputs.size()); }
};

struct FunctionCursor : sqlite3_vtab_cursor {
  std::unique_ptr<Rows> rows;      ///< null at the end
  std::vector<OwnedValue> inputs;  ///< copies, one per input, null where it was left out
  std::uint32_t lose_rows = 0;     ///< bit set: this input was given as NULL, and SQLite compares it again
};

FunctionTable& table_of(sqlite3_vtab* table) {
  return *static_cast<FunctionTable*>(table);
}
FunctionCursor& cursor_of(sqlite3_vtab_cursor* cursor) {
  return *static_cast<FunctionCursor*>(cursor);
}

std::string joined(const std::vector<const char*>& words, const char* suffix) {
  std::string text;
  for (const char* word : words) text += (text.empty() ? "" : ", ") + std::string(word) + suffix;
  return text;
}

/// As guarded(), with the function's name in front of the message.
template <class Body>
int guarded_by_name(sqlite3_vtab* table, Body&& body) noexcept {
  char* message = nullptr;
  const int rc = guarded(&message, body);
  if (!message) return rc;
  sqlite3_free(table->zErrMsg);
  table->zErrMsg = sqlite3_mprintf("%s: %z", table_of(table).function().name, message);
  return rc;
}

int function_connect(sqlite3* db, void* aux, int, const char* const*, sqlite3_vtab** table,
                     char** message) noexcept {
  return guarded(message, [&]() -> int {
    const auto* registration = static_cast<const Registration*>(aux);
    const TableFunction& function = registration->function;
    const std::string columns = "CREATE TABLE x(" + joined(function.outputs, "") + ", " +
                                joined(function.inputs, " HIDDEN") + ", PRIMARY KEY(" + function.key + ", " +
                                joined(function.inputs, "") + ")) WITHOUT ROWID";
    const int rc = sqlite3_declare_vtab(db, columns.c_str());
    if (rc != SQLITE_OK) return rc;
    sqlite3_vtab_config(db, SQLITE_VTAB_INNOCUOUS);
    auto made = std::make_unique<FunctionTable>();
    made->registration = registration;
    *table = made.release();
    return SQLITE_OK;
  });
}

int function_disconnect(sqlite3_vtab* table) noexcept {
  table_of(table).registration->connection->finalize();
  delete &table_of(table);
  return SQLITE_OK;
}

char letter_of(int op) {
  switch (op) {
    case SQLITE_INDEX_CONSTRAINT_EQ:
      return '=';
    case SQLITE_INDEX_CONSTRAINT_GT:
      return '>';
    case SQLITE_INDEX_CONSTRAINT_GE:
      return 'G';
    case SQLITE_INDEX_CONSTRAINT_LT:
      return '<';
    case SQLITE_INDEX_CONSTRAINT_LE:
      return 'L';
    default:
      return 0;
  }
}

int op_of(char letter) {
  for (int op : {SQLITE_INDEX_CONSTRAINT_EQ, SQLITE_INDEX_CONSTRAINT_GT, SQLITE_INDEX_CONSTRAINT_GE,
                 SQLITE_INDEX_CONSTRAINT_LT, SQLITE_INDEX_CONSTRAINT_LE})
    if (letter_of(op) == letter) return op;
  return 0;
}

/// What one xBestIndex call finds out, constraint by constraint.
struct Plan {
  std::string arguments;
  std::uint32_t inputs_given = 0, inputs_unusable = 0;
  std::uint32_t inputs_unknown = 0;      ///< not written out in the statement: bound, or computed
  std::uint32_t inputs_compared = 0;     ///< SQLite compares them once more
  bool null_inputs = false;              ///< one of them is written out as NULL
  bool about_ids = false;                ///< an output is compared with a value, known yet or not
  int equalities = 0, inequalities = 0;  ///< hints: ids, and other
};

void take(Plan& plan, const FunctionTable& table, sqlite3_index_info& info, int i) {
  const auto& constraint = info.aConstraint[i];
  const char letter = letter_of(constraint.op);
  const int input = constraint.iColumn - table.output_count();
  if (!letter || constraint.iColumn < 0) return;
  const bool is_input = input >= 0;
  if (is_input) {
    const std::uint32_t bit = 1u << input;
    if (letter != '=') return;
    // One side of an OR gets the arguments of a call twice; and SQLite leaves out no check beyond the
    // sixteenth.
    if ((plan.inputs_given & bit) || i >= 16) plan.inputs_compared |= bit;
    if (plan.inputs_given & bit) return;
    (constraint.usable ? plan.inputs_given : plan.inputs_unusable) |= bit;
  } else if (!(table.function().hinted >> constraint.iColumn & 1)) {
    return;
  }
  const bool probes = !is_input && letter == '=' && (table.function().probed >> constraint.iColumn & 1);
  if (probes) plan.about_ids = true;
  if (!constraint.usable) return;
  // `t IN (…)` would be one call a value; compared with the rows of one call it costs next to nothing.
  if (!is_input && !probes && letter == '=' && may_be_list(info, i)) return;
  if (is_input && input > 0) {
    sqlite3_value* written = written_value(info, i);
    if (!written) plan.inputs_unknown |= 1u << input;
    plan.null_inputs |= written ? sqlite3_value_type(written) == SQLITE_NULL : !tells_written_values();
  }
  if (!is_input) ++(probes ? plan.equalities : plan.inequalities);
  plan.arguments += {static_cast<char>('A' + constraint.iColumn), letter};
  info.aConstraintUsage[i].argvIndex = static_cast<int>(plan.arguments.size() / 2);
  info.aConstraintUsage[i].omit = is_input;
}

/// A join about one id looks into the tree. Without its first input a call fails, so any other plan is
/// better; but to plan `a = 42 OR b = 42` SQLite shows one side of the OR alone and adds the inputs only when
/// it writes that side's program.
///
/// Having run it, SQLite looks at `input = NULL` once more, finds it not true and loses every row. So where
/// an input is written out as NULL, or comes from another table and may be NULL in some row, there must be no
/// such plan. It is known by what comes before it: a call as a whole that says nothing of ids. (A question
/// about one id that follows such a call may be planned worse than need be.) What is bound later is taken for
/// no NULL; if it is one, that is an error.
void estimate(FunctionTable& table, Plan& plan, sqlite3_index_info& info) {
  const TableFunction& function = table.function();
  const bool whole = (plan.inputs_given & 1) != 0;
  if (whole && !plan.about_ids) {
    table.or_loses_rows = plan.null_inputs;
    table.one_side_was_planned = false;
  }
  if (plan.about_ids && plan.equalities == 0) table.or_loses_rows = false;
  if (plan.equalities > 0 && !whole) table.one_side_was_planned = true;
  if (table.one_side_was_planned) plan.inputs_compared |= plan.inputs_unknown;
  double cost = function.cost, rows = function.rows;
  if (plan.equalities > 0) cost = 1e3, rows = plan.equalities > 1 ? 1 : 10;
  if (plan.inequalities > 0) rows = std::max(1.0, rows / 4);
  if (plan.equalities > 0 ? table.or_loses_rows : !whole) cost = 1e50;
  info.estimatedCost = cost;
  info.estimatedRows = static_cast<sqlite3_int64>(rows);
}

/// The arguments as idxStr has them.
std::string described(const Plan& plan, int output_count) {
  std::string text = plan.arguments;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    const int input = text[at] - 'A' - output_count;
    if (input >= 0 && (plan.inputs_compared >> input & 1)) text[at + 1] = '!';
  }
  return text;
}

constexpr int order_length_at = 16, order_at = 20;  // in idxNum

/// If ORDER BY is one of the function's orders, or the beginning of one, rows come in that order.
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
    return info.nOrderBy << order_length_at | static_cast<int>(i) << order_at;
  }
  return 0;
}

std::span<const int> order_of(const TableFunction& function, int plan) {
  const int length = plan >> order_length_at & 0xf;
  if (length == 0) return {};
  return std::span(function.orders[static_cast<std::size_t>(plan >> order_at)])
      .first(static_cast<std::size_t>(length));
}

int function_best_index(sqlite3_vtab* vtab, sqlite3_index_info* info) noexcept {
  return guarded_by_name(vtab, [&]() -> int {
    FunctionTable& table = table_of(vtab);
    Plan plan;
    for (int i = 0; i < info->nConstraint; ++i) take(plan, table, *info, i);
    if (const std::uint32_t missing = plan.inputs_unusable & ~plan.inputs_given) {
      table.or_loses_rows |= (missing & ~1u) != 0;  // they come from another table
      return SQLITE_CONSTRAINT;
    }
    info->idxNum = static_cast<int>(info->colUsed & ((1u << table.output_count()) - 1)) |
                   take_order(table.function(), *info);
    estimate(table, plan, *info);
    info->idxStr = sqlite3_mprintf("%s", described(plan, table.output_count()).c_str());
    if (!info->idxStr) return SQLITE_NOMEM;
    info->needToFreeIdxStr = 1;
    return SQLITE_OK;
  });
}

int function_open(sqlite3_vtab* table, sqlite3_vtab_cursor** cursor) noexcept {
  table_of(table).one_side_was_planned = false;  // a statement runs: none is being planned
  return guarded(&table->zErrMsg, [&] { *cursor = std::make_unique<FunctionCursor>().release(); });
}

int function_close(sqlite3_vtab_cursor* cursor) noexcept {
  delete &cursor_of(cursor);
  return SQLITE_OK;
}

void step(FunctionCursor& cursor) {
  if (!cursor.rows->next()) cursor.rows.reset();
}

/// Sorts the arguments into inputs, of which the cursor keeps copies, and hints. False if some hint is NULL:
/// then nothing can match. The call reads the originals: SQLite 3.53 crashes when a copy is asked for its
/// numeric type.
bool sort_arguments(FunctionCursor& cursor, const FunctionTable& table, const char* plan,
                    std::span<sqlite3_value*> arguments, std::vector<sqlite3_value*>& inputs,
                    std::vector<Hint>& hints) {
  cursor.lose_rows = 0;
  cursor.inputs.clear();
  cursor.inputs.resize(table.function().inputs.size());
  inputs.resize(cursor.inputs.size());
  for (sqlite3_value* value : arguments) {
    const int column = *plan++ - 'A';
    const char letter = *plan++;
    const bool is_null = sqlite3_value_type(value) == SQLITE_NULL;
    const int input = column - table.output_count();
    if (input < 0) {
      if (is_null) return false;
      hints.push_back({column, op_of(letter), value});
    } else if (is_null) {
      if (letter == '!') cursor.lose_rows |= 1u << input;
    } else {
      OwnedValue copy(sqlite3_value_dup(value));
      if (!copy) throw std::bad_alloc();
      cursor.inputs[static_cast<std::size_t>(input)] = std::move(copy);
      inputs[static_cast<std::size_t>(input)] = value;
    }
  }
  return true;
}

int function_filter(sqlite3_vtab_cursor* base, int number, const char* plan, int count,
                    sqlite3_value** arguments) noexcept {
  return guarded_by_name(base->pVtab, [&] {
    FunctionCursor& cursor = cursor_of(base);
    const FunctionTable& table = table_of(base->pVtab);
    cursor.rows.reset();
    std::vector<sqlite3_value*> inputs;
    std::vector<Hint> hints;
    const std::span<sqlite3_value*> given(arguments, static_cast<std::size_t>(count));
    if (!sort_arguments(cursor, table, plan, given, inputs, hints)) return;
    const auto outputs_read = static_cast<std::uint32_t>(number) & ((1u << table.output_count()) - 1);
    const Call call(table.function(), *table.registration->connection, inputs, std::move(hints), outputs_read,
                    order_of(table.function(), number));
    cursor.rows = table.function().start(call);
    step(cursor);
  });
}

int function_next(sqlite3_vtab_cursor* cursor) noexcept {
  return guarded_by_name(cursor->pVtab, [&] { step(cursor_of(cursor)); });
}

int function_eof(sqlite3_vtab_cursor* cursor) noexcept {
  return !cursor_of(cursor).rows;
}

[[noreturn]] void refuse_null(const TableFunction& function, int input) {
  const std::string name = function.inputs[static_cast<std::size_t>(input)];
  throw Error(name + " is NULL, which SQLite compares again and so would lose this row: leave " + name +
              " out, write fewer conditions, or in place of a = ... OR b = ... two questions with UNION ALL");
}

int function_column(sqlite3_vtab_cursor* base, sqlite3_context* context, int column) noexcept {
  return guarded_by_name(base->pVtab, [&] {
    const FunctionCursor& cursor = cursor_of(base);
    const int input = column - table_of(base->pVtab).output_count();
    if (input < 0) return cursor.rows->output(context, column);
    if (cursor.lose_rows >> input & 1) refuse_null(table_of(base->pVtab).function(), input);
    const OwnedValue& given = cursor.inputs[static_cast<std::size_t>(input)];
    if (given) sqlite3_result_value(context, given.get());
  });
}

const sqlite3_module function_module = [] {
  sqlite3_module module{};
  module.xConnect = function_connect;  // no xCreate: the function is there without CREATE, and only so
  module.xBestIndex = function_best_index;
  module.xDisconnect = function_disconnect;
  module.xOpen = function_open;
  module.xClose = function_close;
  module.xFilter = function_filter;
  module.xNext = function_next;
  module.xEof = function_eof;
  module.xColumn = function_column;
  return module;
}();

}  // namespace

std::string usage(const TableFunction& function) {
  return std::string(function.name) + "(" + joined(function.inputs, "") + ")";
}

int register_table_function(sqlite3* db, const TableFunction& function,
                            std::shared_ptr<Connection> connection) {
  // SQLite destroys the registration also when it fails.
  return sqlite3_create_module_v2(db, function.name, &function_module,
                                  new Registration{function, std::move(connection)},
                                  [](void* aux) { delete static_cast<Registration*>(aux); });
}

}  // namespace foresee
