// What are the objects like of which only some fit into memory? Every so many of them are kept, so that they
// stand for all, however many come.
//
//   RecordSample sample(6);
//   sample.add(record);                     // of each object
//   sample.records()                        // at most 16384, evenly drawn
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/rooms.h"

namespace foresee::storage {

class RecordSample {
 public:
  explicit RecordSample(std::size_t record_size) : record_size_(record_size) {}

  void add(const double* record) {
    if (seen_++ % step_ != 0) return;
    if (records_.size() == most * record_size_) keep_every_other();
    if ((seen_ - 1) % step_ == 0) records_.insert(records_.end(), record, record + record_size_);
  }

  std::span<const double> records() const { return records_; }

 private:
  static constexpr std::size_t most = 1 << 14;

  void keep_every_other() {
    const auto size = static_cast<std::ptrdiff_t>(record_size_);
    for (std::ptrdiff_t kept = 0; kept < static_cast<std::ptrdiff_t>(most / 2); ++kept)
      std::copy_n(records_.begin() + 2 * kept * size, size, records_.begin() + kept * size);
    records_.resize(most / 2 * record_size_);
    step_ *= 2;
  }

  std::size_t record_size_, seen_ = 0, step_ = 1;
  std::vector<double> records_;
};

}  // namespace foresee::storage
