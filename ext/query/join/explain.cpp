#include "query/join/explain.h"

#include <algorithm>
#include <iterator>

#include "base/axes.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "index/paper_grid/paper_grid.h"
#include "index/paper_grid/paper_stages.h"
#include "query/join/join_candidates.h"
#include "query/join/join_plan.h"
#include "query/join/join_scenes.h"
#include "query/join/movers/found_movers.h"
#include "query/join/pair_kinds.h"
#include "query/tile/tile.h"

namespace foresee {
namespace {

constexpr const char* test_names[paper_stage_count] = {"projection overlap", "centre point", "time interval",
                                                       "trajectory intersection"};

/// Pairs of an object with itself, which are not queried; of an object with a plan, pairs of its legs. `meeting`: only
/// those whose kinds may meet.
std::uint64_t pairs_of_one_object(const JoinQuestion& question, bool meeting, Interrupt& interrupt) {
  const Scene& scene = *question.a;
  if (question.b ? question.b != question.a : !scene.layout.has_plan) return 0;
  Steps steps(interrupt);
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < scene.object_count(); ++i) {
    steps();
    const RowRange rows = scene.rows_of(i);
    if (question.own && question.own->a[rows.first] & Tile::unneeded) continue;
    const auto first = static_cast<std::uint32_t>(rows.first);
    if (meeting && !question.kinds->may_meet({first, first})) continue;
    const std::uint64_t legs = rows.last - rows.first;
    pairs += question.b ? legs * legs : legs * (legs - 1) / 2;
  }
  return pairs;
}

/// All queried pairs; in a tile, the pairs of the objects that it needs. Where objects have plans, pairs of legs.
std::uint64_t queried_pairs(const JoinQuestion& question, Interrupt& interrupt) {
  const std::uint64_t left_out = pairs_of_one_object(question, false, interrupt);
  const auto pairs = [&](std::uint64_t a, std::uint64_t b) {
    return (question.b ? a * b : a * (a - 1) / 2) - left_out;
  };
  if (question.own) return pairs(question.own->needed_a, question.own->needed_b);
  return pairs(question.a->size(), question.b ? question.b->size() : 0);
}

/// The last stage where objects have plans: pairs of legs that touch become pairs of movers.
class MoverStage {
 public:
  explicit MoverStage(const JoinQuestion& question)
      : a_(question.a),
        other_(question.b && question.b != question.a ? std::optional<Movers>(question.b) : std::nullopt),
        within_(!question.b) {}

  bool are_one(const Pair& legs) const { return !other_ && a_.mover_of(legs.a) == a_.mover_of(legs.b); }
  void add(const std::vector<Pair>& touching) {
    const double begin = thread_seconds();
    for (const Pair& legs : touching) {
      Pair movers = a_.movers_of(legs, other_ ? *other_ : a_);
      if (within_ && movers.b < movers.a) std::swap(movers.a, movers.b);
      count.after += pairs_.find_or_add(movers, count.after) == count.after;
    }
    count.before += touching.size();
    count.seconds += thread_seconds() - begin;
  }

  StageCount count;

 private:
  Movers a_;
  std::optional<Movers> other_;
  bool within_;
  PairTable pairs_;
};

/// The stages of one join, and their counts so far.
class Explanation {
 public:
  /// `kinds`: the count of the stage before the candidates, or nothing if all pairs may meet.
  Explanation(const JoinQuestion& question, const std::optional<StageCount>& kinds, Interrupt& interrupt)
      : kinds_count_(kinds),
        question_(question),
        a_(*question.a),
        b_(question.side_b()),
        interrupt_(interrupt),
        contact_(contact_of(question, true)),
        refinement_(has(Shape::outline) || has(Shape::mesh) ? contact_of(question) : nullptr),
        plan_(plan_join(question)) {
    if (refinement_) refinement_->set_interrupt(interrupt);
    if (has_plans(question)) movers_.emplace(question);
    open_axes();
    candidates_count_.before = kinds ? kinds->after : queried_pairs(question, interrupt);
  }

  void run() {
    for (std::vector<Pair> pairs; next_candidates(pairs); pairs.clear()) {
      stages_->prune(pairs);
      decide_exactly(pairs);
    }
  }

