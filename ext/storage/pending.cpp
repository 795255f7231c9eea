#include "storage/pending.h"

#include <utility>

namespace foresee {

PendingLeaf* Pending::find(std::int64_t number) {
  const auto at = leaves.find(number);
  return at == leaves.end() ? nullptr : &at->second;
}

const PendingLeaf* Pending::next_after(std::int64_t after) const {
  auto at = leaves.upper_bound(after);
  while (at != leaves.end() && at->second.leaf.count() == 0) ++at;
  return at == leaves.end() ? nullptr : &at->second;
}

PendingLeaf& Pending::add(PendingLeaf leaf) {
  const std::int64_t number = leaf.number;
  return leaves.insert_or_assign(number, std::move(leaf)).first->second;
}

void Pending::clear() noexcept {
  leaves.clear();
  ids.clear();
  more = 0;
  map_half_written = false;
}

std::size_t Pending::memory(const NodeFormat& format) const {
  return leaves.size() * (format.node_size + sizeof(PendingLeaf)) + ids.size() * sizeof(IdChange);
}

}  // namespace foresee
