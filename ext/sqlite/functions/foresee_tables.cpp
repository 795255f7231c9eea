// foresee_tables in SQL: every moving_objects table that the connection sees, with its frame and size.
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/open_table.h"
#include "sqlite/names/visible_tables.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

constexpr ColumnList list_outputs{"name TEXT",   "schema TEXT",     "frame TEXT",
                                  "origin TEXT", "speed_unit TEXT", "objects INTEGER"};
constexpr ColumnList list_inputs{"schema_name"};
constexpr int out_name = list_outputs["name"], out_schema = list_outputs["schema"],
              out_frame = list_outputs["frame"], out_origin = list_outputs["origin"],
              out_speed_unit = list_outputs["speed_unit"], out_objects = list_outputs["objects"];

struct ListedTable {
  std::string name, schema;
  std::optional<Frame> frame = {};  ///< nothing: the table cannot be read
  std::optional<std::int64_t> objects = {};
};

ListedTable read_table(Connection& connection, const VisibleTable& table) {
  ListedTable listed{table.name, table.schema};
  try {
    const auto open = open_table(connection, {table.name, table.schema});
    open.store->read_version();
    listed.objects = open.store->known_objects();
    listed.frame = open.store->frame();
  } catch (const StoreError& error) {
    if (!error.is_of_contents()) throw;
  } catch (const Error&) {  // another version of foresee declared it
  }
  return listed;
}

class TableList final : public FunctionRows {
 public:
  explicit TableList(std::vector<ListedTable> tables) : tables_(std::move(tables)) {}

  bool next() override { return ++row_ < tables_.size(); }

  void output(sqlite3_context* context, int output) const override {
    const ListedTable& table = tables_[row_];
    const auto text = [&](std::string_view value) {
      sqlite3_result_text64(context, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
    };
    if (output == out_name) return text(table.name);
    if (output == out_schema) return text(table.schema);
    if (!table.frame) return;
    const Frame& frame = *table.frame;
    if (output == out_frame) return text(frame.name());
    if (output == out_objects && table.objects) return sqlite3_result_int64(context, *table.objects);
    if (output == out_origin && frame.origin) return text(origin_text(*frame.origin));
    if (output == out_speed_unit && frame.in_degrees()) return text(name_of(frame.unit));
  }

 private:
  std::vector<ListedTable> tables_;
  std::size_t row_ = static_cast<std::size_t>(-1);
};

std::unique_ptr<FunctionRows> start_tables(const FunctionCall& call) {
  Connection& connection = call.connection();
  const auto schema = call.text(list_inputs["schema_name"]);
  std::vector<ListedTable> tables;
  for (const VisibleTable& table : visible_tables(connection.db()))
    if (table.holds_moving_objects && (!schema || same_name(table.schema, *schema)))
      tables.push_back(read_table(connection, table));
  return std::make_unique<TableList>(std::move(tables));
}

}  // namespace

const TableFunction& foresee_tables() {
  static const TableFunction function = {.name = "foresee_tables",
                                         .outputs = list_outputs,
                                         .inputs = list_inputs,
                                         .key = "schema, name",
                                         .hinted = 0,
                                         .estimate =
                                             [](const CallSizes&) {
                                               return CallEstimate{100, 3};
                                             },
                                         .start = start_tables,
                                         .unread_if_left_out = 1};
  return function;
}

}  // namespace foresee
