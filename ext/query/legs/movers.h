// Movers of a scene: which rows are the legs of one object, and when each leg exists.
//
//   const Movers ships(scene);
//   for (std::uint32_t leg = ships.first(7); leg < ships.last(7); ++leg) use(ships.t(leg), ships.until(leg));
//
// A mover is an object with or without a plan: its rows follow each other, in order of time. In a scene of a layout
// without plans each row is a mover. for_leg_pairs() gives the legs of two movers that exist together, in order of
// time: a step per leg, not per pair of legs. Memory: 4 bytes per leg.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "query/scene.h"

namespace foresee {

/// The first row of [first, last) for which is_past(row) holds; last: none. Requires: it holds for all rows behind one.
template <class Row, class IsPast>
Row first_row(Row first, Row last, IsPast is_past) {
  while (first < last) {
    const Row middle = first + (last - first) / 2;
    if (is_past(middle))
      last = middle;
    else
      first = middle + 1;
  }
  return first;
}

class Movers {
 public:
  explicit Movers(std::shared_ptr<const Scene> scene)
      : scene_(std::move(scene)),
        bodies_(scene_->bodies()),
        row_size_(static_cast<std::size_t>(bodies_.at.size)),
        has_legs_(scene_->layout.has_plan && !scene_->first_rows.empty() &&
                  scene_->first_rows.size() <= scene_->size()) {
    if (!has_legs_) return;
    of_.reserve(scene_->size());
    for (std::uint32_t mover = 0; mover < count(); ++mover)
      of_.insert(of_.end(), last(mover) - first(mover), mover);
  }

  const std::shared_ptr<const Scene>& scene() const { return scene_; }
  std::uint32_t count() const {
    return static_cast<std::uint32_t>(has_legs_ ? scene_->first_rows.size() - 1 : scene_->size());
  }
  std::uint32_t first(std::uint32_t mover) const { return has_legs_ ? scene_->first_rows[mover] : mover; }
  std::uint32_t last(std::uint32_t mover) const {
    return has_legs_ ? scene_->first_rows[mover + 1] : mover + 1;
  }
  const Bodies& bodies() const { return bodies_; }
  /// The mover of a row.
  std::uint32_t of(std::uint32_t row) const { return has_legs_ ? of_[row] : row; }
  Pair of(const Pair& rows, const Movers& others) const { return {of(rows.a), others.of(rows.b)}; }
  std::int64_t id(std::uint32_t mover) const { return scene_->ids[first(mover)]; }

  /// The first and the last time of a row; infinite without the column.
  double t(std::uint32_t row) const { return column(row, bodies_.at.t, -infinite); }
  double until(std::uint32_t row) const { return column(row, bodies_.at.until, infinite); }
  /// The first leg of a mover that ends at `time` or later.
  std::uint32_t first_until(std::uint32_t mover, double time) const {
    return first_row(first(mover), last(mover), [&](std::uint32_t leg) { return until(leg) >= time; });
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double column(std::uint32_t row, int place, double otherwise) const {
    return place == Offsets::absent ? otherwise
                                    : bodies_.rows[row * row_size_ + static_cast<std::size_t>(place)];
  }

  std::shared_ptr<const Scene> scene_;
  Bodies bodies_;
  std::size_t row_size_;
  bool has_legs_;  ///< false: each mover is one row
  std::vector<std::uint32_t> of_;
};

/// Calls take(rows) for each pair of legs of two movers that exist together, and both at `from` or later, in order of
/// the time from which both exist. Ends early where take() returns false.
template <class Take>
void for_leg_pairs(const Movers& a, const Movers& b, const Pair& movers, double from, Take take) {
  const std::uint32_t last_a = a.last(movers.a), last_b = b.last(movers.b);
  std::uint32_t first_b = b.first_until(movers.b, from);
  for (std::uint32_t leg_a = a.first_until(movers.a, from); leg_a < last_a; ++leg_a) {
    const double t = a.t(leg_a), until = a.until(leg_a);
    while (first_b < last_b && b.until(first_b) < t) ++first_b;
    if (first_b == last_b) return;
    for (std::uint32_t leg_b = first_b; leg_b < last_b && b.t(leg_b) <= until; ++leg_b)
      if (!take(Pair{leg_a, leg_b})) return;
  }
}

}  // namespace foresee
