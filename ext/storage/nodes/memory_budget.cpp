#include "storage/nodes/memory_budget.h"

#include <algorithm>

namespace foresee {

void MemoryBudget::write_out() {
  // By index: a trigger on a shadow table may open more tables meanwhile.
  for (std::size_t i = 0; i < holders_.size(); ++i) holders_[i]->write_out();
}

void MemoryBudget::evict() {
  const std::size_t limit = limits_.memory;
  if (kept_ < limit) evict_at_ = 0;
  if (kept_ < std::max(limit, evict_at_)) return;
  for (MemoryHolder* holder : holders_) holder->drop_nodes(false);
  if (kept_ > limit / 2)
    for (MemoryHolder* holder : holders_) holder->drop_nodes(true);
  evict_at_ = kept_ + limit / 8;
}

MemoryShare::MemoryShare(MemoryBudget& budget, MemoryHolder& holder) : budget_(budget), holder_(holder) {
  budget_.holders_.push_back(&holder);
}

MemoryShare::~MemoryShare() {
  hold_pending(0);
  hold_nodes(0, 0, 0);
  std::erase(budget_.holders_, &holder_);
}

}  // namespace foresee
