#include "query/legs/slab_legs.h"

#include <algorithm>
#include <numeric>

namespace foresee {

SlabLegs::SlabLegs(const Movers& movers, const LegTimes& all, Slabs slabs)
    : movers_(movers), is_whole_(takes_whole(all, slabs)) {
  if (is_whole_) return;
  const Scene& whole = *movers.scene();
  waiting_.reserve(movers.count());
  for (std::uint32_t mover = 0; mover < movers.count(); ++mover) {
    const std::uint32_t first = movers.first_until(mover, all.from), last = last_leg(mover, first, all.until);
    if (first < last) waiting_.push_back({movers.t(first), first, last, mover});
  }
  scene_ = std::make_shared<Scene>();
  scene_->name = whole.name, scene_->layout = whole.layout;
  const auto starts_before = [](const Left& l, const Left& r) { return l.t < r.t; };
  if (!std::is_sorted(waiting_.begin(), waiting_.end(), starts_before))
    std::stable_sort(waiting_.begin(), waiting_.end(), starts_before);
}

/// One past the last leg, from `first` on, that starts by `until`.
std::uint32_t SlabLegs::last_leg(std::uint32_t mover, std::uint32_t first, double until) const {
  const std::uint32_t last = movers_.last(mover);
  if (first < last && movers_.t(last - 1) <= until) return last;
  return first_row(first, last, [&](std::uint32_t leg) { return movers_.t(leg) > until; });
}

bool SlabLegs::takes_whole(const LegTimes& all, Slabs slabs) const {
  const std::size_t rows = movers_.scene()->size();
  if (slabs == Slabs::whole || movers_.scene()->forms) return true;
  if (slabs == Slabs::one) {
    std::size_t alive = 0;
    for (std::uint32_t mover = 0; mover < movers_.count(); ++mover) {
      const std::uint32_t first = movers_.first_until(mover, all.from);
      alive += last_leg(mover, first, all.until) - first;
    }
    return alive >= rows - rows / 4;
  }
  if (movers_.count() < rows) return false;
  double lives = 0;
  for (std::uint32_t row = 0; row < rows; ++row)
    lives += std::max(0.0, std::min(movers_.until(row), all.until) - std::max(movers_.t(row), all.from));
  return lives >= 0.75 * static_cast<double>(rows) * (all.until - all.from);
}

void SlabLegs::take(const LegTimes& times) {
  if (is_whole_) return;
  scene_->ids.clear();
  scene_->rows.clear();
  scene_->kinds.reset();
  legs_.clear();
  numbers_.clear();
  std::size_t kept = 0;
  for (Left& left : current_) {
    take_legs(left, times);
    if (left.first < left.last) current_[kept++] = left;
  }
  current_.resize(kept);
  // In the order of the scene, in which neighbours in space follow each other.
  const auto begin = waiting_.begin() + static_cast<std::ptrdiff_t>(started_);
  while (started_ < waiting_.size() && waiting_[started_].t <= times.until) ++started_;
  const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(started_);
  const auto by_mover = [](const Left& l, const Left& r) { return l.mover < r.mover; };
  if (!std::is_sorted(begin, end, by_mover)) std::sort(begin, end, by_mover);
  for (auto left = begin; left != end; ++left) {
    take_legs(*left, times);
    if (left->first < left->last) current_.push_back(*left);
  }
}

void SlabLegs::take_legs(Left& left, const LegTimes& times) {
  const Scene& whole = *movers_.scene();
  while (left.first < left.last && movers_.until(left.first) < times.from) ++left.first;
  std::uint32_t end = left.first;
  while (end < left.last && movers_.t(end) <= times.until) ++end;
  const std::size_t row_size = static_cast<std::size_t>(movers_.bodies().at.size), count = end - left.first;
  const double* const rows = whole.rows.data() + left.first * row_size;
  scene_->rows.insert(scene_->rows.end(), rows, rows + count * row_size);
  scene_->ids.insert(scene_->ids.end(), count, whole.ids[left.first < whole.size() ? left.first : 0]);
  numbers_.insert(numbers_.end(), count, left.mover);
  legs_.resize(legs_.size() + count);
  std::iota(legs_.end() - static_cast<std::ptrdiff_t>(count), legs_.end(), left.first);
}

}  // namespace foresee
