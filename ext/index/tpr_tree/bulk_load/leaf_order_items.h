// Sort items of a leaf order: an object's position and velocity at its reference time, and that time, in
// comparable units.
//
//   OrderItems<2, true> items(state, records);                  // positions are relative to the first object's
//   const auto item = items.of(record, 7);
//   const std::size_t axis = items.widest_axis(some_items);     // of position, velocity or time
//
// A velocity counts as the distance that it covers in part of a horizon, or in a median life if that is
// shorter. A reference time (reference_times.h) counts as the distance that an object of median speed covers in
// `time_weight` times as long. Only the spread beyond half a median life counts: a cut does not separate objects
// that live together. Without an end the reference time is the clock, and the order is that of a table without
// `until`. Single precision suffices: the order affects the cost of queries, not their results.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/repeatable_choice.h"
#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Timed: the table declares `until`.
template <int D, bool timed>
struct OrderItem {
  static constexpr std::size_t axes = 2 * D + (timed ? 1 : 0);

  std::array<float, axes> place;  ///< position, velocity, time
  std::uint32_t index;
};

template <int D, bool timed>
class OrderItems {
 public:
  using Item = OrderItem<D, timed>;

  /// Requires: records, or a sample of them.
  OrderItems(const TreeState<D>& state, std::span<const double> records)
      : reader_(state.reader),
        times_(state.reference_times()),
        now_(state.clock.now()),
        velocity_weight_(look_ahead * state.horizon),
        origin_(reader_.motion(records.data()).x) {
    if constexpr (timed) measure(records);
  }

  Item of(const double* record, std::uint32_t index) const {
    float reach;
    return of(record, index, reach);
  }
  /// `reach` is set to the distance that the object extends over the horizon.
  Item of(const double* record, std::uint32_t index, float& reach) const {
    const Mover<D> mover = reader_.is_plain() ? Mover<D>::plain(reader_, record) : Mover<D>(reader_, record);
    double at = now_, velocity_weight = velocity_weight_;
    if constexpr (timed) {
      const Times times = times_of_one(mover.motion);
      if (!times_.is_clock(times)) at = times_.of(times), velocity_weight = scheduled_velocity_weight_;
    }
    const double s = at - mover.motion.t;
    const Vec<D> gained = mover.motion.a * s;
    const Vec<D> x = mover.motion.x - origin_ + s * (mover.motion.v + 0.5 * gained);
    const Vec<D> v = (mover.motion.v + gained) * velocity_weight;
    Item item;
    for (int axis = 0; axis < D; ++axis) {
      item.place[static_cast<std::size_t>(axis)] = clamped(x[axis]);
      item.place[static_cast<std::size_t>(axis + D)] = clamped(v[axis]);
    }
    if constexpr (timed) item.place[2 * D] = clamped((at - now_) * distance_per_time_);
    item.index = index;
    const Vec<D> growth = mover.growth * (std::max(s, 0.0) + velocity_weight);
    reach = clamped((v.abs() + growth + reach_of(mover.extents)).largest());
    return item;
  }

  /// The axis with the largest spread in a sample.
  std::size_t widest_axis(std::span<const Item> items) const {
    std::size_t best = 0;
    float max_spread = -1;
    for (std::size_t along = 0; along < Item::axes; ++along) {
      float spread = spread_of(items, along);
      if (along == 2 * D) spread -= shared_;
      if (spread > max_spread) best = along, max_spread = spread;
    }
    return best;
  }

  /// Where to cut objects in time, near their middle; nothing if any cut is as good. It is within the widest gap
  /// between the reference times of a sample, if that is longer than half a median life. Then hardly any objects of
  /// both sides exist together. Without such a gap, objects that share the middle time remain together. Some objects
  /// are before the time, and some are not.
  std::optional<float> time_of_cut(std::span<const Item> items) const {
    std::array<float, 256> sample{};
    const std::size_t count = draw(items, 2 * D, sample), margin = count / 8;
    const float spacing = (sample[count - 1] - sample[0]) / static_cast<float>(count);
    float widest = std::max(shared_, 4 * spacing);
    std::optional<float> time;
    for (std::size_t i = margin + 1; i + margin < count; ++i)
      if (const float gap = sample[i] - sample[i - 1]; gap > widest) {
        widest = gap, time = sample[i - 1] + 0.5f * gap;
        if (!(sample[i - 1] < *time)) time = sample[i];  // no float is between the two
      }
    return time ? time : beside_equals(std::span(sample).first(count));
  }

