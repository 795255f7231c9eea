#include "query/join/join_plan.h"

#include <algorithm>
#include <functional>

#include "base/axes.h"
#include "base/float_environment.h"
#include "base/repeatable_choice.h"
#include "query/legs/leg_scene.h"

namespace foresee {
namespace {

// Nanoseconds, on the machine of docs/developers/benchmarks.md; only their ratios matter.
constexpr double scan_pair = 25;        // the exact stage for a pair far apart
constexpr double grid_setup = 3000;     // an empty grid
constexpr double grid_object = 80;      // its box, its places in the grid, and comparisons with a few others
constexpr double grid_meeting = 1.6;    // two swept boxes that intersect, and the comparisons beside them
constexpr double grid_repetition = 60;  // a pair in contact is tested again in every slab

/// Size of the sample of a scene's rows: one row in `one_in`, within limits.
struct SampleSize {
  std::size_t one_in, min, max;
};
constexpr SampleSize usual_sample{256, 48, 256}, few{256, 16, 16}, many{16, 48, 4096};
constexpr std::size_t slabs_max = 4096;
constexpr double worth_helpers = 1e6;  // a slab of one millisecond; starting threads takes a tenth of that

double pairs_of(const JoinQuestion& question) {
  const double a = static_cast<double>(question.a->size());
  return question.b ? a * static_cast<double>(question.b->size()) : a * (a - 1) / 2;
}

/// Swept boxes of a stratified sample of rows.
template <int D>
std::vector<Box<D>> sample_of(const Scene& scene, const Horizon& horizon, const Vec<D>& margin,
                              const SampleSize& size = usual_sample) {
  const std::size_t count = scene.size(),
                    wanted = std::min(count, std::clamp(count / size.one_in, size.min, size.max));
  const Bodies bodies = scene.bodies();
  std::vector<Box<D>> boxes;
  boxes.reserve(wanted);
  for (std::size_t part = 0; part < wanted; ++part)
    boxes.push_back(swept_box<D>(bodies, stratified_pick(part, wanted, count), horizon, margin));
  return boxes;
}

/// The number of pairs of boxes that intersect; of one sample, each pair once.
template <int D>
double count_meetings(const std::vector<Box<D>>& a, const std::vector<Box<D>>& b, bool between) {
  std::size_t meetings = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = between ? 0 : i + 1; j < b.size(); ++j) meetings += a[i].meets(b[j]);
  return static_cast<double>(meetings);
}

/// Fraction of all pairs whose swept boxes intersect.
template <int D>
double share_that_meets(const JoinQuestion& question, const Horizon& horizon, const Vec<D>& margin) {
  const bool between = question.b && question.b != question.a;
  const std::vector<Box<D>> a = sample_of<D>(*question.a, horizon, margin),
                            b = between ? sample_of<D>(*question.b, horizon, margin) : a;
  const double of_a = static_cast<double>(a.size()), of_b = static_cast<double>(b.size());
  const double pairs = between ? of_a * of_b : of_a * (of_a - 1) / 2;
  return pairs > 0 ? count_meetings(a, b, between) / pairs : 0;
}

/// Fraction of all pairs whose boxes intersect at one instant, from a few rows against many. A few giants may
/// touch more objects than all others together, and a small sample of both sides misses them.
template <int D>
double share_that_touches(const JoinQuestion& question, double time, const Vec<D>& margin) {
  const bool between = question.b && question.b != question.a;
  const Horizon instant{time, 0};
  const std::vector<Box<D>> a = sample_of<D>(*question.a, instant, margin, few);
  const std::vector<Box<D>> b = sample_of<D>(between ? *question.b : *question.a, instant, margin, many);
  std::size_t meetings = 0;
  for (const Box<D>& box : b)
    for (const Box<D>& other : a) meetings += box.meets(other);
  const double pair_count = static_cast<double>(a.size() * b.size());
  if (pair_count == 0) return 0;
  // The expected number of rows in both samples: each meets itself.
  const double same = between ? 0 : pair_count / static_cast<double>(question.a->size());
  return std::max(0.0, static_cast<double>(meetings) - same) / pair_count;
}

/// The queried times in seconds from now, as accurate as a plan needs. Length 0 if no time is queried.
struct QueriedSpan {
  double begin, length;
};

QueriedSpan span_of(const JoinQuestion& question) {
  const double begin = std::max({0.0, question.queried_dt.min, question.queried_t.min - question.now});
  const double end = std::min({question.h, question.queried_dt.max, question.queried_t.max - question.now});
  return {begin, std::max(0.0, end - begin)};
}

/// The middle one of `parts` equal parts of the span.
Horizon middle_part(const JoinQuestion& question, const QueriedSpan& span, std::size_t parts) {
  const double part = span.length / static_cast<double>(parts);
  return {question.now + (span.begin + (span.length - part) / 2), part};
}

/// Estimated number of pairs that touch at one instant.
double expected_contacts(const JoinQuestion& question, double time) {
  return with_axes(question.a->layout.axes, [&]<int D>(Axes<D>) {
    return pairs_of(question) * share_that_touches<D>(question, time, margin_of<D>(question));
  });
}

/// What a join costs in a scan, and per slab in a grid.
struct JoinCosts {
  double pairs;                                       ///< that a scan tests
  std::function<double(std::size_t slabs)> rows;      ///< that one of so many slabs enters into a grid
  std::function<double(std::size_t slabs)> meetings;  ///< pairs of swept boxes that intersect in one of them
  double shortest = 0;                                ///< no slab is shorter

