#include "query/legs/leg_candidates.h"

#include <utility>

#include "query/legs/leg_scene.h"

namespace foresee {
namespace {

constexpr std::size_t legs_per_batch = 4096;

struct MoverRange {
  std::uint32_t first, last;
};

/// The movers of a side that are queried.
MoverRange queried(const Movers& movers, const std::optional<std::int64_t>& only) {
  if (!only) return {0, movers.count()};
  const auto& ids = movers.scene()->ids;
  const auto found = std::find(ids.begin(), ids.end(), *only);
  if (found == ids.end()) return {0, 0};
  const std::uint32_t mover = movers.mover_of(static_cast<std::uint32_t>(found - ids.begin()));
  return {mover, mover + 1};
}

class LegCandidates final : public Candidates {
 public:
  LegCandidates(LegCandidatesOf sides, const Horizon& horizon, Interrupt& interrupt)
      : sides_(std::move(sides)),
        times_(leg_times_of(horizon)),
        of_a_(queried(sides_.a, sides_.only_a)),
        of_b_(queried(sides_.b, sides_.only_b)),
        each_once_(sides_.each_once && !sides_.only_a && !sides_.only_b),
        a_(of_a_.first),
        b_(first_b()),
        interrupt_(interrupt) {}

  bool next(std::vector<Pair>& out) override {
    interrupt_.check();
    const std::size_t full = out.size() + legs_per_batch;
    for (std::size_t steps = 0; a_ < of_a_.last; b_ = first_b()) {
      for (; b_ < of_b_.last; ++b_, legs_.reset()) {
        if ((sides_.each_once || sides_.are_one) && a_ == b_) continue;
        if (!legs_) legs_.emplace(sides_.a, sides_.b, Pair{a_, b_}, times_.from);
        for (auto legs = legs_->next(); legs && starts_by_end(*legs); legs = legs_->next()) {
          out.push_back(*legs);
          if (out.size() == full) return true;
        }
        if (++steps > legs_per_batch) {
          ++b_, legs_.reset();
          return true;
        }
      }
      if (++a_ == of_a_.last) return true;
    }
    return false;
  }

 private:
  bool starts_by_end(const Pair& legs) const {
    return std::max(sides_.a.t(legs.a), sides_.b.t(legs.b)) <= times_.until;
  }
  std::uint32_t first_b() const { return each_once_ ? a_ + 1 : of_b_.first; }

  LegCandidatesOf sides_;
  LegTimes times_;
  MoverRange of_a_, of_b_;
  bool each_once_;
  std::uint32_t a_, b_;
  std::optional<LegPairs> legs_;  ///< of a_ and b_, those that are left
  Interrupt& interrupt_;
};

}  // namespace

std::unique_ptr<Candidates> make_leg_candidates(LegCandidatesOf sides, const Horizon& horizon,
                                                Interrupt& interrupt) {
  return std::make_unique<LegCandidates>(std::move(sides), horizon, interrupt);
}

}  // namespace foresee
