// Sort items of a leaf order: an object's position and velocity at the clock's time, in comparable units.
//
//   OrderItems<2> items(state, records.data());                 // positions are relative to the first object's
//   const OrderItem<2> item = items.of(record, 7);
//   const std::size_t axis = widest_axis<2>(some_items);        // of position or velocity
//
// A velocity counts as the distance that it covers in part of a horizon. Single precision suffices: the order
// affects the cost of queries, not their results.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "index/tpr_tree/tree_state.h"

namespace foresee {

template <int D>
struct OrderItem {
  std::array<float, 2 * D> place;  ///< position, velocity
  std::uint32_t index;
};

template <int D>
class OrderItems {
 public:
  OrderItems(const TreeState<D>& state, const double* first)
      : reader_(state.reader),
        now_(state.clock.now()),
        velocity_weight_(look_ahead * state.horizon),
        origin_(reader_.motion(first).x) {}

  OrderItem<D> of(const double* record, std::uint32_t index) const {
    float reach;
    return of(record, index, reach);
  }
  /// `reach` is set to the distance that the object extends over the horizon.
  OrderItem<D> of(const double* record, std::uint32_t index, float& reach) const {
    const Mover<D> mover(reader_, record);
    const double s = now_ - mover.motion.t;
    const Vec<D> gained = mover.motion.a * s;
    const Vec<D> x = mover.motion.x - origin_ + s * (mover.motion.v + 0.5 * gained);
    const Vec<D> v = (mover.motion.v + gained) * velocity_weight_;
    OrderItem<D> item;
    for (int axis = 0; axis < D; ++axis) {
      item.place[static_cast<std::size_t>(axis)] = clamped(x[axis]);
      item.place[static_cast<std::size_t>(axis + D)] = clamped(v[axis]);
    }
    item.index = index;
    const Vec<D> growth = mover.growth * (std::max(s, 0.0) + velocity_weight_);
    reach = clamped((v.abs() + growth + reach_of(mover.extents)).maxCoeff());
    return item;
  }

 private:
  static float clamped(double value) {
    return value > -1e38 && value < 1e38 ? static_cast<float>(value) : value > 0 ? 1e38f : -1e38f;
  }

  LeafReader<D> reader_;
  double now_, velocity_weight_;
  Vec<D> origin_;
};

/// The axis of position or velocity with the largest spread in a sample.
template <int D>
std::size_t widest_axis(std::span<const OrderItem<D>> items) {
  constexpr std::size_t samples = 20;
  const std::size_t step = (items.size() + samples - 1) / samples;
  std::size_t best = 0;
  float max_spread = -1;
  for (std::size_t along = 0; along < 2 * D; ++along) {
    std::array<float, samples> sample;
    std::size_t count = 0;
    for (std::size_t i = 0; i < items.size(); i += step) sample[count++] = items[i].place[along];
    std::sort(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(count));
    const float spread = sample[count - 1 - count / 10] - sample[count / 10];
    if (spread > max_spread) best = along, max_spread = spread;
  }
  return best;
}

}  // namespace foresee
