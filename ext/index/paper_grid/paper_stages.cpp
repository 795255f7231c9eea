#include "index/paper_grid/paper_stages.h"

#include <algorithm>

#include "contact/contact.h"
#include "index/paper_grid/thread_clock.h"
#include "index/paper_grid/time_interval.h"
#include "index/paper_grid/trajectory_intersection.h"
#include "motion/float_environment.h"

namespace foresee {
namespace {

/// The same objects as points.
Bodies centres_of(Bodies bodies) {
  bodies.layout.shape = Shape::point;
  bodies.at.half = bodies.at.r = bodies.at.hz = Offsets::absent;
  return bodies;
}

template <int D>
class TypedStages final : public PaperStages {
 public:
  TypedStages(const Bodies& a, const Bodies& b, bool between, const Horizon& horizon, const Vec<D>& margin,
              Interrupt& interrupt)
      : interrupt_(interrupt) {
    const double begin = thread_seconds();
    side_a_ = trajectories<D>(a, horizon, margin, interrupt);
    if (between) side_b_ = trajectories<D>(b, horizon, margin, interrupt);
    b_ = between ? &side_b_ : &side_a_;
    count(PaperStage::time_interval).seconds = thread_seconds() - begin;
    centres_ = make_contact(centres_of(a), centres_of(b), {.horizon = horizon}, "a", "b");
  }

  void prune(std::vector<Pair>& pairs) override {
    const FloatEnvironment environment;
    keep(PaperStage::projection_overlap, pairs, 0,
         [](const Trajectory<D>& a, const Trajectory<D>& b) { return a.swept.meets(b.swept); });
    const std::size_t hits = move_hits_to_front(pairs);
    keep(PaperStage::time_interval, pairs, hits, times_may_overlap<D>);
    keep(PaperStage::trajectory_intersection, pairs, hits, regions_may_meet<D>);
  }

 private:
  static constexpr std::size_t pairs_per_check = 512;

  StageCount& count(PaperStage stage) { return counts_[static_cast<std::size_t>(stage)]; }

  /// Keeps the first `passed` pairs and those of the others of which `test` is true.
  template <class Test>
  void keep(PaperStage stage, std::vector<Pair>& pairs, std::size_t passed, Test test) {
    const double begin = thread_seconds();
    count(stage).before += pairs.size();
    std::size_t kept = passed;
    for (std::size_t i = passed; i < pairs.size(); ++i) {
      if (i % pairs_per_check == 0) interrupt_.check();
      if (test(side_a_[pairs[i].a], (*b_)[pairs[i].b])) pairs[kept++] = pairs[i];
    }
    pairs.resize(kept);
    count(stage).after += kept;
    count(stage).seconds += thread_seconds() - begin;
  }

  /// The centre point test; returns how many hits it has found.
  std::size_t move_hits_to_front(std::vector<Pair>& pairs) {
    const double begin = thread_seconds();
    hits_.clear();
    for (std::size_t i = 0; i < pairs.size(); i += pairs_per_check) {
      interrupt_.check();
      centres_->decide(std::span(pairs).subspan(i, std::min(pairs_per_check, pairs.size() - i)), hits_);
    }
    others_.clear();
    auto hit = hits_.begin();  // both are in the same order
    for (const Pair& pair : pairs) {
      if (hit != hits_.end() && pair == *hit)
        ++hit;
      else
        others_.push_back(pair);
    }
    std::copy(others_.begin(), others_.end(), std::copy(hits_.begin(), hits_.end(), pairs.begin()));
    StageCount& stage = count(PaperStage::centre_point);
    stage.before += pairs.size();
    stage.after += pairs.size();
    stage.seconds += thread_seconds() - begin;
    hits_at_once_ += hits_.size();
    return hits_.size();
  }

  Interrupt& interrupt_;
  std::vector<Trajectory<D>> side_a_, side_b_;
  const std::vector<Trajectory<D>>* b_;
  std::unique_ptr<Contact> centres_;
  std::vector<Pair> hits_, others_;
};

}  // namespace

template <int D>
std::unique_ptr<PaperStages> make_paper_stages(const Bodies& a, const Bodies& b, bool between,
                                               const Horizon& horizon, const Vec<D>& margin,
                                               Interrupt& interrupt) {
  const FloatEnvironment environment;
  return std::make_unique<TypedStages<D>>(a, b, between, horizon, margin, interrupt);
}

template std::unique_ptr<PaperStages> make_paper_stages(const Bodies&, const Bodies&, bool, const Horizon&,
                                                        const Vec<1>&, Interrupt&);
template std::unique_ptr<PaperStages> make_paper_stages(const Bodies&, const Bodies&, bool, const Horizon&,
                                                        const Vec<2>&, Interrupt&);
template std::unique_ptr<PaperStages> make_paper_stages(const Bodies&, const Bodies&, bool, const Horizon&,
                                                        const Vec<3>&, Interrupt&);

}  // namespace foresee