  double of_grid(std::size_t slabs) const { return grid_setup + grid_object * rows(slabs); }
};

JoinCosts costs_of_objects(const JoinQuestion& question) {
  const double objects = static_cast<double>(question.a->size() + (question.b ? question.b->size() : 0));
  return {.pairs = pairs_of(question),
          .rows = [objects](std::size_t) { return objects; },
          .meetings =
              [&](std::size_t slabs) {
                return expected_meetings(question, middle_part(question, span_of(question), slabs));
              }};
}

// Plans: the rows are legs, most of which exist during a part of the span only.

/// Legs of one scene that exist in the queried span, from a stratified sample of its rows.
class LegSample {
 public:
  LegSample(const Scene& scene, const Horizon& span) : scene_(scene), bodies_(scene.bodies()), span_(span) {
    const std::size_t count = scene.size(), wanted = std::min<std::size_t>(count, 4096);
    const double end = span.now + span.h;
    for (std::size_t part = 0; part < wanted; ++part) {
      const std::size_t row = stratified_pick(part, wanted, count);
      const bool exists = t(row) <= end && span.now <= until(row);
      if (!exists) continue;
      rows_.push_back(row);
      lengths_.push_back(until(row) - t(row));
    }
    each_ = wanted > 0 ? static_cast<double>(count) / static_cast<double>(wanted) : 0;
    std::sort(lengths_.begin(), lengths_.end());
  }

  double median_length() const { return lengths_.empty() ? 0 : lengths_[lengths_.size() / 2]; }
  /// The expected number of legs that exist in a part of the span, wherever it is.
  double alive(double part) const {
    if (!(part < span_.h)) return each_ * static_cast<double>(rows_.size());
    double sum = 0;
    for (const std::size_t row : rows_) {
      const double length = std::min(until(row), span_.now + span_.h) - std::max(t(row), span_.now);
      sum += std::min(1.0, (length + part) / span_.h);
    }
    return each_ * sum;
  }
  /// Swept boxes of some legs that exist in `part`. Each is a leg of the object of a sampled leg: of the sample itself
  /// too few may exist in a short part.
  template <int D>
  std::vector<Box<D>> boxes(const Horizon& part, const Vec<D>& margin) const {
    std::vector<std::size_t> alive;
    const std::size_t wanted = std::min(rows_.size(), usual_sample.max);
    for (std::size_t i = 0; i < wanted; ++i) {
      const RowRange legs = legs_of_object(rows_[i * rows_.size() / wanted], part);
      if (legs.size() > 0) alive.push_back(legs.first + irregular_pick(i, legs.size()));
    }
    std::sort(alive.begin(), alive.end());
    alive.erase(std::unique(alive.begin(), alive.end()), alive.end());
    std::vector<Box<D>> boxes;
    for (const std::size_t row : alive) boxes.push_back(swept_box<D>(bodies_, row, part, margin));
    return boxes;
  }

 private:
  /// Those of the object of this row that exist in `part`.
  RowRange legs_of_object(std::size_t row, const Horizon& part) const {
    if (scene_.layout.has_plan) return rows_during(bodies_, scene_.legs_beside(row), part);
    const bool exists = t(row) <= part.now + part.h && part.now <= until(row);
    return {row, row + exists};
  }
  double t(std::size_t row) const { return value_or(bodies_.row(row), bodies_.at.t, span_.now); }
  double until(std::size_t row) const {
    return value_or(bodies_.row(row), bodies_.at.until, std::numeric_limits<double>::infinity());
  }

