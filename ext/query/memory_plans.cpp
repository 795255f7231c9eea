// The trees of a table in memory: that of its objects, and that of the chunks of their plans.
#include <algorithm>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/node.h"
#include "motion/plan/chunks.h"
#include "query/memory_table.h"
#include "shape/chunk_item.h"

namespace foresee {

PendingTree::PendingTree(const Layout& layout, double horizon)
    : pages_(layout),
      tree_(make_tpr_tree(pages_, horizon)),
      record_size_(static_cast<std::size_t>(record_offsets(layout).size)) {}

void PendingTree::put(std::int64_t id, std::span<const double> record) {
  const auto [place, is_new] = slots_.try_emplace(id, ids_.size());
  if (!is_new) {
    std::copy(record.begin(), record.end(), records_.begin() + offset_of(place->second));
    return;
  }
  ids_.push_back(id);
  records_.insert(records_.end(), record.begin(), record.end());
  if (!is_stored(id)) ++size_;
  erased_.erase(id);
}

bool PendingTree::erase(std::int64_t id) {
  const bool stored = is_stored(id);
  const auto place = slots_.find(id);
  if (!stored && place == slots_.end()) return false;
  if (stored) erased_.insert(id);
  if (place != slots_.end()) drop_waiting(place->second);
  --size_;
  return true;
}

/// The last one takes its slot.
void PendingTree::drop_waiting(std::size_t slot) {
  slots_[ids_.back()] = slot;
  slots_.erase(ids_[slot]);
  ids_[slot] = ids_.back();
  ids_.pop_back();
  std::copy(records_.end() - offset_of(1), records_.end(), records_.begin() + offset_of(slot));
  records_.resize(records_.size() - record_size_);
}

std::span<const double> PendingTree::find(std::int64_t id) {
  if (const auto place = slots_.find(id); place != slots_.end())
    return std::span(records_).subspan(place->second * record_size_, record_size_);
  const auto number = erased_.contains(id) ? std::nullopt : pages_.find_leaf(id);
  if (!number) return {};
  const std::shared_ptr<const Node> leaf = pages_.read(*number);  // the pages keep it
  return std::span(leaf->values).subspan(slot_of(*leaf, id) * record_size_, record_size_);
}

MemoryPages& PendingTree::pages() {
  if (!ids_.empty() || !erased_.empty()) merge_waiting();
  return pages_;
}

// If more than an eighth has changed, the whole tree is loaded: per object that costs a fraction of a merge, and gives
// a better tree.
void PendingTree::merge_waiting() {
  NeverInterrupt never;
  std::vector<std::int64_t> erased(erased_.begin(), erased_.end());
  std::sort(erased.begin(), erased.end());
  const std::size_t changes = erased.size() + ids_.size();
  const bool loads = 8 * changes > size_;
  if (loads && size_ > 0) {
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    collect_others(ids, records);
    ids.insert(ids.end(), ids_.begin(), ids_.end());
    records.insert(records.end(), records_.begin(), records_.end());
    for (const std::int64_t id : erased) pages_.forget(id);
    tree_->reload(ids, records, never);
  } else {
    constexpr std::size_t any_number = 1 << 20;
    tree_->erase_all(erased, any_number, never);
    tree_->merge(ids_, records_, never);
    const std::int64_t some = ids_.empty() ? erased.front() : ids_.front();
    tree_->repack_dispersed(changes, hash_of(static_cast<std::uint64_t>(some)));
  }
  slots_.clear(), ids_.clear(), records_.clear(), erased_.clear();
}

void PendingTree::collect_others(std::vector<std::int64_t>& ids, std::vector<double>& records) {
  NeverInterrupt never;
  std::vector<std::int64_t> stored;
  std::vector<double> theirs;
  collect_objects(pages_, stored, theirs, never);
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (slots_.contains(stored[i]) || erased_.contains(stored[i])) continue;
    ids.push_back(stored[i]);
    records.insert(records.end(), theirs.begin() + offset_of(i), theirs.begin() + offset_of(i + 1));
  }
}

MemoryPlans::MemoryPlans(const Layout& layout, double horizon, FindRecord find_record)
    : layout_(layout),
      at_(record_offsets(layout)),
      tree_(chunk_layout(layout), horizon),
      find_record_(std::move(find_record)) {}

MemoryPlans::Numbers MemoryPlans::numbers_of(std::span<const double> record) const {
  return {static_cast<std::int64_t>(record[static_cast<std::size_t>(at_.plan)]),
          static_cast<std::int64_t>(record[static_cast<std::size_t>(at_.chunks)])};
}

void MemoryPlans::put(std::int64_t id, std::span<double> record, std::span<const Leg> legs) {
  std::vector<double> item(static_cast<std::size_t>(record_offsets(tree_.layout()).size));
  const std::int64_t first = legs.empty() ? 0 : next_;
  std::size_t count = 0;
  if (!legs.empty())
    for (const ChunkRange& range : cut_into_chunks(legs)) {
      const auto of_chunk = legs.subspan(range.first, range.count);
      write_chunk_item(layout_, record.data(), of_chunk, item.data());
      tree_.put(next_, item);
      chunks_[next_++] = {id, {of_chunk.begin(), of_chunk.end()}};
      ++count;
    }
  record[static_cast<std::size_t>(at_.plan)] = static_cast<double>(first);
  record[static_cast<std::size_t>(at_.chunks)] = static_cast<double>(count);
}

void MemoryPlans::erase(std::span<const double> record) {
  const Numbers numbers = numbers_of(record);
  for (std::int64_t number = numbers.first; number < numbers.first + numbers.count; ++number) {
    tree_.erase(number);
    chunks_.erase(number);
  }
}

void MemoryPlans::read_chunk(std::int64_t number, const LegTimes& times, Chunk& chunk) {
  const OfChunk& of = chunks_.at(number);
  chunk.object = of.object, chunk.record = find_record_(of.object);
  chunk.legs.clear();
  std::copy_if(of.legs.begin(), of.legs.end(), std::back_inserter(chunk.legs),
               [&](const Leg& leg) { return times.meet(leg.t, leg.until); });
}

void MemoryPlans::read_legs(std::span<const double> record, std::vector<Leg>& legs) const {
  legs.clear();
  const Numbers numbers = numbers_of(record);
  for (std::int64_t number = numbers.first; number < numbers.first + numbers.count; ++number) {
    const std::vector<Leg>& more = chunks_.at(number).legs;
    legs.insert(legs.end(), more.begin(), more.end());
  }
}

}  // namespace foresee
