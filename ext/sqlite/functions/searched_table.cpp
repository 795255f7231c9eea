#include "sqlite/functions/searched_table.h"

#include "base/number_text.h"
#include "database/value_text.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/legs/leg_scene.h"
#include "sqlite/names/open_table.h"

namespace foresee {

SearchedTable searched_table(const FunctionCall& call, const SearchInputs& inputs,
                             const std::optional<SearchedObject>& only) {
  const std::string method = call.text(inputs.method).value_or("auto");
  if (method != "auto" && method != "tree" && method != "scan")
    throw Error("method must be 'auto', 'tree' or 'scan', not '" + without_nul(method) + "'");
  const auto now = call.number(inputs.now);
  Connection& connection = call.connection();
  const auto table = open_table(connection, {call.text(inputs.tbl), call.text(inputs.schema)});
  call.reads_back_as(inputs.tbl, table.table);
  call.reads_back_as(inputs.schema, table.schema);
  call.reads_back_as(inputs.method, "auto");
  SearchedTable searched{{table.table, nullptr, nullptr}, now.value_or(0), table.store->frame()};
  if (only || method == "scan") {
    if (!now) searched.now = table.store->read_newest_t();
    searched.objects.scene =
        only ? StoredTable(connection, table).objects({&only->id, 1}, leg_times_of({searched.now, only->h}))
             : connection.load_scene(table);
  } else {
    searched.objects.tree = table.store->take_snapshot();
    searched.objects.chunks = table.store->chunks();
    if (!now) searched.now = read_newest_t(*searched.objects.tree);
  }
  call.reads_back_as(inputs.now, searched.now);
  return searched;
}

void require_default_now(const OpenTables& tables, std::span<const double> record, double now) {
  const auto has_plans = [](const OpenTable& table) { return table.store->declaration().layout.has_plan; };
  if (record.empty() || !(has_plans(tables.a) || (tables.b && has_plans(*tables.b)))) return;
  const double own = value_or(record.data(), tables.a.store->format().at.t, 0);
  if (own < now)
    throw Error("the newest t is " + shown(now) +
                ", perhaps the start of a plan later than that of the object, " + shown(own) +
                ": write now = ..., the time of the manoeuvre");
}

}  // namespace foresee
