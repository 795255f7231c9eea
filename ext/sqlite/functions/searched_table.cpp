#include "sqlite/functions/searched_table.h"

#include "database/value_text.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/legs/leg_scene.h"
#include "sqlite/names/open_table.h"
#include "sqlite/stored_table.h"

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

}  // namespace foresee
