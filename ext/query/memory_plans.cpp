#include <algorithm>

#include "motion/plan/chunks.h"
#include "query/memory_table.h"
#include "shape/chunk_item.h"

namespace foresee {

MemoryPlans::MemoryPlans(const Layout& layout, double horizon, FindRecord find_record)
    : layout_(layout),
      at_(record_offsets(layout)),
      pages_(chunk_layout(layout)),
      tree_(make_tpr_tree(pages_, horizon)),
      find_record_(std::move(find_record)) {}

MemoryPlans::Numbers MemoryPlans::numbers_of(std::span<const double> record) const {
  return {static_cast<std::int64_t>(record[static_cast<std::size_t>(at_.plan)]),
          static_cast<std::int64_t>(record[static_cast<std::size_t>(at_.chunks)])};
}

void MemoryPlans::put(std::int64_t id, std::span<double> record, std::span<const Leg> legs) {
  std::vector<double> item(static_cast<std::size_t>(record_offsets(pages_.layout()).size));
  const std::int64_t first = legs.empty() ? 0 : next_;
  std::size_t count = 0;
  if (!legs.empty())
    for (const ChunkRange& range : cut_into_chunks(legs)) {
      const auto of_chunk = legs.subspan(range.first, range.count);
      write_chunk_item(layout_, record.data(), of_chunk, item.data());
      tree_->insert(next_, item);
      chunks_[next_++] = {id, {of_chunk.begin(), of_chunk.end()}};
      ++count;
    }
  record[static_cast<std::size_t>(at_.plan)] = static_cast<double>(first);
  record[static_cast<std::size_t>(at_.chunks)] = static_cast<double>(count);
}

void MemoryPlans::erase(std::span<const double> record) {
  const Numbers numbers = numbers_of(record);
  for (std::int64_t number = numbers.first; number < numbers.first + numbers.count; ++number) {
    tree_->erase(number);
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
