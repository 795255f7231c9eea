#include "index/all_pairs.h"

#include <algorithm>

namespace foresee {

namespace {

constexpr std::size_t pairs_per_batch = 4096;

/// Emits pairs row by row; in a self-join a row is paired with the rows after it. A batch may end within a
/// row.
class AllPairs final : public Candidates {
 public:
  AllPairs(std::size_t count_a, std::size_t count_b, bool within, Interrupt& interrupt)
      : count_a_(count_a), count_b_(count_b), within_(within), b_(within ? 1 : 0), interrupt_(interrupt) {}

  bool next(std::vector<Pair>& out) override {
    interrupt_.check();
    const std::size_t before = out.size();
    for (std::size_t room = pairs_per_batch; room > 0 && a_ < count_a_;) {
      const std::size_t end = std::min(count_b_, b_ + room);
      for (std::size_t b = b_; b < end; ++b)
        out.push_back({static_cast<std::uint32_t>(a_), static_cast<std::uint32_t>(b)});
      room -= end > b_ ? end - b_ : 1;
      b_ = end;
      if (end >= count_b_) b_ = ++a_ * within_ + within_;
    }
    return out.size() > before || a_ < count_a_;
  }

 private:
  std::size_t count_a_, count_b_;
  std::size_t within_;  // 1 in a self-join: a row starts behind the diagonal
  std::size_t a_ = 0, b_;
  Interrupt& interrupt_;
};

}  // namespace

std::unique_ptr<Candidates> make_all_pairs(std::size_t count, Interrupt& interrupt) {
  return std::make_unique<AllPairs>(count, count, true, interrupt);
}

std::unique_ptr<Candidates> make_all_pairs(std::size_t count_a, std::size_t count_b, Interrupt& interrupt) {
  return std::make_unique<AllPairs>(count_b == 0 ? 0 : count_a, count_b, false, interrupt);
}

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
