#include "index/one_with_all.h"

#include <algorithm>

namespace foresee {
namespace {

constexpr std::uint32_t batch_size = 4096;

class OneWithAllCandidates final : public Candidates {
 public:
  OneWithAllCandidates(const OneWithAll& rows, Interrupt& interrupt) : rows_(rows), interrupt_(interrupt) {}

  bool next(std::vector<Pair>& out) override {
    interrupt_.check();
    if (next_ == rows_.count) return false;
    const std::uint32_t end = next_ + std::min(batch_size, rows_.count - next_);
    for (; next_ < end; ++next_)
      out.push_back(rows_.side == Side::a ? Pair{rows_.one, next_} : Pair{next_, rows_.one});
    return true;
  }

 private:
  OneWithAll rows_;
  Interrupt& interrupt_;
  std::uint32_t next_ = 0;
};

}  // namespace

std::unique_ptr<Candidates> make_one_with_all(const OneWithAll& rows, Interrupt& interrupt) {
  return std::make_unique<OneWithAllCandidates>(rows, interrupt);
}

}  // namespace foresee
