#include "query/memory_table.h"

#include "base/float_environment.h"
#include "index/tpr_tree/node.h"
#include "index/tpr_tree/search/tree_join.h"
#include "shape/chunk_item.h"

namespace foresee {

MemoryTable::MemoryTable(std::string name, const Layout& layout, double horizon)
    : name_(std::move(name)), pages_(layout), tree_(make_tpr_tree(pages_, horizon)) {
  if (!layout.has_plan) return;
  plans_ =
      std::make_unique<MemoryPlans>(layout, horizon, [this](std::int64_t id) { return find_record(id); });
}

void MemoryTable::changed(std::int64_t id) {
  changed_ids_.insert(id);
  ++stamp_;
  all_.reset();
}

void MemoryTable::put(std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
  std::vector<double> head;
  if (plans_) {
    if (const auto before = find_record(id); !before.empty()) plans_->erase(before);
    head.assign(record.begin(), record.end());
    if (!legs.empty()) write_leg(record_offsets(layout()), layout().axes, legs[0], head.data());
    plans_->put(id, head, legs);
    record = head;
  }
  if (!tree_->update(id, record)) tree_->insert(id, record);
  changed(id);
}

bool MemoryTable::erase(std::int64_t id) {
  if (plans_)
    if (const auto record = find_record(id); !record.empty()) plans_->erase(record);
  if (!tree_->erase(id)) return false;
  changed(id);
  return true;
}

void MemoryTable::commit() {
  changed_ids_.clear();
  committed_ = stamp_;
}

double MemoryTable::newest_t() {
  return read_newest_t(pages_);
}

std::shared_ptr<const Scene> MemoryTable::all(const SceneNeeds& needs) {
  if (plans_ && !needs.times.cover({})) return read_objects(needs.times);
  if (all_) return all_;
  if (plans_) return all_ = read_objects({});
  NeverInterrupt never;
  const FloatEnvironment environment;  // accelerations are computed on loading
  TreeScene tree = read_tree(pages_, never);
  auto scene = std::make_shared<Scene>();
  scene->name = name_, scene->layout = layout();
  scene->ids = std::move(tree.ids), scene->rows = std::move(tree.rows);
  scene->levels = std::move(tree.levels);
  return all_ = scene;
}

std::span<const double> MemoryTable::find_record(std::int64_t id) {
  const double* record = find(id);
  const auto size = static_cast<std::size_t>(record_offsets(pages_.layout()).size);
  return record ? std::span(record, size) : std::span<const double>();
}

std::shared_ptr<const Scene> MemoryTable::read_objects(const LegTimes& times) {
  NeverInterrupt never;
  const FloatEnvironment environment;
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(pages_, ids, records, never);
  const auto size = static_cast<std::size_t>(record_offsets(layout()).size);
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

const double* MemoryTable::find(std::int64_t id) {
  const auto number = pages_.find_leaf(id);
  if (!number) return nullptr;
  const std::shared_ptr<const Node> leaf = pages_.read(*number);  // the pages keep it
  return leaf->values.data() + slot_of(*leaf, id) * static_cast<std::size_t>(record_offsets(layout()).size);
}

std::shared_ptr<const Scene> MemoryTable::objects(std::span<const std::int64_t> ids, const LegTimes& times) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  auto scene = std::make_shared<Scene>();
  scene->name = name_;
  scene->layout = layout();
  scene->legs_during = times;
  std::vector<Leg> legs;
  for (const std::int64_t id : ids) {
    const double* record = find(id);
    if (!record) continue;
    if (!plans_) {
      scene->add(id, record);
      continue;
    }
    plans_->read_legs(find_record(id), legs);
    scene->add(id, record, legs);
  }
  return scene;
}

ChangedObjects MemoryTable::changes_since(const std::optional<std::int64_t>& stamp) {
  ChangedObjects changed;
  changed.are_known = stamp && (*stamp == committed_ || *stamp == stamp_);
  if (!changed.are_known || *stamp == stamp_) return changed;
  const int t = record_offsets(layout()).t;
  for (const std::int64_t id : changed_ids_) {
    changed.ids.push_back(id);
    const double* record = find(id);
    if (record && t >= 0) changed.instants.push_back(record[t]);
  }
  return changed;
}

}  // namespace foresee
