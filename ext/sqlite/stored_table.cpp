#include "sqlite/stored_table.h"

#include <algorithm>

#include "base/float_environment.h"

namespace foresee {

ChangedObjects StoredTable::changes_since(const std::optional<std::int64_t>& stamp) {
  Store& store = *table_.store;
  ChangedObjects changed;
  changed.are_known = stamp && stamp == store.stamp_before_changes();
  if (!changed.are_known) return changed;
  const int t = store.format().at.t;
  store.for_each_change([&](std::int64_t id, std::span<const double> record) {
    changed.ids.push_back(id);
    if (!record.empty() && t >= 0) changed.instants.push_back(record[static_cast<std::size_t>(t)]);
  });
  std::sort(changed.ids.begin(), changed.ids.end());
  return changed;
}

std::shared_ptr<const Scene> StoredTable::objects(std::span<const std::int64_t> ids, const LegTimes& times) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  auto scene = std::make_shared<Scene>();
  scene->name = name(), scene->layout = layout(), scene->legs_during = times;
  for (const std::int64_t id : ids) {
    const std::span<const double> record = table_.store->find(id, statement_state_);
    if (!record.empty()) add_object(*table_.store, id, record, statement_state_, *scene);
  }
  scene->take_forms(table_.store->forms(), connection_.interrupt());
  return scene;
}

JoinedTables sources_of(Connection& connection, const OpenTables& tables) {
  JoinedTables sources{std::make_shared<StoredTable>(connection, tables.a)};
  if (tables.b)
    sources.b = tables.are_one() ? sources.a : std::make_shared<StoredTable>(connection, *tables.b);
  return sources;
}

JoinResources resources_of(Connection& connection) {
  return {connection.interrupt(), connection.grid_space(), connection.helper_threads()};
}

}  // namespace foresee
