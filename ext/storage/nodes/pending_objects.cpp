#include "storage/nodes/pending_objects.h"

#include <algorithm>
#include <new>

namespace foresee {
namespace {

template <class T>
void reserve_more(std::vector<T>& values, std::size_t more) {
  if (values.size() + more > values.capacity())
    values.reserve(std::max(values.size() + more, 2 * values.capacity()));
}

}  // namespace

std::size_t PendingObjects::memory() const {
  return ids_.size() * sizeof(std::int64_t) + records_.size() * sizeof(double) + slots_.memory() +
         log_.size() * sizeof(Change);
}

const double* PendingObjects::find(std::int64_t id) const noexcept {
  const std::int64_t slot = slots_.find(id);
  return slot == IdHashMap::unknown ? nullptr
                                    : records_.data() + static_cast<std::size_t>(slot) * record_size_;
}

void PendingObjects::reserve(std::int64_t id, std::size_t changes) {
  reserve_more(ids_, 1);
  reserve_more(records_, record_size_);
  reserve_more(log_, changes);
  slots_.prepare(id);
}

void PendingObjects::add(std::int64_t id, std::span<const double> record) {
  reserve(id, 1);
  const std::size_t slot = ids_.size();
  ids_.push_back(id);
  records_.insert(records_.end(), record.begin(), record.end());
  log_.push_back({static_cast<std::uint32_t>(slot), true});
  slots_.set(id, static_cast<std::int64_t>(slot));
  ++count_;
}

void PendingObjects::erase(std::int64_t id) {
  reserve_more(log_, 1);
  log_.push_back({static_cast<std::uint32_t>(slots_.find(id)), false});
  slots_.set(id, IdHashMap::unknown);
  --count_;
}

void PendingObjects::replace(std::int64_t id, std::span<const double> record) {
  reserve(id, 2);
  erase(id);
  add(id, record);
}

void PendingObjects::forget_past() noexcept {
  log_.clear();
  constexpr std::size_t few = 64;
  if (ids_.size() < few || ids_.size() < 2 * count_) return;
  try {
    PendingObjects fresh(record_size_);
    for_each([&](std::int64_t id, std::span<const double> record) { fresh.add(id, record); });
    fresh.log_.clear();
    *this = std::move(fresh);
  } catch (const std::bad_alloc&) {
    // Without memory for a copy the holes stay, which is also correct.
  }
}

void PendingObjects::clear() noexcept {
  ids_.clear();
  records_.clear();
  slots_.clear();
  log_.clear();
  count_ = 0;
}

void PendingObjects::rewind(std::size_t position) noexcept {
  for (; log_.size() > position; log_.pop_back()) {
    const Change& change = log_.back();
    const std::int64_t id = ids_[change.slot];
    slots_.set(id, change.added ? IdHashMap::unknown : change.slot);
    count_ = change.added ? count_ - 1 : count_ + 1;
    if (!change.added) continue;
    ids_.pop_back();
    records_.resize(records_.size() - record_size_);
  }
}

}  // namespace foresee