  std::vector<ExplainRow> rows() const {
    std::vector<ExplainRow> rows;
    if (kinds_count_) rows.push_back(row("kinds", "before step 1", *kinds_count_, "category and mask"));
    rows.push_back(row("candidates", "steps 1 to 4", candidates_count_, candidates_detail()));
    constexpr const char* steps[] = {"step 5a", "step 5b", "step 5c", "step 5d"};
    static_assert(std::size(steps) == paper_stage_count);
    for (std::size_t stage = 0; stage < paper_stage_count; ++stage)
      rows.push_back(row(test_names[stage], steps[stage], stages_->counts()[stage],
                         test_detail(static_cast<PaperStage>(stage))));
    rows.push_back(row("exact time", "step 5e", exact_count_, exact_detail()));
    rows.push_back(
        row("refinement", "step 6", refinement_ ? refinement_count_ : left_out(), refinement_detail()));
    if (movers_)
      rows.push_back(row("movers", "after step 6", movers_->count, "pairs of objects whose legs touch"));
    return rows;
  }

 private:
  bool has(Shape shape) const { return a_.layout.shape == shape || b_.layout.shape == shape; }
  bool uses_paper_grid() const { return plan_.method == JoinMethod::gpcd; }

  void open_axes() {
    with_axes(a_.layout.axes, [&]<int D>(Axes<D>) { open<D>(); });
  }

  template <int D>
  void open() {
    const Horizon horizon{question_.now, question_.h};
    const Vec<D> margin = margin_of<D>(question_);
    const Bodies a = a_.bodies(), b = b_.bodies();
    const bool between = question_.b != nullptr;
    const double begin = thread_seconds();
    if (uses_paper_grid())
      candidates_ = owned(meeting(make_paper_grid<D>(a, b, between, horizon, margin, interrupt_)));
    else
      candidates_ = join_candidates(question_, plan_.method, horizon, interrupt_);
    candidates_count_.seconds = thread_seconds() - begin;
    stages_ = make_paper_stages<D>(a, b, between, horizon, margin, interrupt_);
  }

  std::unique_ptr<Candidates> owned(std::unique_ptr<Candidates> all) const {
    return question_.own ? owned_candidates(std::move(all), question_.own) : std::move(all);
  }

  std::unique_ptr<Candidates> meeting(std::unique_ptr<Candidates> all) const {
    return question_.kinds ? meeting_candidates(std::move(all), question_.kinds) : std::move(all);
  }

  bool next_candidates(std::vector<Pair>& pairs) {
    const double begin = thread_seconds();
    const bool more = candidates_->next(pairs);
    // A table joined with itself as two sides: an object and itself are not a pair.
    if (question_.a == question_.b) std::erase_if(pairs, [](const Pair& pair) { return pair.a == pair.b; });
    if (movers_) std::erase_if(pairs, [this](const Pair& pair) { return movers_->are_one(pair); });
    candidates_count_.after += pairs.size();
    candidates_count_.seconds += thread_seconds() - begin;
    return more;
  }

  /// In slices that can be interrupted: a pair may take tens of microseconds.
  void decide_exactly(const std::vector<Pair>& pairs) {
    const double begin = thread_seconds();
    for (std::size_t i = 0; i < pairs.size(); i += slice) {
      interrupt_.check();
      const auto some = std::span(pairs).subspan(i, std::min(slice, pairs.size() - i));
      if (candidates_->touching()) {
        exact_count_.after += some.size();
        touching_ += some.size();
        hits_.insert(hits_.end(), some.begin(), some.end());
        continue;
      }
      const std::size_t before = hits_.size();
      contact_->first_contacts(some, TimesWanted::starts, hits_, times_);
      exact_count_.after += hits_.size() - before;
      for (const ContactTimes& times : times_) touching_ += times.dt == 0;
      times_.clear();
    }
    exact_count_.before += pairs.size();
    exact_count_.seconds += thread_seconds() - begin;
    if (refinement_)
      refine();
    else if (movers_)
      movers_->add(hits_);
    hits_.clear();
  }

