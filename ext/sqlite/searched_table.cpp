#include "sqlite/searched_table.h"

#include "sqlite/open_table.h"

namespace foresee {

SearchedTable searched_table(const Call& call, const SearchInputs& inputs) {
  const std::string method = call.text(inputs.method).value_or("auto");
  if (method != "auto" && method != "scan")
    throw Error("method must be 'auto' or 'scan', not '" + method + "'");
  const auto now = call.number(inputs.now);
  const OpenScene open = open_scene(call.connection(), {call.text(inputs.tbl), call.text(inputs.schema)});
  return {{open.scene->name, open.scene, nullptr}, now ? *now : newest_t(*open.scene)};
}

}  // namespace foresee
