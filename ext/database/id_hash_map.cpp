#include "database/id_hash_map.h"

#include <algorithm>
#include <utility>

#include "base/repeatable_choice.h"
#include "database/sqlite_api.h"

namespace foresee {

IdHashMap::IdHashMap() {
  sqlite3_randomness(sizeof key_, &key_);
}

std::size_t IdHashMap::home_of(std::int64_t id) const noexcept {
  return hash_of(static_cast<std::uint64_t>(id) ^ key_) & (slots_.size() - 1);
}

// The slot of `id`, or the free slot where it belongs.
std::size_t IdHashMap::slot_of(std::int64_t id) const noexcept {
  std::size_t slot = home_of(id);
  while (slots_[slot].value != free_slot && slots_[slot].id != id) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

std::int64_t IdHashMap::find(std::int64_t id) const noexcept {
  if (size_ == 0) return unknown;
  const Entry& entry = slots_[slot_of(id)];
  return entry.value == free_slot ? unknown : entry.value;
}

void IdHashMap::prepare(std::int64_t id) {
  if (2 * (size_ + 1) > slots_.size()) grow();
  Entry& entry = slots_[slot_of(id)];
  if (entry.value != free_slot) return;
  entry = {id, unknown};
  ++size_;
}

void IdHashMap::grow() {
  std::vector<Entry> old(std::max<std::size_t>(16, 2 * slots_.size()), Entry{0, free_slot});
  slots_.swap(old);
  for (const Entry& entry : old)
    if (entry.value != free_slot) slots_[slot_of(entry.id)] = entry;
}

void IdHashMap::set(std::int64_t id, std::int64_t value) noexcept {
  if (size_ == 0) return;
  Entry& entry = slots_[slot_of(id)];
  if (entry.value == free_slot) return;
  known_ += static_cast<std::size_t>(value != unknown) - static_cast<std::size_t>(entry.value != unknown);
  entry.value = value;
}

std::int64_t IdHashMap::exchange(std::int64_t id, std::int64_t value) {
  if (2 * (size_ + 1) > slots_.size()) grow();
  Entry& entry = slots_[slot_of(id)];
  if (entry.value == free_slot) {
    ++size_;
    entry = {id, unknown};
  }
  known_ += static_cast<std::size_t>(value != unknown) - static_cast<std::size_t>(entry.value != unknown);
  return std::exchange(entry.value, value);
}

void IdHashMap::reset() noexcept {
  for (Entry& entry : slots_)
    if (entry.value != free_slot) entry.value = unknown;
  known_ = 0;
}

void IdHashMap::clear() noexcept {
  slots_ = std::vector<Entry>();  // {} would keep the memory
  size_ = known_ = 0;
}

std::vector<IdHashMap::Entry> IdHashMap::known() const {
  std::vector<Entry> all;
  all.reserve(size_);
  for (const Entry& entry : slots_)
    if (entry.value != free_slot && entry.value != unknown) all.push_back(entry);
  return all;
}

}  // namespace foresee
