// Writing: first everything that may fail, then what cannot; and the flush.
#include <algorithm>
#include <limits>

#include "storage/store.h"
#include "storage/store_own_statements.h"

namespace foresee {
namespace {

constexpr std::size_t most_pending = 16 << 20;  // bytes; a flush of so many costs far more than starting it

}  // namespace

// What every change begins with. Flushing here, not after the change, keeps the change all or nothing.
void Store::start_change(std::span<const double> record) {
  if (!record.empty())
    if (const char* fault = record_fault(format_, record.data())) throw Error(name_.table + ": " + fault);
  if (!in_transaction_) begin();
  if (pending_.memory(format_) > most_pending) flush();
  if (!stamped_) {
    const OwnStatements own(*this);
    std::int64_t stamp;
    sqlite3_randomness(sizeof stamp, &stamp);
    rows().write_stamp(stamp);
    stamped_ = true;
  }
}

PendingLeaf& Store::fetch(std::int64_t number) {
  if (PendingLeaf* leaf = pending_.find(number)) return *leaf;
  PendingLeaf* fetched = nullptr;
  rows().read_node(number, [&](std::span<const std::byte> blob) {
    require_sound(number, blob);
    fetched = &pending_.add({number, LeafNode(format_, blob), false, true});
  });
  if (!fetched) damaged("node " + std::to_string(number) + " is missing");
  return *fetched;
}

// The newest leaf, or one behind it.
PendingLeaf& Store::leaf_with_room() {
  if (!newest_) {
    const std::int64_t stored = rows().largest_node();
    const std::int64_t pending = pending_.leaves.empty() ? 0 : pending_.leaves.rbegin()->first;
    if (const std::int64_t newest = std::max(stored, pending); newest != 0) newest_ = &fetch(newest);
  }
  if (newest_ && !newest_->leaf.is_full()) return *newest_;
  const std::int64_t before = newest_ ? newest_->number : 0;
  if (before == std::numeric_limits<std::int64_t>::max()) damaged("there is no node number left");
  newest_ = &pending_.add({before + 1, LeafNode(format_), false, false});
  return *newest_;
}

Store::Place Store::place_of(std::int64_t id) {
  const std::optional<std::int64_t> number = leaf_of(id);
  if (!number) throw StoreError(SQLITE_ERROR, name_.table + ": there is no object " + std::to_string(id));
  PendingLeaf& leaf = fetch(*number);
  const int index = leaf.leaf.find(id);
  if (index < 0) damaged("node " + std::to_string(*number) + " lacks object " + std::to_string(id));
  return {&leaf, index};
}

void Store::take_out(const Place& place, std::int64_t id) noexcept {
  place.leaf->leaf.remove(place.index);
  place.leaf->changed = true;
  pending_.ids.set(id, IdChanges::erased);
  --pending_.more;
  if (largest_ == id) largest_exact_ = false;
}

void Store::put_in(PendingLeaf& leaf, std::int64_t id, const double* record) noexcept {
  leaf.leaf.put(id, record);
  leaf.changed = true;
  pending_.ids.set(id, leaf.number);
  ++pending_.more;
  if (!largest_ || *largest_ <= id) {
    largest_ = id;
    largest_exact_ = true;
  }
}

// Requires: nothing is pending about the map, or the answer is known.
const std::optional<std::int64_t>& Store::largest_id() {
  if (!largest_known_) {
    largest_ = rows().largest_id();
    largest_known_ = largest_exact_ = true;
  }
  return largest_;
}

std::int64_t Store::next_id() {
  if (!largest_known_ || !largest_exact_) {
    flush();
    largest_known_ = false;
  }
  const std::optional<std::int64_t>& largest = largest_id();
  if (!largest) return 1;
  if (*largest < std::numeric_limits<std::int64_t>::max()) return *largest + 1;
  for (int attempt = 0; attempt < 100; ++attempt) {  // as SQLite does
    std::int64_t id;
    sqlite3_randomness(sizeof id, &id);
    id &= std::numeric_limits<std::int64_t>::max() >> 1;
    if (!contains(++id)) return id;
  }
  throw StoreError(SQLITE_FULL, name_.table + ": there is no id left");
}

void Store::insert(std::int64_t id, std::span<const double> record, std::span<sqlite3_value*> auxiliaries) {
  start_change(record);
  PendingLeaf& leaf = leaf_with_room();
  pending_.ids.prepare(id);
  if (has_auxiliaries()) {
    const OwnStatements own(*this);
    rows().insert_auxiliaries(id, auxiliaries);
  }
  put_in(leaf, id, record.data());
  changed_ = true;
}

void Store::update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
                   std::span<sqlite3_value*> auxiliaries) {
  start_change(record);
  const Place place = place_of(id);
  const bool replaces = new_id != id && contains(new_id);
  const Place replaced = replaces ? place_of(new_id) : Place{nullptr, -1};
  if (new_id != id) {
    pending_.ids.prepare(id);
    pending_.ids.prepare(new_id);
  }
  if (has_auxiliaries()) {
    const OwnStatements own(*this);
    rows().update_auxiliaries(id, new_id, auxiliaries);
  }
  changed_ = true;
  if (new_id == id) {
    place.leaf->leaf.replace(place.index, record.data());
    place.leaf->changed = true;
    return;
  }
  if (replaces) take_out(replaced, new_id);
  take_out({place.leaf, place.leaf->leaf.find(id)}, id);
  put_in(*place.leaf, new_id, record.data());
}

void Store::erase(std::int64_t id) {
  start_change({});
  const Place place = place_of(id);
  pending_.ids.prepare(id);
  if (has_auxiliaries()) {
    const OwnStatements own(*this);
    rows().erase_auxiliaries(id);
  }
  take_out(place, id);
  changed_ = true;
}

// If it fails half-way everything stays pending: writing the same again does no harm.
void Store::flush() {
  if (pending_.leaves.empty()) return;
  {
    const OwnStatements own(*this);
    for (auto& [number, pending] : pending_.leaves) {
      if (!pending.changed) continue;
      if (pending.leaf.count() > 0)
        rows().write_node(number, pending.leaf.sealed(number));
      else if (pending.stored)
        rows().erase_node(number);
    }
    pending_.map_half_written = true;
    rows().write_map(pending_.ids.sorted());
  }
  pending_.clear();
  newest_ = nullptr;
}

}  // namespace foresee
