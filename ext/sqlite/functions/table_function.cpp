// The sqlite3_module of every table-valued function.
#include "sqlite/functions/table_function.h"

#include <bit>
#include <cstring>

#include "base/integer_of.h"
#include "base/repeatable_choice.h"
#include "database/value_text.h"
#include "sqlite/callback.h"
#include "sqlite/functions/function_plan.h"

namespace foresee {
namespace {

struct Registration {
  const TableFunction& function;
  std::shared_ptr<Connection> connection;
};

struct FunctionTable : sqlite3_vtab {
  const Registration* registration = nullptr;
  EarlierPlans earlier_plans;

  const TableFunction& function() const { return registration->function; }
  int output_count() const { return static_cast<int>(function().outputs.size()); }
};

struct FunctionCursor : sqlite3_vtab_cursor {
  std::unique_ptr<FunctionRows> rows;  ///< null at the end
  std::vector<OwnedValue> inputs;      ///< copies, one per input, null if it was left out
  UsedInputs used;                     ///< for the inputs that were left out
  std::string call;                    ///< the column of this name; empty until it is read
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

/// Like guarded(), with the function's name before the message.
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
                                joined(function.inputs, " HIDDEN") + ", call HIDDEN, PRIMARY KEY(" +
                                (function.key ? std::string(function.key) + ", " : "") +
                                "call)) WITHOUT ROWID";
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

int function_best_index(sqlite3_vtab* vtab, sqlite3_index_info* info) noexcept {
  return guarded_by_name(vtab, [&] {
    FunctionTable& table = table_of(vtab);
    return plan_call(table.function(), *table.registration->connection, table.earlier_plans, *info);
  });
}

int function_open(sqlite3_vtab* table, sqlite3_vtab_cursor** cursor) noexcept {
  table_of(table).earlier_plans = {};  // a statement runs, so planning has ended
  return guarded(&table->zErrMsg, [&] { *cursor = std::make_unique<FunctionCursor>().release(); });
}

int function_close(sqlite3_vtab_cursor* cursor) noexcept {
  delete &cursor_of(cursor);
  return SQLITE_OK;
}

/// Steps to the next row; releases the rows at the end.
void step(FunctionCursor& cursor) {
  if (!cursor.rows->next()) cursor.rows.reset();
}

[[noreturn]] void refuse_null(const TableFunction& function, int input) {
  const std::string name = function.inputs[static_cast<std::size_t>(input)];
  throw Error(name + " is NULL, which OR and more than sixteen conditions do not allow; leave " + name +
              " out, or write two queries with UNION ALL");
}

/// An input inside OR or an expression, or in WHERE on a LEFT JOIN, does not reach the call. SQLite then compares it
/// with the value that it has where it is left out.
void refuse_lost_inputs(const TableFunction& function, std::uint64_t columns_read, std::uint32_t given) {
  const std::uint32_t lost = inputs_read(function, columns_read) & function.unread_if_left_out & ~given;
  if (lost == 0) return;
  const std::string name = function.inputs[static_cast<std::size_t>(std::countr_zero(lost))];
  throw Error(
      name + " is read, but has no value: write " + name +
      " = ... with AND; inside OR or an expression, or in WHERE on a LEFT JOIN, it does not reach the "
      "function");
}

/// Sorts the values into inputs, conditions on outputs, and limits; the cursor keeps copies of the inputs for
/// xColumn. A NULL input counts as left out. False if a condition compares with NULL: no row can match. Throws
/// Error if a NULL, or an input inside OR, would lose every row (function_plan.h). The call reads the originals,
/// because SQLite 3.53 crashes in sqlite3_value_numeric_type() of a copy.
bool sort_arguments(FunctionCursor& cursor, const FunctionTable& table, const char* plan,
                    std::span<sqlite3_value*> values, Arguments& sorted) {
  cursor.inputs.clear();
  cursor.inputs.resize(table.function().inputs.size());
  sorted.inputs.resize(cursor.inputs.size());
  std::uint32_t given_inputs = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sqlite3_value* value = values[i];
    if (read_row_limit(plan, i, value, sorted.limit)) continue;
    const PlannedArgument planned = planned_argument(plan, i);
    const bool is_null = sqlite3_value_type(value) == SQLITE_NULL;
    const int input = planned.column - table.output_count();
    if (input >= 0) given_inputs |= 1u << input;
    if (input < 0) {
      if (is_null) return false;
      sorted.conditions.push_back({planned.column, planned.op, value});
    } else if (is_null) {
      if (planned.compared_again) refuse_null(table.function(), input);
    } else {
      OwnedValue copy(sqlite3_value_dup(value));
      if (!copy) throw std::bad_alloc();
      cursor.inputs[static_cast<std::size_t>(input)] = std::move(copy);
      sorted.inputs[static_cast<std::size_t>(input)] = value;
    }
  }
  refuse_lost_inputs(table.function(), sorted.columns_read, given_inputs);
  return true;
}

int function_filter(sqlite3_vtab_cursor* base, int number, const char* plan, int count,
                    sqlite3_value** arguments) noexcept {
  return guarded_by_name(base->pVtab, [&] {
    FunctionCursor& cursor = cursor_of(base);
    const FunctionTable& table = table_of(base->pVtab);
    cursor.rows.reset();
    cursor.used.clear();
    cursor.call.clear();
    const TableFunction& function = table.function();
    Arguments sorted{.columns_read = planned_columns(plan), .order = planned_order(function, number)};
    const std::span<sqlite3_value*> given(arguments, static_cast<std::size_t>(count));
    if (!sort_arguments(cursor, table, plan, given, sorted)) return;
    cursor.rows = function.start({function, *table.registration->connection, std::move(sorted), cursor.used});
    step(cursor);
  });
}

int function_next(sqlite3_vtab_cursor* cursor) noexcept {
  return guarded_by_name(cursor->pVtab, [&] { step(cursor_of(cursor)); });
}

int function_eof(sqlite3_vtab_cursor* cursor) noexcept {
  return !cursor_of(cursor).rows;
}

/// Bytes that are the same for calls with the same inputs, and only for those. Equal numbers are the same, and an input
/// that was left out is the value that it has then.
std::string inputs_as_bytes(const FunctionCursor& cursor) {
  std::string all;
  const auto add = [&all](char type, std::string_view bytes) {
    all += type + std::to_string(bytes.size()) + ':';
    all += bytes;
  };
  const auto add_bits = [&add](char type, auto number) {
    add(type, {reinterpret_cast<const char*>(&number), sizeof number});
  };
  const auto add_number = [&add_bits](double number) { add_bits('n', number + 0.0); };  // -0 is 0
  for (std::size_t i = 0; i < cursor.inputs.size(); ++i) {
    sqlite3_value* const input = cursor.inputs[i].get();
    const UsedInputs::Value used = input ? UsedInputs::Value{} : cursor.used.find(static_cast<int>(i));
    switch (input ? sqlite3_value_type(input) : SQLITE_NULL) {
      case SQLITE_NULL:
        if (const auto* number = std::get_if<double>(&used))
          add_number(*number);
        else if (const auto* text = std::get_if<std::string>(&used))
          add('t', *text);
        else
          add('-', {});
        break;
      case SQLITE_INTEGER:
        if (integer_of(sqlite3_value_double(input)) != sqlite3_value_int64(input)) {
          add_bits('i', sqlite3_value_int64(input));
          break;
        }
        [[fallthrough]];
      case SQLITE_FLOAT:
        add_number(sqlite3_value_double(input));
        break;
      case SQLITE_TEXT:
        add('t', text_of(input));
        break;
      case SQLITE_BLOB: {
        const auto* const bytes = static_cast<const char*>(sqlite3_value_blob(input));
        const auto size = static_cast<std::size_t>(sqlite3_value_bytes(input));
        if (!bytes && size > 0) throw std::bad_alloc();
        add('b', {bytes, size});
      }
    }
  }
  return all;
}

/// The column `call`. SQLite copies it for every row and may keep all copies, so long inputs, such as a zone, are a
/// hash of 128 bits.
std::string call_of(const FunctionCursor& cursor) {
  constexpr std::size_t max_length = 64;
  std::string bytes = inputs_as_bytes(cursor);
  if (bytes.size() <= max_length) return bytes;
  std::uint64_t hashes[] = {1, 2};
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
    for (std::uint64_t& hash : hashes) hash = hash_of(hash ^ word);
  }
  return std::string(reinterpret_cast<const char*>(hashes), sizeof hashes);
}

int function_column(sqlite3_vtab_cursor* base, sqlite3_context* context, int column) noexcept {
  return guarded_by_name(base->pVtab, [&] {
    FunctionCursor& cursor = cursor_of(base);
    const int input = column - table_of(base->pVtab).output_count();
    if (input < 0) return cursor.rows->output(context, column);
    if (static_cast<std::size_t>(input) == cursor.inputs.size()) {
      if (cursor.call.empty()) cursor.call = call_of(cursor);
      return sqlite3_result_blob64(context, cursor.call.data(), cursor.call.size(), SQLITE_TRANSIENT);
    }
    const OwnedValue& given = cursor.inputs[static_cast<std::size_t>(input)];
    if (given) return sqlite3_result_value(context, given.get());
    cursor.used.output(input, context);
  });
}

const sqlite3_module function_module = [] {
  sqlite3_module module{};
  module.xConnect = function_connect;  // no xCreate: the function exists without CREATE, which is not allowed
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

std::string usage(const TableFunction& function, std::size_t inputs) {
  std::vector<const char*> names = function.inputs;
  if (inputs < names.size()) {
    names.resize(inputs);
    names.push_back("...");
  }
  return std::string(function.name) + "(" + joined(names, "") + ")";
}

int register_table_function(sqlite3* db, const TableFunction& function,
                            std::shared_ptr<Connection> connection) {
  // SQLite destroys the registration even on failure.
  return sqlite3_create_module_v2(db, function.name, &function_module,
                                  new Registration{function, std::move(connection)},
                                  [](void* aux) { delete static_cast<Registration*>(aux); });
}

}  // namespace foresee
