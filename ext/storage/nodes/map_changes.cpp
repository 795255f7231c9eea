#include "storage/nodes/map_changes.h"

namespace foresee {
namespace {

// Log entries for the old value of stored_is_void_; they belong to no id.
constexpr std::int64_t was_void = -2, was_not_void = -3;

}  // namespace

void MapChanges::set(std::int64_t id, std::int64_t leaf) {
  join();
  leaves_.prepare(id);
  if (is_marked())
    log_.push_back({id, leaves_.find(id)});
  else
    started_empty_ = false;
  leaves_.set(id, leaf);
}

/// Logs everything that is unwritten, and that the stored map was valid or not if that changes.
void MapChanges::log_all(bool voids) {
  join();
  if (!is_marked()) return;
  const std::vector<IdHashMap::Entry> unwritten = leaves_.known();
  log_.reserve(log_.size() + unwritten.size() + 1);
  log_.insert(log_.end(), unwritten.begin(), unwritten.end());
  if (voids || stored_is_void_) log_.push_back({0, stored_is_void_ ? was_void : was_not_void});
}

void MapChanges::void_stored() {
  log_all(true);
  started_empty_ &= is_marked();
  leaves_.reset();
  stored_is_void_ = true;
}

void MapChanges::written() {
  if (!is_marked()) return clear();
  log_all(false);
  stored_is_void_ = false;
  leaves_.reset();
  held_after_writing_ = held();
}

void MapChanges::rewind(std::size_t position) noexcept {
  if (position == 0 && started_empty_) return clear();  // fast path: a bulk load is rolled back
  for (; log_.size() > position; log_.pop_back()) {
    const IdHashMap::Entry& before = log_.back();
    if (before.value == was_void || before.value == was_not_void)
      stored_is_void_ = before.value == was_void;
    else
      leaves_.set(before.id, before.value);
  }
  held_after_writing_ = std::min(held_after_writing_, held());
}

void MapChanges::forget() noexcept {
  log_.clear();
  started_empty_ = !has_unwritten();
  held_after_writing_ = std::min(held_after_writing_, held());
}

void MapChanges::clear() noexcept {
  leaves_.clear();
  log_.clear();
  held_after_writing_ = 0;
  stored_is_void_ = false;
  started_empty_ = true;
}

}  // namespace foresee
