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
  constexpr std::size_t per_erased = 100;  // until the tree has erased all of them
  return (now_.ids.size() + now_.leaves.size()) * sizeof(std::int64_t) +
         now_.records.size() * sizeof(double) + now_.erased.size() * per_erased + now_.slots.memory() +
         log_.size() * sizeof(Change);
}

const double* PendingObjects::find(std::int64_t id) const noexcept {
  const std::int64_t slot = now_.slots.find(id);
  return slot < 0 ? nullptr : record_at(static_cast<std::size_t>(slot)).data();
}

std::vector<std::int64_t> PendingObjects::erased_ids() const {
  std::vector<std::int64_t> ids;
  std::copy_if(now_.erased.begin(), now_.erased.end(), std::back_inserter(ids),
               [this](std::int64_t id) { return is_erased(id); });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

void PendingObjects::reserve(std::int64_t id, std::int64_t leaf, std::size_t changes) {
  join();
  reserve_more(now_.ids, 1);
  reserve_more(now_.records, record_size_);
  if (leaf != 0 || !now_.leaves.empty()) reserve_more(now_.leaves, now_.ids.size() + 1 - now_.leaves.size());
  reserve_more(log_, changes);
  now_.slots.prepare(id);
}

void PendingObjects::add(std::int64_t id, std::span<const double> record, std::int64_t leaf) {
  reserve(id, leaf, 1);
  const std::size_t slot = now_.ids.size();
  const auto kind = is_erased(id) ? Change::Kind::added_again : Change::Kind::added;
  if (leaf != 0 || !now_.leaves.empty()) {
    now_.leaves.resize(slot);
    now_.leaves.push_back(leaf);
  }
  now_.ids.push_back(id);
  now_.records.insert(now_.records.end(), record.begin(), record.end());
  if (is_marked()) log_.push_back({kind, static_cast<std::uint32_t>(slot)});
  now_.slots.set(id, static_cast<std::int64_t>(slot));
  ++now_.count;
}

void PendingObjects::erase(std::int64_t id) {
  join();
  reserve_more(log_, 1);
  if (is_marked()) log_.push_back({Change::Kind::erased, static_cast<std::uint32_t>(now_.slots.find(id))});
  now_.slots.set(id, IdHashMap::unknown);
  --now_.count;
}

void PendingObjects::erase_stored(std::int64_t id) {
  join();
  reserve_more(now_.erased, 1);
  reserve_more(log_, 1);
  now_.slots.prepare(id);
  now_.erased.push_back(id);
  if (is_marked()) log_.push_back({Change::Kind::stored_erased});
  now_.slots.set(id, erased);
}

void PendingObjects::replace(std::int64_t id, std::span<const double> record) {
  const std::int64_t leaf = leaf_of(id);
  reserve(id, leaf, 2);
  erase(id);
  add(id, record, leaf);
}

void PendingObjects::remove_all() {
  join();
  Objects none;
  if (is_marked()) {
    reserve_more(log_, 1);
    reserve_more(removed_, 1);
    log_.push_back({Change::Kind::all_removed});
    removed_.push_back(std::move(now_));
  }
  now_ = std::move(none);
}

// Objects that were all added and removed after the newest mark left are gone: a statement that inserts millions of
// rows would keep them all.
void PendingObjects::merge(std::size_t /*newer*/) noexcept {
  const auto removes_all = [](const Change& change) { return change.kind == Change::Kind::all_removed; };
  if (log_.empty() || !removes_all(log_.back())) return;
  std::size_t newest = 0;
  for_each_position([&](std::size_t position) { newest = std::max(newest, position); });
  if (newest == log_.size()) return;
  const auto mark = log_.rend() - static_cast<std::ptrdiff_t>(newest);
  const auto since = std::find_if(std::next(log_.rbegin()), mark, removes_all).base();
  std::size_t added = 0, stored_erased = 0;
  std::for_each(since, log_.end(), [&](const Change& change) {
    added += change.kind == Change::Kind::added || change.kind == Change::Kind::added_again;
    stored_erased += change.kind == Change::Kind::stored_erased;
  });
  if (added != removed_.back().ids.size() || stored_erased != removed_.back().erased.size()) return;
  log_.erase(since, log_.end());
  removed_.pop_back();
}

// Drops the holes too, if they are the larger part.
void PendingObjects::forget() noexcept {
  log_.clear();
  removed_.clear();
  constexpr std::size_t few = 64;
  if (now_.ids.size() < few || now_.ids.size() < 2 * now_.count + now_.erased.size()) return;
  try {
    Objects fresh;
    for (const std::int64_t id : erased_ids()) {
      fresh.erased.push_back(id);
      fresh.slots.prepare(id);
      fresh.slots.set(id, erased);
    }
    for_each([&](std::int64_t id, std::span<const double> record) {
      if (!now_.leaves.empty()) fresh.leaves.push_back(leaf_of(id));
      fresh.slots.prepare(id);
      fresh.slots.set(id, static_cast<std::int64_t>(fresh.count++));
      fresh.ids.push_back(id);
      fresh.records.insert(fresh.records.end(), record.begin(), record.end());
    });
    now_ = std::move(fresh);
  } catch (const std::bad_alloc&) {
    // Without memory for a copy the holes stay, which is also correct.
  }
}

void PendingObjects::end(Journal::Ended) noexcept {
  log_.clear();
  removed_.clear();
  now_.ids.clear();
  now_.records.clear();
  now_.leaves.clear();
  now_.erased.clear();
  now_.slots.clear();
  now_.count = 0;
}

void PendingObjects::rewind(std::size_t position) noexcept {
  for (; log_.size() > position; log_.pop_back()) undo(log_.back());
}

void PendingObjects::undo(const Change& change) noexcept {
  switch (change.kind) {
    case Change::Kind::all_removed:
      now_ = std::move(removed_.back());
      removed_.pop_back();
      return;
    case Change::Kind::stored_erased:
      now_.slots.set(now_.erased.back(), IdHashMap::unknown);
      now_.erased.pop_back();
      return;
    case Change::Kind::erased:
      now_.slots.set(now_.ids[change.slot], change.slot);
      ++now_.count;
      return;
    case Change::Kind::added:
    case Change::Kind::added_again:
      now_.slots.set(now_.ids[change.slot], change.kind == Change::Kind::added ? IdHashMap::unknown : erased);
      --now_.count;
      now_.ids.pop_back();
      now_.records.resize(now_.records.size() - record_size_);
      now_.leaves.resize(std::min(now_.leaves.size(), now_.ids.size()));
  }
}

}  // namespace foresee