 private:
  static constexpr std::size_t samples = 20;
  /// So large that nodes are separated in time first. A node is bounded at one time, so one that covers several lives
  /// is wide at all others. With 10 and a whole life, windows over chunks of plans visited three times as many leaves.
  static constexpr double time_weight = 40;

  static Times times_of_one(const Motion<D>& motion) { return {motion.t, motion.t, motion.until}; }

  static float clamped(double value) {
    return value > -1e38 && value < 1e38 ? static_cast<float>(value) : value > 0 ? 1e38f : -1e38f;
  }

  /// The place of one sample per `step` items. In a table of schedules the rows of a mover follow each other:
  /// equal steps might find the same leg of every mover.
  static std::size_t scattered(std::size_t i, std::size_t step, std::size_t count) {
    const std::uint64_t random = (i / step * by_golden_ratio) >> 32;
    return std::min(i + static_cast<std::size_t>(random * step >> 32), count - 1);
  }

  /// The places of some of the items along an axis, ascending; returns how many.
  std::size_t draw(std::span<const Item> items, std::size_t along, std::span<float> sample) const {
    const std::size_t step = (items.size() + sample.size() - 1) / sample.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < items.size(); i += step)
      sample[count++] = items[is_schedule_ ? scattered(i, step, items.size()) : i].place[along];
    std::sort(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  /// The nearer end of the middle times of a sample that are equal; nothing if no two are.
  static std::optional<float> beside_equals(std::span<const float> sample) {
    const std::size_t middle = sample.size() / 2;
    const auto [first, last] = std::equal_range(sample.begin(), sample.end(), sample[middle]);
    const auto before = static_cast<std::size_t>(first - sample.begin()),
               after = static_cast<std::size_t>(last - sample.begin());
    if (after - before < 2) return std::nullopt;
    if (after < sample.size() && (before == 0 || after - middle < middle - before)) return *last;
    return before > 0 ? std::optional(sample[middle]) : std::nullopt;
  }

  /// The distance between the first and the last tenth of some of the items.
  float spread_of(std::span<const Item> items, std::size_t along) const {
    std::array<float, samples> sample;
    const std::size_t count = draw(items, along, sample);
    return sample[count - 1 - count / 10] - sample[count / 10];
  }

  static double median_or(std::vector<double>& values, double otherwise) {
    if (values.empty()) return otherwise;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  /// Sets the unit of time, from a sample of the objects whose lives are not current: their median speed. If
  /// none of them moves, the spread in time counts as much as the spread along the widest axis.
  void measure(std::span<const double> records) {
    const std::size_t size = reader_.record_size(), count = records.size() / size, step = count / 1024 + 1;
    std::vector<double> speeds, lives;
    std::vector<Item> some;
    for (std::size_t i = 0; i < count; i += step) {
      const double* record = records.data() + scattered(i, step, count) * size;
      const Motion<D> motion = reader_.motion(record);
      const Times times = times_of_one(motion);
      if (times_.is_clock(times)) continue;
      lives.push_back(std::min(motion.until - motion.t, 1e100));
      const double speed = (motion.v + motion.a * (times_.of(times) - motion.t)).length();
      if (speed > 0) speeds.push_back(speed);
      distance_per_time_ = 1;
      some.push_back(of(record, 0));
    }
    is_schedule_ = !some.empty();
    distance_per_time_ = time_weight * median_or(speeds, 0);
    if (speeds.empty() && !some.empty()) {
      float widest = 0;
      for (std::size_t axis = 0; axis < D; ++axis) widest = std::max(widest, spread_of(some, axis));
      const float time = spread_of(some, 2 * D);
      distance_per_time_ = time > 0 ? widest / time : 0;
    }
    const double life = median_or(lives, 0);
    shared_ = clamped(0.5 * life * distance_per_time_);
    scheduled_velocity_weight_ = std::min(velocity_weight_, life);
  }

  LeafReader<D> reader_;
  ReferenceTimes times_;
  double now_, velocity_weight_;
  double scheduled_velocity_weight_ = velocity_weight_;  ///< of objects whose lives are not current
  Vec<D> origin_;
  bool is_schedule_ = false;  ///< some lives of the sample are not current
  double distance_per_time_ = 0;
  float shared_ = 0;  ///< the spread in time of objects that mostly live together
};

}  // namespace foresee
