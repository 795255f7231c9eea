#include "query/memory_table.h"

#include <cmath>

#include "base/float_environment.h"
#include "base/number_text.h"
#include "index/tpr_tree/search/tree_join.h"
#include "shape/chunk_item.h"
#include "shape/kinds.h"

namespace foresee {
namespace {

/// The layout, if a table in memory can have it.
const Layout& accepted(const std::string& name, const Layout& layout, double horizon) {
  require_layout(name, layout);
  if (is_stored_apart(layout.shape))
    throw Error(name + ": a table in memory has no outlines and no meshes; fill a Scene, or use a database");
  require_not_negative("horizon", horizon);
  return layout;
}

}  // namespace

std::vector<double> record_of(const Layout& layout,
                              std::initializer_list<std::pair<std::string_view, double>> numbers) {
  require_layout("record_of", layout);
  const Offsets at = record_offsets(layout);
  std::vector<double> record(static_cast<std::size_t>(at.size));
  const auto preset = [&](int place, double number) {
    if (place != Offsets::absent) record[static_cast<std::size_t>(place)] = number;
  };
  preset(at.until, no_end);
  preset(at.mass, 1);
  preset(at.category, Kinds().category);
  preset(at.mask, Kinds().mask);
  const std::vector<NumberColumn> columns = number_columns(layout, at);
  for (const auto& given : numbers) {
    const auto has_name = [&](const NumberColumn& column) { return column.name == given.first; };
    const auto column = std::find_if(columns.begin(), columns.end(), has_name);
    if (column == columns.end())
      throw Error("record_of: the layout has no '" + std::string(given.first) + "'");
    record[static_cast<std::size_t>(column->place)] = given.second;
  }
  return record;
}

MemoryTable::MemoryTable(std::string name, const Layout& layout, double horizon)
    : name_(std::move(name)),
      objects_(accepted(name_, layout, horizon), horizon),
      at_(record_offsets(layout)),
      columns_(number_columns(layout, at_)) {
  if (!layout.has_plan) return;
  plans_ =
      std::make_unique<MemoryPlans>(layout, horizon, [this](std::int64_t id) { return objects_.find(id); });
}

void MemoryTable::changed(std::int64_t id) {
  changed_ids_.insert(id);
  ++stamp_;
  all_.reset();
}

void MemoryTable::reject(std::int64_t id, const std::string& what) const {
  throw Error(name_ + ": row " + std::to_string(id) + ": " + what);
}

void MemoryTable::require_legs(std::int64_t id, std::span<const Leg> legs) const {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    const auto are_finite = [](const std::array<double, 3>& numbers) {
      return std::isfinite(numbers[0]) && std::isfinite(numbers[1]) && std::isfinite(numbers[2]);
    };
    const auto reject_leg = [&](const std::string& what) {
      reject(id, "leg " + std::to_string(i + 1) + what);
    };
    if (!std::isfinite(leg.t) || !are_finite(leg.x) || !are_finite(leg.v) || !are_finite(leg.a))
      reject_leg(" has a number that is not finite; write finite numbers");
    if (!(leg.until >= leg.t)) reject_leg(" ends at " + shown(leg.until) + "; it starts at " + shown(leg.t));
    if (i > 0 && leg.t < legs[i - 1].until)
      reject_leg(" starts at " + shown(leg.t) + "; the one before ends at " + shown(legs[i - 1].until));
  }
}

void MemoryTable::put(std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
  if (const auto size = static_cast<std::size_t>(at_.size); record.size() != size)
    reject(id, "a record has " + std::to_string(size) + " numbers, not " + std::to_string(record.size()));
  if (!legs.empty() && !plans_) reject(id, "it has legs; declare has_plan in the layout");
  require_legs(id, legs);
  std::vector<double> head;
  if (!legs.empty()) {
    head.assign(record.begin(), record.end());
    write_leg(at_, layout().axes, legs[0], head.data());
    record = head;
  }
  require_numbers(name_, id, columns_, at_, record.data());
  if (plans_) {
    if (const auto before = objects_.find(id); !before.empty()) plans_->erase(before);
    head.assign(record.begin(), record.end());
    plans_->put(id, head, legs);
    record = head;
  }
  objects_.put(id, record);
  changed(id);
}

bool MemoryTable::erase(std::int64_t id) {
  if (plans_)
    if (const auto record = objects_.find(id); !record.empty()) plans_->erase(record);
  if (!objects_.erase(id)) return false;
  changed(id);
  return true;
}

void MemoryTable::commit() {
  changed_ids_.clear();
  committed_ = stamp_;
}

double MemoryTable::newest_t() {
  return read_newest_t(objects_.pages());
}

std::shared_ptr<const Scene> MemoryTable::all(const SceneNeeds& needs) {
  if (plans_ && !needs.times.cover({})) return read_objects(needs.times);
  if (all_) return all_;
  if (plans_) return all_ = read_objects({});
  NeverInterrupt never;
  const FloatEnvironment environment;  // accelerations are computed on loading
  TreeScene tree = read_tree(objects_.pages(), never);
  auto scene = std::make_shared<Scene>();
  scene->name = name_, scene->layout = layout();
  scene->ids = std::move(tree.ids), scene->rows = std::move(tree.rows);
  scene->levels = std::move(tree.levels);
  return all_ = scene;
}

std::shared_ptr<const Scene> MemoryTable::read_objects(const LegTimes& times) {
  NeverInterrupt never;
  const FloatEnvironment environment;
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(objects_.pages(), ids, records, never);
  const auto size = static_cast<std::size_t>(at_.size);
  auto scene = std::make_shared<Scene>();
  scene->name = name_;
  scene->layout = layout();
  scene->legs_during = times;
  std::vector<Leg> legs;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto record = std::span(records).subspan(i * size, size);
    plans_->read_legs(record, legs);
    scene->add(ids[i], record.data(), legs);
  }
  return scene;
}

std::shared_ptr<const Scene> MemoryTable::objects(std::span<const std::int64_t> ids, const LegTimes& times) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  auto scene = std::make_shared<Scene>();
  scene->name = name_;
  scene->layout = layout();
  scene->legs_during = times;
  std::vector<Leg> legs;
  for (const std::int64_t id : ids) {
    const std::span<const double> record = objects_.find(id);
    if (record.empty()) continue;
    if (!plans_) {
      scene->add(id, record.data());
      continue;
    }
    plans_->read_legs(record, legs);
    scene->add(id, record.data(), legs);
  }
  return scene;
}

ChangedObjects MemoryTable::changes_since(const std::optional<std::int64_t>& stamp) {
  ChangedObjects changed;
  changed.are_known = stamp && (*stamp == committed_ || *stamp == stamp_);
  if (!changed.are_known || *stamp == stamp_) return changed;
  for (const std::int64_t id : changed_ids_) {
    changed.ids.push_back(id);
    const std::span<const double> record = objects_.find(id);
    if (!record.empty() && at_.t != Offsets::absent)
      changed.instants.push_back(record[static_cast<std::size_t>(at_.t)]);
  }
  return changed;
}

}  // namespace foresee
