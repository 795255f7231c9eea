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

struct ReadScene {
  std::shared_ptr<const Scene> scene;
  bool is_complete;  ///< no object was left out by its kind
};

/// Reads the objects that are needed: the legs of plans, rows with the tree's levels, or rows alone.
ReadScene read_scene(const OpenTable& table, const SceneNeeds& needs, Interrupt& interrupt) {
  Store& store = *table.store;
  auto scene = std::make_shared<Scene>();
  scene->name = table.table;
  scene->layout = store.declaration().layout;
  scene->legs_during = needs.times;
  std::optional<KindTest> wanted;
  if (needs.partner_kinds) wanted = KindTest::of_partners(*needs.partner_kinds);
  const FloatEnvironment environment;  // accelerations are computed on loading
  bool is_complete = true;
  if (scene->layout.has_plan) {
    const auto add = [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
      scene->add(id, record.data(), legs);
    };
    store.read_objects(needs.times.from, needs.times.until, add, interrupt);
  } else if (needs.with_levels) {
    TreeScene tree = read_tree(*store.take_snapshot(), interrupt, wanted);
    scene->ids = std::move(tree.ids);
    scene->rows = std::move(tree.rows);
    scene->levels = std::move(tree.levels);
    is_complete = tree.complete;
    if (is_complete) store.expect_objects(scene->ids.size());
  } else {
    is_complete = store.read_all(scene->ids, scene->rows, interrupt, wanted);
  }
  scene->take_forms(store.forms(), interrupt);
  return {scene, is_complete};
}

}  // namespace

void add_object(TableReader& store, std::int64_t id, std::span<const double> record,
                StatementReadState& statement_state, Scene& scene) {
  if (!has_plan(store.format().at, record.data())) return scene.add(id, record.data());
  const std::vector<double> own(record.begin(), record.end());  // the store may reuse its memory
  std::vector<Leg> legs;
  store.read_legs(id, own, scene.legs_during, statement_state, legs);
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

bool Connection::is_loaded(const OpenTable& table) const {
  const auto cached = scenes_.find(table.store.get());
  return cached != scenes_.end() && cached->second.version == table.store->read_version() &&
         cached->second.has({});
}

std::shared_ptr<const Scene> Connection::load_scene(const OpenTable& table, SceneNeeds needs) {
  const Store* const store = table.store.get();
  if (table.store->declaration().layout.has_plan) {
    needs.with_levels = false;
    needs.partner_kinds.reset();
  } else {
    needs.times = {};
  }
  const ContentVersion version = table.store->read_version();
  if (const auto cached = scenes_.find(store); cached != scenes_.end()) {
    const bool is_current = cached->second.version == version;
    if (is_current && cached->second.has(needs)) {
      cached->second.used = ++last_use_;
      return cached->second.scene;
    }
    // Queries of different kinds alternate: one scene of all objects serves them all.
    if (is_current && cached->second.partner_kinds != needs.partner_kinds) needs.partner_kinds.reset();
    scenes_.erase(cached);  // before the new one is decoded, so that memory holds only one
  }
  const ReadScene read = read_scene(table, needs, interrupt_);
  if (read.is_complete) needs.partner_kinds.reset();
  scenes_[store] = {version, read.scene, ++last_use_, needs.partner_kinds};
  evict_scenes();
  return read.scene;
}

std::shared_ptr<Scene> Connection::load_object(const OpenTable& table, std::int64_t id,
                                               const LegTimes& times) {
  auto scene = std::make_shared<Scene>();
  scene->legs_during = times;
  scene->name = table.table;
  scene->layout = table.store->declaration().layout;
  const FloatEnvironment environment;  // accelerations are computed on loading
  StatementReadState statement_state;
  if (const auto record = table.store->read(id))
    add_object(*table.store, id, *record, statement_state, *scene);
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
