// Movers of a scene: which rows are the legs of one object, and when each leg exists.
//
//   const Movers ships(scene);
//   for (std::uint32_t leg = ships.first(7); leg < ships.last(7); ++leg) use(ships.t(leg), ships.until(leg));
//
// A mover is an object with or without a plan: its rows follow each other, in order of time. In a scene of a layout
// without plans each row is a mover. LegPairs gives the legs of two movers that exist together, in order of time: a
// step per leg, and one for each further pair of legs that share a time. Memory: 4 bytes per leg.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
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
  std::uint32_t mover_of(std::uint32_t row) const { return has_legs_ ? of_[row] : row; }
  /// Those of rows of this scene and of another.
  Pair movers_of(const Pair& rows, const Movers& others) const {
    return {mover_of(rows.a), others.mover_of(rows.b)};
  }
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

/// The pairs of legs of two movers that exist together, in order of the time from which both exist. The sides must
/// outlive it.
class LegPairs {
 public:
  /// Both legs exist at `from` or later.
  LegPairs(const Movers& a, const Movers& b, const Pair& movers, double from)
      : a_(&a),
        b_(&b),
        a_leg_(a.first_until(movers.a, from)),
        last_a_(a.last(movers.a)),
        first_b_(b.first_until(movers.b, from)),
        b_leg_(first_b_),
        last_b_(b.last(movers.b)) {}
  /// Those behind `legs`.
  LegPairs(const Movers& a, const Movers& b, const Pair& legs)
      : a_(&a),
        b_(&b),
        a_leg_(legs.a),
        last_a_(a.last(a.mover_of(legs.a))),
        first_b_(legs.b),
        b_leg_(legs.b + 1),
        last_b_(b.last(b.mover_of(legs.b))) {}

  std::optional<Pair> next() {
    for (; a_leg_ < last_a_; b_leg_ = first_b_) {
      while (first_b_ < last_b_ && b_->until(first_b_) < a_->t(a_leg_)) ++first_b_;
      if (first_b_ == last_b_) return std::nullopt;
      b_leg_ = std::max(b_leg_, first_b_);
      if (b_leg_ < last_b_ && b_->t(b_leg_) <= a_->until(a_leg_)) return Pair{a_leg_, b_leg_++};
      ++a_leg_;
    }
    return std::nullopt;
  }

 private:
  const Movers *a_, *b_;
  std::uint32_t a_leg_, last_a_, first_b_, b_leg_, last_b_;
};

/// Calls take(rows) for each of LegPairs. Ends early where take() returns false.
template <class Take>
void for_leg_pairs(const Movers& a, const Movers& b, const Pair& movers, double from, Take take) {
  LegPairs pairs(a, b, movers, from);
  for (auto legs = pairs.next(); legs && take(*legs); legs = pairs.next()) {
  }
}

}  // namespace foresee
