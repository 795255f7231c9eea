#include "query/memory_table.h"

#include "base/float_environment.h"
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
  records_[id].assign(record.begin(), record.end());
  changed(id);
}

bool MemoryTable::erase(std::int64_t id) {
  if (!tree_->erase(id)) return false;
  records_.erase(id);
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

std::shared_ptr<const Scene> MemoryTable::all(bool with_levels) {
  if (all_ && (!with_levels || all_->levels)) return all_;
  std::shared_ptr<Scene> scene;
  if (with_levels) {
    NeverInterrupt never;
    const FloatEnvironment environment;
    TreeScene tree = read_tree(pages_, never);
    scene = std::make_shared<Scene>();
    scene->name = name_, scene->layout = layout();
    scene->ids = std::move(tree.ids), scene->rows = std::move(tree.rows);
    scene->levels = std::move(tree.levels);
    return all_ = scene;
  }
  std::vector<std::int64_t> ids;
  for (const auto& [id, record] : records_) ids.push_back(id);
  return all_ = objects(ids);
}

std::shared_ptr<const Scene> MemoryTable::objects(std::span<const std::int64_t> ids) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  auto scene = std::make_shared<Scene>();
  scene->name = name_, scene->layout = layout();
  for (const std::int64_t id : ids) {
    const auto found = records_.find(id);
    if (found != records_.end()) scene->add(id, found->second.data());
  }
  return scene;
}

ChangedObjects MemoryTable::changes_since(const std::optional<std::int64_t>& stamp) {
  ChangedObjects changed;
  changed.reported = stamp && (*stamp == committed_ || *stamp == stamp_);
  if (!changed.reported || *stamp == stamp_) return changed;
  const int t = record_offsets(layout()).t;
  for (const std::int64_t id : changed_ids_) {
    changed.ids.push_back(id);
    const auto found = records_.find(id);
    if (found != records_.end() && t >= 0)
      changed.instants.push_back(found->second[static_cast<std::size_t>(t)]);
  }
  return changed;
}

}  // namespace foresee