  /// Counts the pairs whose outlines or meshes touch, of those whose boxes do. An index certifies boxes only.
  void refine() {
    const double begin = thread_seconds();
    std::vector<Pair> touching;
    for (std::size_t i = 0; i < hits_.size(); i += slice) {
      interrupt_.check();
      refinement_->first_contacts(std::span(hits_).subspan(i, std::min(slice, hits_.size() - i)),
                                  TimesWanted::starts, touching, times_);
      times_.clear();
    }
    refinement_count_.before += hits_.size();
    refinement_count_.after += touching.size();
    refinement_count_.seconds += thread_seconds() - begin;
    if (movers_) movers_->add(touching);
  }

  /// `step`: the name of the step in docs/explanation/gpcd.md.
  static ExplainRow row(const char* stage, const char* step, const StageCount& count,
                        const std::string& detail) {
    return {stage, count.before, count.after, count.seconds, detail.empty() ? step : detail + "; " + step};
  }

  /// The count of a refinement that is left out: it keeps all pairs.
  StageCount left_out() const { return {.before = exact_count_.after, .after = exact_count_.after}; }

  std::string exact_detail() const {
    const char* const boxes = has(Shape::mesh)      ? "of the smallest boxes around meshes; "
                              : has(Shape::outline) ? "of the smallest rectangles around outlines; "
                                                    : "";
    return boxes + std::to_string(touching_) + " touch at now already";
  }

  std::string refinement_detail() const {
    return refinement_ ? refinement_->effort() : "left out: no outlines";
  }

  std::string candidates_detail() const {
    std::string detail = "method '" + std::string(name_of(question_.method)) + "'";
    if (question_.method == JoinMethod::automatic)
      detail += std::string(" takes '") + name_of(plan_.method) + "': " + plan_.why;
    const std::string index = candidates_->describe();
    if (!index.empty()) detail += "; " + index;
    if (plan_.slabs > 1)
      detail += "; measured here in one, the join takes " + std::to_string(plan_.slabs) + " time slabs";
    return detail;
  }

  std::string test_detail(PaperStage stage) const {
    std::string detail;
    if (!uses_paper_grid())
      detail = std::string("left out: '") + name_of(plan_.method) +
               "' goes from candidates to exact time; measured here";
    if (stage != PaperStage::centre_point) return detail;
    return (detail.empty() ? "" : detail + "; ") + std::to_string(stages_->hits_at_once()) +
           " hits at once, spared the next two tests";
  }

  static constexpr std::size_t slice = 256;

  std::optional<StageCount> kinds_count_;
  std::optional<MoverStage> movers_;  // where objects have plans
  const JoinQuestion& question_;
  const Scene &a_, &b_;
  Interrupt& interrupt_;
  std::unique_ptr<Contact> contact_, refinement_;  // refinement: null without outlines and meshes
  JoinPlan plan_;
  std::unique_ptr<Candidates> candidates_;
  std::unique_ptr<PaperStages> stages_;
  StageCount candidates_count_, exact_count_, refinement_count_;
  std::size_t touching_ = 0;
  std::vector<Pair> hits_;
  std::vector<ContactTimes> times_;
};

/// The pairs that may meet, of all queried ones. Nothing for tables without category and mask.
std::optional<StageCount> count_kinds(const JoinQuestion& all, Interrupt& interrupt) {
  if (!all.kinds) return {};
  const double begin = thread_seconds();
  StageCount count{.before = queried_pairs(all, interrupt),
                   .after = count_meeting(all, interrupt) - pairs_of_one_object(all, true, interrupt)};
  count.seconds = thread_seconds() - begin;
  return count;
}

}  // namespace

std::vector<ExplainRow> explain_join(const JoinQuestion& whole, Interrupt& interrupt) {
  const FloatEnvironment environment;
  require_valid(whole);
  const JoinQuestion all = with_kinds(in_tile(whole, interrupt));
  JoinQuestion question = all.kinds ? with_kinds(in_tile(without_inert(whole, interrupt), interrupt)) : all;
  question.only_a = question.only_b = {};
  question.queried_t = question.queried_dt = {};
  question.all_contacts = false;
  Explanation explanation(question, count_kinds(all, interrupt), interrupt);
  if (all.a->size() == 0 || (all.b && all.b->size() == 0)) return {};
  if (all.own && (all.own->needed_a == 0 || all.own->needed_b == 0)) return {};
  explanation.run();
  return explanation.rows();
}

}  // namespace foresee
