#include "index/gpcd_grid/grid.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "base/repeatable_choice.h"
#include "index/gpcd_grid/moving_source.h"

namespace foresee::gpcd {
namespace {

constexpr std::size_t sample_max = 512;
/// At most every sixteenth box is sampled, so that small scenes do not pay for statistics.
constexpr std::size_t sample_share = 16;
constexpr std::size_t sample_enough = 64;
constexpr std::size_t pairs_per_batch = 512;      // the data of the next stage fits the first-level cache
constexpr std::size_t touching_per_batch = 128;   // these become rows, which then fit that cache
constexpr std::size_t steps_per_batch = 1 << 17;  // about a millisecond

/// Non-empty beams of both sides: a stratified sample of some hundred.
template <int D>
std::vector<Beam<D>> sample_of(const MovingSource<D>& a, const MovingSource<D>* b) {
  const std::size_t count_a = a.count(), count = count_a + (b ? b->count() : 0),
                    aim = std::clamp(count / sample_share, sample_enough, sample_max),
                    wanted = std::min(count, aim);
  std::vector<std::size_t> of_a, of_b;
  for (std::size_t part = 0; part < wanted; ++part) {
    const std::size_t i = stratified_pick(part, wanted, count);
    if (i < count_a)
      of_a.push_back(i);
    else
      of_b.push_back(i - count_a);
  }
  std::vector<Beam<D>> sample;
  a.sample(of_a, sample);
  if (b) b->sample(of_b, sample);
  std::erase_if(sample, [](const Beam<D>& beam) { return beam.box.is_empty(); });
  return sample;
}

/// The columns that either side needs; no travel if the frame's unit is too small for the time test.
template <int D>
Columns columns_of(const MovingSource<D>& a, const MovingSource<D>* b, const FloatFrame<D>& frame) {
  const Columns first = a.columns(), second = b ? b->columns() : Columns{};
  const bool travel = frame.resolves_time() && (first.travel || second.travel);
  return {travel, travel && (first.life || second.life)};
}

}  // namespace

template <int D>
Grid<D>::Grid(const MovingBoxes<D>& objects_a, const MovingBoxes<D>* objects_b,
              std::shared_ptr<GridSpace> space, std::size_t helpers, Interrupt& interrupt)
    : space_(space ? std::move(space) : std::make_shared<GridSpace>()) {
  const MovingSource<D> a(objects_a, interrupt);
  std::optional<MovingSource<D>> source_b;
  const MovingSource<D>* const b = objects_b ? &source_b.emplace(*objects_b, interrupt) : nullptr;
  const std::vector<Beam<D>> sample = sample_of(a, b);
  const FloatFrame<D> frame = frame_of(std::span<const Beam<D>>(sample));
  const Columns columns = columns_of(a, b, frame);
  const std::vector<FloatBox<D>> sample_boxes = boxes_of(std::span<const Beam<D>>(sample), frame, columns);
  partition_ = choose_partition(std::span<const FloatBox<D>>(sample_boxes), a.count() + (b ? b->count() : 0));
  for (int axis = 1; axis < D; ++axis)
    stripe_height_[axis] = 1 / static_cast<double>(partition_.axis[axis].per_unit) / frame.scale[axis];
  for (const MovingSource<D>* source : {&a, b})
    if (source)
      sides_.push_back(std::make_unique<Side>(*source, frame, columns, partition_,
                                              space_->sides[sides_.size()], helpers, interrupt));
  if (giant_count() == 0 || !a.all_start(interrupt) || (b && !b->all_start(interrupt))) return;
  sides_[0]->giants.find_cores(a, frame, partition_);
  if (b) sides_[1]->giants.find_cores(*b, frame, partition_);
}

template <int D>
GridVisit<D>::GridVisit(std::shared_ptr<Grid<D>> grid, std::size_t first, std::size_t last,
                        Interrupt& interrupt)
    : grid_(std::move(grid)),
      memory_(grid_->space().visits),
      interrupt_(interrupt),
      giants_met_(first > 0),
      next_stripe_(first),
      last_stripe_(last),
      batch_((*memory_).batch.room(pairs_per_batch + lanes_max)) {
  sides_.reserve(2);
  for (std::size_t i = 0; i < grid_->side_count(); ++i)
    sides_.emplace_back(grid_->side(i).giants, (*memory_).inside[i], (*memory_).crossing[i]);
}

template <int D>
bool GridVisit<D>::next(std::vector<Pair>& out) {
  interrupt_.check();
  std::size_t written = 0, steps = steps_per_batch, enough = pairs_per_batch;
  bool more = true;
  while (steps > 0 && written < enough && more) {
    if (scan_ == scans_.size()) {
      scans_.clear();
      scan_ = 0;
      if (!giants_met_)
        open_giants();
      else if (next_stripe_ < last_stripe_)
        open_stripe(next_stripe_++);
      else
        more = false;
      continue;
    }
    const bool touching = scans_[scan_].keep == Keep::covered;
    if (written > 0 && touching != touching_) break;
    touching_ = touching;
    enough = touching ? touching_per_batch : pairs_per_batch;
    written += run_(scans_[scan_], batch_ + written, enough + lanes_max - written, steps);
    if (scans_[scan_].done()) ++scan_;
  }
  steps_taken_ += steps_per_batch - steps;
  out.insert(out.end(), batch_, batch_ + written);
  return more || written > 0;
}

template <int D>
void GridVisit<D>::open_giants() {
  giants_met_ = true;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    sides_[i].crossing.gather(sides_[i].giants.all(), grid_->side(i).rows, interrupt_);
  if (sides_.size() == 1)
    scans_.push_back(scan_within(sides_[0].crossing.view()));
  else
    scans_.push_back(scan_between(sides_[0].crossing.view(), sides_[1].crossing.view(), false));
}

template <int D>
void GridVisit<D>::open_stripe(std::size_t number) {
  const Partition<D>& partition = grid_->partition();
  int stripe[D] = {};
  if constexpr (D == 2) stripe[1] = static_cast<int>(number);
  if constexpr (D == 3) {
    const auto across = static_cast<std::size_t>(partition.axis[2].count);
    stripe[1] = static_cast<int>(number / across);
    stripe[2] = static_cast<int>(number % across);
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    auto& entered = grid_->side(i);
    sides_[i].inside.sort_and_gather_of_stripe(entered.stripes.entries(number), entered.rows, partition,
                                               stripe, interrupt_);
    const bool meets_none = grid_->side(other_side(i)).stripes.entries(number).empty();
    const auto crossing = meets_none ? std::span<const Key>() : sides_[i].giants.crossing(stripe);
    sides_[i].crossing.gather_of_stripe(crossing, entered.rows, partition, stripe, interrupt_);
    sides_[i].crossing.set_cores(sides_[i].giants.cores());
  }
  for (std::size_t i = 0; i < sides_.size(); ++i)
    sides_[i].crossing.clip_to(sides_[other_side(i)].inside.view());
  const LaneView<D>&inside = sides_[0].inside.view(), &crossing = sides_[0].crossing.view();
  if (sides_.size() == 1) {
    scans_.push_back(scan_within(inside));
    scan_giants(crossing, inside, false);
  } else {
    const LaneView<D>&other_inside = sides_[1].inside.view(), &other_crossing = sides_[1].crossing.view();
    scans_.push_back(scan_between(inside, other_inside, false));
    scan_giants(crossing, other_inside, false);
    scan_giants(other_crossing, inside, true);
  }
}

template <int D>
void GridVisit<D>::scan_giants(const LaneView<D>& crossing, const LaneView<D>& inside, bool swap) {
  constexpr std::size_t worth_two_batches = 64;
  if (!crossing.core_lower[0] || crossing.size * inside.size < worth_two_batches) {
    scans_.push_back(scan_between(crossing, inside, swap));
    return;
  }
  for (Keep keep : {Keep::covered, Keep::others})
    scans_.push_back(scan_between(crossing, inside, swap, keep));
}

template <int D>
std::size_t Grid<D>::entry_count() const {
  std::size_t sum = 0;
  for (const auto& side : sides_) sum += side->stripes.entry_count();
  return sum;
}

template <int D>
std::vector<std::size_t> Grid<D>::work_by_stripe() const {
  std::vector<std::size_t> work(partition_.stripes(), 1);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const std::vector<std::size_t> crossing = sides_[i]->giants.crossing_counts(partition_);
    for (std::size_t stripe = 0; stripe < work.size(); ++stripe) {
      const std::size_t boxes = sides_[i]->stripes.entries(stripe).size();
      const std::size_t others = sides_[sides_.size() - 1 - i]->stripes.entries(stripe).size();
      work[stripe] += boxes + crossing[stripe] * (1 + others / lanes_max);
    }
  }
  return work;
}

template <int D>
std::size_t Grid<D>::giant_count() const {
  std::size_t sum = 0;
  for (const auto& side : sides_) sum += side->stripes.giants().size();
  return sum;
}

template <int D>
std::string Grid<D>::describe() const {
  std::string counts, heights;
  for (int axis = 1; axis < D; ++axis) {
    const char* between = axis > 1 ? " x " : "";
    char height[32];
    std::snprintf(height, sizeof height, "%.3g", stripe_height_[axis]);
    counts += between + std::to_string(partition_.axis[axis].count);
    heights += between + std::string(height);
  }
  return (D == 1 ? "one stripe, " : counts + " stripes of " + heights + ", ") +
         std::to_string(entry_count()) + " entries, " + std::to_string(giant_count()) + " giants outside";
}

template class Grid<1>;
template class Grid<2>;
template class Grid<3>;
template class GridVisit<1>;
template class GridVisit<2>;
template class GridVisit<3>;

}  // namespace foresee::gpcd
