#include "index/gpcd_grid/grid.h"

#include "index/gpcd_grid/gpcd_grid.h"

namespace foresee::gpcd {
namespace {

constexpr std::size_t sample_max = 512;
constexpr std::size_t sample_share =
    8;  // at most every eighth box, so that small scenes do not pay for statistics
constexpr std::size_t sample_enough = 64;
constexpr std::size_t pairs_per_batch = 4096;
constexpr std::size_t steps_per_batch = 1 << 17;  // about a millisecond
constexpr std::size_t boxes_per_check = 8192;

/// Non-empty boxes of both sides, one from each of some hundred equal parts, not at equal distances.
template <int D>
std::vector<Box<D>> sample_of(std::span<const Box<D>> a, std::span<const Box<D>> b) {
  const std::size_t count = a.size() + b.size(),
                    aim = std::clamp(count / sample_share, sample_enough, sample_max),
                    wanted = std::min(count, aim);
  std::vector<Box<D>> sample;
  for (std::size_t part = 0; part < wanted; ++part) {
    const std::size_t begin = part * count / wanted, end = (part + 1) * count / wanted;
    const std::size_t i = begin + (part * 0x9e3779b97f4a7c15u >> 33) % (end - begin);
    const Box<D>& box = i < a.size() ? a[i] : b[i - a.size()];
    if (!box.is_empty()) sample.push_back(box);
  }
  return sample;
}

template <int D>
std::vector<FloatBox<D>> to_floats(const Frame<D>& frame, std::span<const Box<D>> boxes,
                                   Interrupt& interrupt) {
  std::vector<FloatBox<D>> out(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i % boxes_per_check == 0) interrupt.check();
    out[i] = frame.round_outward(boxes[i]);
  }
  return out;
}

}  // namespace

template <int D>
Grid<D>::Grid(std::span<const Box<D>> boxes_a, std::span<const Box<D>> boxes_b, bool between,
              Interrupt& interrupt)
    : interrupt_(interrupt), batch_(pairs_per_batch + lanes_per_step) {
  const std::vector<Box<D>> sample = sample_of(boxes_a, boxes_b);
  const Frame<D> frame = frame_of(std::span<const Box<D>>(sample));
  const std::vector<FloatBox<D>> small_sample = to_floats(frame, std::span<const Box<D>>(sample), interrupt);
  partition_ = choose_partition(std::span<const FloatBox<D>>(small_sample), boxes_a.size() + boxes_b.size());
  sides_.reserve(2);  // scans point into the sides
  sides_.emplace_back(partition_, to_floats(frame, boxes_a, interrupt), interrupt);
  if (between) sides_.emplace_back(partition_, to_floats(frame, boxes_b, interrupt), interrupt);
}

template <int D>
bool Grid<D>::next(std::vector<Pair>& out) {
  interrupt_.check();
  std::size_t written = 0, steps = steps_per_batch;
  bool more = true;
  while (steps > 0 && written < pairs_per_batch && more) {
    if (scan_ == scans_.size()) {
      more = open_next();
      continue;
    }
    written += run(scans_[scan_], batch_.data() + written, batch_.size() - written, steps);
    if (scans_[scan_].done()) ++scan_;
  }
  steps_taken_ += steps_per_batch - steps;
  out.insert(out.end(), batch_.begin(), batch_.begin() + static_cast<std::ptrdiff_t>(written));
  return more || written > 0;
}

template <int D>
bool Grid<D>::open_next() {
  scans_.clear();
  scan_ = 0;
  if (!giants_met_) {
    giants_met_ = true;
    open_giants();
    return true;
  }
  if (next_stripe_ == partition_.stripes()) return false;
  open_stripe(next_stripe_++);
  return true;
}

template <int D>
void Grid<D>::open_giants() {
  for (Side& side : sides_) side.crossing.gather(side.giants.all(), side.stripes.boxes(), interrupt_);
  if (sides_.size() == 1)
    scans_.push_back(scan_within(sides_[0].crossing));
  else
    scans_.push_back(scan_between(sides_[0].crossing, sides_[1].crossing, false));
}

template <int D>
void Grid<D>::open_stripe(std::size_t number) {
  int stripe[D] = {};
  if constexpr (D == 2) stripe[1] = static_cast<int>(number);
  if constexpr (D == 3) {
    const auto across = static_cast<std::size_t>(partition_.axis[2].count);
    stripe[1] = static_cast<int>(number / across), stripe[2] = static_cast<int>(number % across);
  }
  for (Side& side : sides_) {
    const std::span<Key> keys = side.stripes.entries(number);
    sort_keys(keys, interrupt_);
    side.inside.gather(keys, side.stripes.boxes(), partition_, stripe, interrupt_);
    side.crossing.gather(side.giants.crossing(stripe), side.stripes.boxes(), partition_, stripe, interrupt_);
  }
  if (sides_.size() == 1) {
    scans_.push_back(scan_within(sides_[0].inside));
    scans_.push_back(scan_between(sides_[0].crossing, sides_[0].inside, false));
  } else {
    scans_.push_back(scan_between(sides_[0].inside, sides_[1].inside, false));
    scans_.push_back(scan_between(sides_[0].crossing, sides_[1].inside, false));
    scans_.push_back(scan_between(sides_[1].crossing, sides_[0].inside, true));
  }
}

template <int D>
std::size_t Grid<D>::entry_count() const {
  std::size_t sum = 0;
  for (const Side& side : sides_) sum += side.stripes.entry_count();
  return sum;
}

template <int D>
std::size_t Grid<D>::giant_count() const {
  std::size_t sum = 0;
  for (const Side& side : sides_) sum += side.stripes.giants().size();
  return sum;
}

template <int D>
std::string Grid<D>::describe() const {
  std::string counts;
  for (int axis = 1; axis < D; ++axis)
    counts += (axis > 1 ? " x " : "") + std::to_string(partition_.axis[axis].count);
  return (D == 1 ? "one stripe, " : counts + " stripes, ") + std::to_string(entry_count()) + " entries, " +
         std::to_string(giant_count()) + " giants outside";
}

template class Grid<1>;
template class Grid<2>;
template class Grid<3>;

}  // namespace foresee::gpcd

namespace foresee {

template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>> boxes, Interrupt& interrupt) {
  return std::make_unique<gpcd::Grid<D>>(boxes, std::span<const Box<D>>(), false, interrupt);
}

template <int D>
std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<D>> boxes_a, std::span<const Box<D>> boxes_b,
                                           Interrupt& interrupt) {
  return std::make_unique<gpcd::Grid<D>>(boxes_a, boxes_b, true, interrupt);
}

template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<1>>, Interrupt&);
template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<2>>, Interrupt&);
template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<3>>, Interrupt&);
template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<1>>, std::span<const Box<1>>,
                                                    Interrupt&);
template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<2>>, std::span<const Box<2>>,
                                                    Interrupt&);
template std::unique_ptr<Candidates> make_gpcd_grid(std::span<const Box<3>>, std::span<const Box<3>>,
                                                    Interrupt&);

}  // namespace foresee
