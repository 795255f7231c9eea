#include "index/paper_grid/paper_stages.h"

#include <algorithm>

#include "base/float_environment.h"
#include "contact/contact.h"
#include "index/paper_grid/trajectory.h"

namespace foresee {
namespace {

/// The objects as points at their centres.
Bodies centres_of(Bodies bodies) {
  bodies.layout.shape = Shape::point;
  bodies.layout.has_growth = bodies.layout.has_growth_z = false;
  bodies.at.half = bodies.at.r = bodies.at.hz = Offsets::absent;
  bodies.at.growth = bodies.at.growth_z = Offsets::absent;
  return bodies;
}

template <int D>
class TypedStages final : public PaperStages {
 public:
  TypedStages(const Bodies& a, const Bodies& b, bool between, const Horizon& horizon, const Vec<D>& margin,
              Interrupt& interrupt)
      : a_(a), b_(between ? b : a), horizon_(horizon), margin_(margin), interrupt_(interrupt) {
    const double begin = thread_seconds();
    boxes_a_ = swept_boxes<D>(a, horizon, margin, interrupt);
    if (between) boxes_b_ = swept_boxes<D>(b, horizon, margin, interrupt);
    count(PaperStage::projection_overlap).seconds = thread_seconds() - begin;
    // An outline or a mesh need not contain its centre, so the centre point test proves nothing.
    if (a.at.outline != Offsets::absent || b_.at.outline != Offsets::absent) return;
    centres_ = make_contact(centres_of(a), centres_of(b), {.horizon = horizon}, "a", "b");
  }

  void prune(std::vector<Pair>& pairs) override {
    const FloatEnvironment environment;
    const std::vector<Box<D>>& boxes_b = boxes_b_.empty() ? boxes_a_ : boxes_b_;
    keep(PaperStage::projection_overlap, pairs, 0,
         [&](std::size_t i) { return boxes_a_[pairs[i].a].meets(boxes_b[pairs[i].b]); });
    const std::size_t hits = move_hits_to_front(pairs);
    trajectories_.clear();
    keep(PaperStage::time_interval, pairs, hits, [&](std::size_t i) {
      const TwoTrajectories two{trajectory_of<D>(a_, pairs[i].a, horizon_, margin_),
                                trajectory_of<D>(b_, pairs[i].b, horizon_, margin_)};
      if (!times_may_overlap<D>(two.a, two.b)) return false;
      trajectories_.push_back(two);
      return true;
    });
    keep(PaperStage::trajectory_intersection, pairs, hits, [&](std::size_t i) {
      return regions_may_meet<D>(trajectories_[i - hits].a, trajectories_[i - hits].b);
    });
  }

 private:
  static constexpr std::size_t pairs_per_check = 512;

  StageCount& count(PaperStage stage) { return counts_[static_cast<std::size_t>(stage)]; }

  /// Keeps the first `passed` pairs, and each later pair i for which test(i) is true.
  template <class Test>
  void keep(PaperStage stage, std::vector<Pair>& pairs, std::size_t passed, Test test) {
    const double begin = thread_seconds();
    count(stage).before += pairs.size();
    std::size_t kept = passed;
    for (std::size_t i = passed; i < pairs.size(); ++i) {
      if (i % pairs_per_check == 0) interrupt_.check();
      if (test(i)) pairs[kept++] = pairs[i];
    }
    pairs.resize(kept);
    count(stage).after += kept;
    count(stage).seconds += thread_seconds() - begin;
  }

  /// The centre point test; returns the number of hits.
  std::size_t move_hits_to_front(std::vector<Pair>& pairs) {
    const double begin = thread_seconds();
    hits_.clear();
    for (std::size_t i = 0; centres_ && i < pairs.size(); i += pairs_per_check) {
      interrupt_.check();
      centres_->decide(std::span(pairs).subspan(i, std::min(pairs_per_check, pairs.size() - i)), hits_);
    }
    others_.clear();
    auto hit = hits_.begin();  // hits are in the order of the pairs
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

  struct TwoTrajectories {
    Trajectory<D> a, b;
  };

  Bodies a_, b_;
  Horizon horizon_;
  Vec<D> margin_;
  Interrupt& interrupt_;
  std::vector<Box<D>> boxes_a_, boxes_b_;  // boxes_b_: only in a join between two sides
  std::unique_ptr<Contact> centres_;       // null for outlines or meshes
  std::vector<Pair> hits_, others_;
  std::vector<TwoTrajectories> trajectories_;  // of the pairs behind the hits that stage c has kept
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
