#include "sqlite/connection.h"

#include "base/float_environment.h"
#include "query/join/pair_kinds.h"
#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

std::size_t memory_of(const Scene& scene) {
  const std::size_t of_kinds = scene.kinds ? scene.kinds->of.size() * sizeof(Kinds) +
                                                 (scene.kinds->active ? memory_of(*scene.kinds->active) : 0)
                                           : 0;
  return of_kinds + scene.first_rows.size() * sizeof(std::uint32_t) +
         scene.ids.size() * sizeof(std::int64_t) + scene.rows.size() * sizeof(double) +
         (scene.forms ? scene.forms->memory() : 0);
}

}  // namespace

void add_object(Store& store, std::int64_t id, std::span<const double> record, Scene& scene) {
  if (!has_plan(store.format().at, record.data())) return scene.add(id, record.data());
  const std::vector<double> own(record.begin(), record.end());  // the store may reuse its memory
  std::vector<Leg> legs;
  store.read_legs(id, own, scene.legs_during.from, scene.legs_during.until, legs);
  if (!legs.empty()) scene.add(id, own.data(), legs);
}

std::int64_t Connection::announce(std::shared_ptr<Store> store, const std::string& schema,
                                  const std::string& table) {
  const std::int64_t number = last_number_ + 1;
  tables_.emplace(number, OpenTable{std::move(store), schema, table, number});
  return last_number_ = number;
}

void Connection::rename(std::int64_t number, const std::string& table) {
  OpenTable& open = tables_.at(number);
  open.table = table;
  scenes_.erase(open.store.get());  // a scene carries its table's name
}

void Connection::leave(std::int64_t number) noexcept {
  finalize();  // a command or a watch of this table may have prepared statements
  const auto open = tables_.find(number);
  if (open == tables_.end()) return;
  scenes_.erase(open->second.store.get());
  tables_.erase(open);
}

void Connection::finalize() noexcept {
  lookups_.finalize();
  interrupt_.finalize();
  if (watches_) watches_->finalize();
}

const OpenTable* Connection::find(std::int64_t number) const {
  const auto open = tables_.find(number);
  return open == tables_.end() ? nullptr : &open->second;
}

std::string Connection::other_schema(const std::string& table, const std::string& schema) const {
  for (const auto& [number, open] : tables_)
    if (open.store && same_name(open.table, table) && !same_name(open.schema, schema)) return open.schema;
  return "";
}

double Connection::likely_objects(const TableName& name) const {
  const auto matches = [](const std::optional<std::string>& wanted, const std::string& open) {
    return !wanted || sqlite3_stricmp(wanted->c_str(), open.c_str()) == 0;
  };
  std::optional<std::int64_t> largest;
  for (const auto& [number, open] : tables_)
    if (open.store && matches(name.table, open.table) && matches(name.schema, open.schema))
      largest = std::max(largest.value_or(0), open.store->likely_objects());
  return static_cast<double>(largest.value_or(ObjectCount().likely()));
}

void Connection::scan_closed(const Store* store, TableCursor& cursor) noexcept {
  const auto open = cursors_.find(store);
  std::erase(open->second, &cursor);
  if (open->second.empty()) cursors_.erase(open);
}

std::span<TableCursor* const> Connection::cursors(const Store* store) const noexcept {
  const auto open = cursors_.find(store);
  if (open == cursors_.end()) return {};
  return open->second;
}

std::shared_ptr<const Scene> Connection::find_scene(const OpenTable& table, bool with_levels,
                                                    const LegTimes& times,
                                                    const std::optional<Kinds>& others) {
  const ContentVersion version = table.store->read_version();
  const auto cached = scenes_.find(table.store.get());
  if (cached == scenes_.end() || cached->second.version != version ||
      (with_levels && !cached->second.scene->levels) || !cached->second.scene->legs_during.cover(times) ||
      (cached->second.others && cached->second.others != others))
    return nullptr;
  cached->second.used = ++last_use_;
  return cached->second.scene;
}

std::shared_ptr<const Scene> Connection::load_scene(const OpenTable& table, bool with_levels,
                                                    std::optional<Kinds> others) {
  if (table.store->declaration().layout.has_plan) return load_legs(table);
  if (auto scene = find_scene(table, with_levels, {}, others)) return scene;
  const ContentVersion version = table.store->read_version();
  const auto cached = scenes_.find(table.store.get());
  if (cached != scenes_.end()) {
    // Queries of different kinds alternate: one scene of all objects serves them all.
    if (cached->second.version == version && cached->second.others != others) others.reset();
    scenes_.erase(cached);  // before the new one is decoded, so that memory holds only one
  }
  std::optional<KindTest> wanted;
  if (others) wanted = KindTest::of_partners(*others);
  auto scene = std::make_shared<Scene>();
  scene->name = table.table;
  scene->layout = table.store->declaration().layout;
  const FloatEnvironment environment;  // accelerations are computed on loading
  if (with_levels) {
    TreeScene tree = read_tree(*table.store->take_snapshot(), interrupt_, wanted);
    scene->ids = std::move(tree.ids), scene->rows = std::move(tree.rows);
    scene->levels = std::move(tree.levels);
    if (tree.complete) others.reset(), table.store->expect_objects(scene->ids.size());
  } else if (table.store->read_all(scene->ids, scene->rows, interrupt_, wanted)) {
    others.reset();
  }
  scene->take_forms(table.store->forms(), interrupt_);
  keep_scene(table, version, scene, others);
  return scene;
}

std::shared_ptr<const Scene> Connection::load_legs(const OpenTable& table, const LegTimes& times) {
  if (!table.store->declaration().layout.has_plan) return load_scene(table);
  if (auto scene = find_scene(table, false, times)) return scene;
  const ContentVersion version = table.store->read_version();
  scenes_.erase(table.store.get());  // before the new one is decoded, so that memory holds only one
  auto scene = std::make_shared<Scene>();
  scene->name = table.table;
  scene->layout = table.store->declaration().layout;
  scene->legs_during = times;
  const FloatEnvironment environment;
  table.store->read_objects(
      times.from, times.until,
      [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
        scene->add(id, record.data(), legs);
      },
      interrupt_);
  scene->take_forms(table.store->forms(), interrupt_);
  keep_scene(table, version, scene);
  return scene;
}

void Connection::keep_scene(const OpenTable& table, const ContentVersion& version,
                            std::shared_ptr<const Scene> scene, const std::optional<Kinds>& others) {
  scenes_[table.store.get()] = {version, std::move(scene), ++last_use_, others};
  evict_scenes();
}

std::shared_ptr<Scene> Connection::load_object(const OpenTable& table, std::int64_t id,
                                               const LegTimes& times) {
  auto scene = std::make_shared<Scene>();
  scene->legs_during = times;
  scene->name = table.table;
  scene->layout = table.store->declaration().layout;
  const FloatEnvironment environment;  // accelerations are computed on loading
  if (const auto record = table.store->read(id)) add_object(*table.store, id, *record, *scene);
  return scene;
}

void Connection::evict_scenes() noexcept {
  std::size_t held = 0;
  for (const auto& [store, cached] : scenes_) held += memory_of(*cached.scene);
  while (held > scene_memory_ && scenes_.size() > 1) {
    const auto oldest = std::min_element(scenes_.begin(), scenes_.end(), [](const auto& a, const auto& b) {
      return a.second.used < b.second.used;
    });
    held -= memory_of(*oldest->second.scene);
    scenes_.erase(oldest);
  }
}

}  // namespace foresee
