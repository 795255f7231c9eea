#include "query/memory_table.h"

#include "base/float_environment.h"
#include "index/tpr_tree/node.h"
#include "index/tpr_tree/search/tree_join.h"

namespace foresee {

MemoryTable::MemoryTable(std::string name, const Layout& layout, double horizon)
    : name_(std::move(name)), pages_(layout), tree_(make_tpr_tree(pages_, horizon)) {}

void MemoryTable::changed(std::int64_t id) {
  changed_ids_.insert(id);
  ++stamp_;
  all_.reset();
}

void MemoryTable::put(std::int64_t id, std::span<const double> record) {
  if (!tree_->update(id, record)) tree_->insert(id, record);
  changed(id);
}

bool MemoryTable::erase(std::int64_t id) {
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

std::shared_ptr<const Scene> MemoryTable::all(bool) {
  if (all_) return all_;
  NeverInterrupt never;
  const FloatEnvironment environment;  // accelerations are computed on loading
  TreeScene tree = read_tree(pages_, never);
  auto scene = std::make_shared<Scene>();
  scene->name = name_, scene->layout = layout();
  scene->ids = std::move(tree.ids), scene->rows = std::move(tree.rows);
  scene->levels = std::move(tree.levels);
  return all_ = scene;
}

const double* MemoryTable::find(std::int64_t id) {
  const auto number = pages_.find_leaf(id);
  if (!number) return nullptr;
  const std::shared_ptr<const Node> leaf = pages_.read(*number);  // the pages keep it
  return leaf->values.data() + slot_of(*leaf, id) * static_cast<std::size_t>(record_offsets(layout()).size);
}

std::shared_ptr<const Scene> MemoryTable::objects(std::span<const std::int64_t> ids) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  auto scene = std::make_shared<Scene>();
  scene->name = name_, scene->layout = layout();
  for (const std::int64_t id : ids)
    if (const double* record = find(id)) scene->add(id, record);
  return scene;
}

ChangedObjects MemoryTable::changes_since(const std::optional<std::int64_t>& stamp) {
  ChangedObjects changed;
  changed.reported = stamp && (*stamp == committed_ || *stamp == stamp_);
  if (!changed.reported || *stamp == stamp_) return changed;
  const int t = record_offsets(layout()).t;
  for (const std::int64_t id : changed_ids_) {
    changed.ids.push_back(id);
    const double* record = find(id);
    if (record && t >= 0) changed.instants.push_back(record[t]);
  }
  return changed;
}

}  // namespace foresee
