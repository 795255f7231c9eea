#include "storage/nodes/object_changes.h"

namespace foresee {

void ObjectChanges::add(std::int64_t id, std::span<const double> before) {
  join();
  known_.prepare(id);
  firsts_.push_back({id, records_.size() + before.size()});
  try {
    records_.insert(records_.end(), before.begin(), before.end());
  } catch (...) {
    firsts_.pop_back();
    throw;
  }
  known_.set(id, 1);
}

std::size_t ObjectChanges::memory() const {
  return firsts_.capacity() * sizeof(First) + records_.capacity() * sizeof(double) + known_.memory();
}

void ObjectChanges::rewind(std::size_t position) noexcept {
  for (; firsts_.size() > position; firsts_.pop_back()) known_.set(firsts_.back().id, IdHashMap::unknown);
  records_.resize(firsts_.empty() ? 0 : firsts_.back().end);
}

// Also releases the memory that a large transaction took.
void ObjectChanges::end(Journal::Ended) noexcept {
  firsts_ = std::vector<First>();
  records_ = std::vector<double>();
  known_.clear();
  kept_ = wanted_, complete_ = true;
}

}  // namespace foresee