  const Scene& scene_;
  Bodies bodies_;
  Horizon span_;
  std::vector<std::size_t> rows_;
  std::vector<double> lengths_;
  double each_;
};

/// Each leg that crosses the border of a slab is entered twice. A scan merges the legs of each pair of movers.
template <int D>
JoinCosts costs_of_legs(const JoinQuestion& question) {
  const QueriedSpan span = span_of(question);
  const bool between = question.b && question.b != question.a;
  const Horizon whole{question.now + span.begin, span.length};
  const auto a = std::make_shared<const LegSample>(*question.a, whole),
             b = between ? std::make_shared<const LegSample>(*question.b, whole) : a;
  const double movers_a = static_cast<double>(question.a->object_count()),
               movers_b = between ? static_cast<double>(question.b->object_count()) : movers_a;
  const auto part = [span](std::size_t slabs) { return span.length / static_cast<double>(slabs); };
  const auto meetings = [=, &question, margin = margin_of<D>(question)](std::size_t slabs) {
    const Horizon middle = middle_part(question, span, slabs);
    const std::vector<Box<D>> of_a = a->template boxes<D>(middle, margin),
                              of_b = between ? b->template boxes<D>(middle, margin) : of_a;
    const double sampled = static_cast<double>(of_a.size() * of_b.size());
    const double legs = a->alive(part(slabs)) * b->alive(part(slabs));
    return sampled > 0 ? count_meetings(of_a, of_b, between) * legs / sampled : 0;
  };
  const double median = std::min(a->median_length(), b->median_length());
  return {
      .pairs =
          (question.b ? movers_a * movers_b : movers_a * movers_a / 2) *
          (a->alive(span.length) / std::max(movers_a, 1.0) + b->alive(span.length) / std::max(movers_b, 1.0)),
      .rows =
          [=](std::size_t slabs) { return a->alive(part(slabs)) + (between ? b->alive(part(slabs)) : 0); },
      .meetings = meetings,
      // Legs that outlast the span are cut as objects are.
      .shortest = median < span.length ? 4 * median : 0};
}

struct SlabChoice {
  std::size_t slabs;
  double cost;
};

/// Increases the number of slabs while the grid gets cheaper. Every slab pays for its rows again, so the lower bound on
/// the cost soon ends the search.
SlabChoice choose_slabs(const JoinQuestion& question, const JoinCosts& costs) {
  const QueriedSpan span = span_of(question);
  SlabChoice best{1, costs.of_grid(1) + grid_meeting * costs.meetings(1)};
  std::optional<double> repeated;
  for (std::size_t slabs = 2; slabs <= slabs_max; slabs += (slabs + 1) / 2) {
    const double times = static_cast<double>(slabs), length = span.length / times;
    double floor = times * costs.of_grid(slabs);
    if (!(length > 0) || length < costs.shortest || floor >= best.cost) break;
    if (!repeated)
      repeated = grid_repetition * expected_contacts(question, question.now + span.begin + span.length / 2);
    floor += (times - 1) * *repeated;
    if (floor >= best.cost) break;
    const double cost = floor + grid_meeting * times * costs.meetings(slabs);
    if (cost < best.cost) best = {slabs, cost};
  }
  return best;
}

}  // namespace

double expected_meetings(const JoinQuestion& question, const Horizon& horizon) {
  return with_axes(question.a->layout.axes, [&]<int D>(Axes<D>) {
    return pairs_of(question) * share_that_meets<D>(question, horizon, margin_of<D>(question));
  });
}

JoinPlan plan_join(const JoinQuestion& question) {
  const FloatEnvironment environment;
  const bool automatic = question.method == JoinMethod::automatic;
  const bool may_be_grid = automatic || question.method == JoinMethod::grid;
  if (question.only_a || question.only_b) return {JoinMethod::scan, "a query of one object", 1};
  const bool of_legs = has_plans(question);
  if (!may_be_grid && (!of_legs || question.method == JoinMethod::scan))
    return {question.method, "as requested", 1};
  const JoinCosts costs = !of_legs ? costs_of_objects(question)
                                   : with_axes(question.a->layout.axes,
                                               [&]<int D>(Axes<D>) { return costs_of_legs<D>(question); });
  if (automatic && scan_pair * costs.pairs <= costs.of_grid(1))
    return {JoinMethod::scan, "to test each of so few pairs costs less than a grid", 1};
  const SlabChoice best = choose_slabs(question, costs);
  if (!may_be_grid) return {question.method, "as requested", best.slabs};
  const bool with_helpers =
      question.helpers > 0 && best.cost >= worth_helpers * static_cast<double>(best.slabs);
  const char* why = automatic ? "there are too many pairs to test each" : "as requested";
  return {JoinMethod::grid, why, best.slabs, with_helpers};
}

TimeSlabs slabs_of(const JoinPlan& plan, const JoinQuestion& question) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const double length = span_of(question).length;
  const bool is_cut =
      plan.method == JoinMethod::grid || (has_plans(question) && plan.method != JoinMethod::scan);
  if (!is_cut) return {question, {endless, endless}};
  const double step = plan.slabs > 1 ? length / static_cast<double>(plan.slabs) : endless;
  if (question.order == JoinOrder::any) return {question, {step, step}};
  constexpr double first_share = 1.0 / 64;
  return {question, {step, std::min(step, length * first_share), question.queried_dt.min <= 0}};
}

}  // namespace foresee
