// Emitter of (a, b, t) from batches of candidates, with the textbook's contact in plain double.
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include "core_rivals.h"
#include "plain_contact.h"
#include "shape/swept_boxes.h"

namespace foresee::bench {

class PlainEmitter {
 public:
  static constexpr std::size_t batch_size = 4096;

  explicit PlainEmitter(const Workload& w) : contact_(make_plain_contact(w)) { batch_.reserve(batch_size); }

  void take(std::uint32_t a, std::uint32_t b) {
    batch_.push_back({a, b});
    if (batch_.size() == batch_size) flush();
  }
  Answer finish() {
    flush();
    return answer_;
  }

 private:
  void flush() {
    answer_.candidates += batch_.size();
    hits_.clear(), times_.clear();
    contact_->first_contacts(batch_, hits_, times_);
    for (std::size_t i = 0; i < hits_.size(); ++i) answer_.add(hits_[i], times_[i]);
    batch_.clear();
  }

  std::unique_ptr<PlainContact> contact_;
  std::vector<Pair> batch_, hits_;
  std::vector<double> times_;
  Answer answer_;
};

/// Calls `work` with the dimension as a constant.
template <class Work>
Answer typed(const Workload& w, Work&& work) {
  if (w.layout.axes == 2) return work(std::integral_constant<int, 2>());
  return work(std::integral_constant<int, 3>());
}

template <int D>
std::vector<Box<D>> boxes_swept_by(const Workload& w) {
  NeverInterrupt never;
  return swept_boxes<D>(w.bodies(), {0, w.h}, Vec<D>::zero(), never);
}

}  // namespace foresee::bench
