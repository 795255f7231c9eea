#include "storage/id_changes.h"

#include <algorithm>

namespace foresee {

const std::int64_t* IdChanges::slot(std::int64_t id) const noexcept {
  if (!ascending_.empty() && id <= ascending_.back().id) {
    if (ascending_.back().id == id) return &ascending_.back().leaf;
    const auto at = std::lower_bound(ascending_.begin(), ascending_.end(), id,
                                     [](const IdChange& change, std::int64_t id) { return change.id < id; });
    if (at->id == id) return &at->leaf;
  }
  if (others_.empty()) return nullptr;
  const auto other = others_.find(id);
  return other == others_.end() ? nullptr : &other->second;
}

std::int64_t IdChanges::find(std::int64_t id) const noexcept {
  const std::int64_t* leaf = slot(id);
  return leaf ? *leaf : unknown;
}

void IdChanges::prepare(std::int64_t id) {
  if (slot(id)) return;
  if (ascending_.empty() || ascending_.back().id < id)
    ascending_.push_back({id, unknown});
  else
    others_.emplace(id, unknown);
}

void IdChanges::set(std::int64_t id, std::int64_t leaf) noexcept {
  *const_cast<std::int64_t*>(slot(id)) = leaf;
}

void IdChanges::clear() noexcept {
  ascending_.clear();
  others_.clear();
}

std::vector<IdChange> IdChanges::sorted() const {
  std::vector<IdChange> all = ascending_;
  const auto middle = static_cast<std::ptrdiff_t>(all.size());
  for (const auto& [id, leaf] : others_) all.push_back({id, leaf});
  const auto by_id = [](const IdChange& a, const IdChange& b) { return a.id < b.id; };
  std::sort(all.begin() + middle, all.end(), by_id);
  std::inplace_merge(all.begin(), all.begin() + middle, all.end(), by_id);
  std::erase_if(all, [](const IdChange& change) { return change.leaf == unknown; });
  return all;
}

}  // namespace foresee
