#include "index/tpr_tree/order.h"

#include <array>

#include "base/steps.h"

namespace foresee::index {
namespace {

/// An object while it is being sorted: where it is now and how it moves, in comparable units.
template <int D>
struct Item {
  std::array<float, 2 * D> place;
  std::uint32_t index;
};

float clamped(double value) {
  return value > -1e38 && value < 1e38 ? static_cast<float>(value) : value > 0 ? 1e38f : -1e38f;
}

template <int D>
class LeafOrder {
 public:
  LeafOrder(const TreeState<D>& state, std::span<const double> records,
            const std::vector<std::size_t>& levels, Interrupt& interrupt)
      : state_(state),
        records_(records),
        levels_(levels),
        interrupt_(interrupt),
        step_(interrupt),
        items_(records.size() / state.reader.record_size()) {}

  std::vector<std::uint32_t> order() {
    fill();
    const std::size_t plain_leaves = plain_first() * levels_[0] / items_.size();
    halve(0, plain_leaves);
    halve(plain_leaves, levels_[0]);
    std::vector<std::uint32_t> order(items_.size());
    for (std::size_t i = 0; i < order.size(); step_(), ++i) order[i] = items_[i].index;
    return order;
  }

 private:
  void fill() {
    const double now = state_.clock.now(), velocity_weight = look_ahead * state_.horizon;
    const Vec<D> origin = state_.reader.motion(records_.data()).x;
    reach_.resize(items_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (i % 4096 == 0) interrupt_.check();
      const Mover<D> mover(state_.reader, records_.data() + i * state_.reader.record_size());
      const double s = now - mover.motion.t;
      const Vec<D> gained = mover.motion.a * s;
      const Vec<D> x = mover.motion.x - origin + s * (mover.motion.v + 0.5 * gained);
      const Vec<D> v = (mover.motion.v + gained) * velocity_weight;
      for (int axis = 0; axis < D; ++axis) {
        items_[i].place[static_cast<std::size_t>(axis)] = clamped(x[axis]);
        items_[i].place[static_cast<std::size_t>(axis + D)] = clamped(v[axis]);
      }
      items_[i].index = static_cast<std::uint32_t>(i);
      const Vec<D> growth = mover.growth * (std::max(s, 0.0) + velocity_weight);
      reach_[i] = clamped((v.abs() + growth + reach_of(mover.extents)).maxCoeff());
    }
  }

  /// Moves objects of far more than median reach to the end; returns how many are left in front.
  std::size_t plain_first() {
    std::vector<float> sample;
    for (std::size_t i = 0; i < items_.size(); i += items_.size() / 1024 + 1) sample.push_back(reach_[i]);
    std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2),
                     sample.end());
    const float most = 16 * sample[sample.size() / 2];
    const auto end = std::partition(items_.begin(), items_.end(),
                                    [&](const Item<D>& item) { return step_(), reach_[item.index] <= most; });
    return static_cast<std::size_t>(end - items_.begin());
  }

  /// Orders the objects of leaves [first, last).
  void halve(std::size_t first, std::size_t last) {
    while (last - first > 1) {
      interrupt_.check();
      const std::size_t middle = boundary_near_middle(first, last);
      const auto begin = items_.begin() + object(first), nth = items_.begin() + object(middle),
                 end = items_.begin() + object(last);
      const std::size_t along = widest(object(first), object(last));
      std::nth_element(begin, nth, end, [this, along](const Item<D>& a, const Item<D>& b) {
        step_();
        return a.place[along] < b.place[along];
      });
      halve(first, middle);
      first = middle;
    }
  }

  std::ptrdiff_t object(std::size_t leaf) const {
    return static_cast<std::ptrdiff_t>(first_child(leaf, levels_[0], items_.size()));
  }

  /// The boundary between two nodes of the highest level that has one strictly between two leaves.
  std::size_t boundary_near_middle(std::size_t first, std::size_t last) const {
    const std::size_t middle = first + (last - first) / 2;
    for (std::size_t level = levels_.size(); level-- > 1;) {
      const std::size_t nodes = levels_[level];
      std::size_t best = first;
      for (std::size_t node = middle * nodes / levels_[0], i = 0; i < 2 && node + i < nodes; ++i) {
        std::size_t leaf = node + i;
        for (std::size_t below = level; below-- > 0;)
          leaf = first_child(leaf, levels_[below + 1], levels_[below]);
        auto distance = [middle](std::size_t a) { return a > middle ? a - middle : middle - a; };
        if (leaf > first && leaf < last && (best == first || distance(leaf) < distance(best))) best = leaf;
      }
      if (best != first) return best;
    }
    return middle;
  }

  /// The axis of position or velocity on which a sample is most spread out.
  std::size_t widest(std::ptrdiff_t first, std::ptrdiff_t last) const {
    constexpr std::ptrdiff_t samples = 20;
    const std::ptrdiff_t step = (last - first + samples - 1) / samples;
    std::size_t best = 0;
    float most = -1;
    for (std::size_t along = 0; along < 2 * D; ++along) {
      std::array<float, samples> sample;
      std::size_t count = 0;
      for (std::ptrdiff_t i = first; i < last; i += step)
        sample[count++] = items_[static_cast<std::size_t>(i)].place[along];
      std::sort(sample.begin(), sample.begin() + count);
      const float spread = sample[count - 1 - count / 10] - sample[count / 10];
      if (spread > most) best = along, most = spread;
    }
    return best;
  }

  const TreeState<D>& state_;
  std::span<const double> records_;
  const std::vector<std::size_t>& levels_;
  Interrupt& interrupt_;
  Steps step_;
  std::vector<Item<D>> items_;
  std::vector<float> reach_;  ///< how far an object sticks out over the horizon, by record
};

}  // namespace

std::vector<std::size_t> level_sizes(std::size_t leaves, std::size_t inner_capacity) {
  std::vector<std::size_t> levels{leaves};
  while (levels.back() > 1) levels.push_back((levels.back() + inner_capacity - 1) / inner_capacity);
  return levels;
}

template <int D>
std::vector<std::uint32_t> leaf_order(const TreeState<D>& state, std::span<const double> records,
                                      const std::vector<std::size_t>& levels, Interrupt& interrupt) {
  return LeafOrder<D>(state, records, levels, interrupt).order();
}

template std::vector<std::uint32_t> leaf_order<1>(const TreeState<1>&, std::span<const double>,
                                                  const std::vector<std::size_t>&, Interrupt&);
template std::vector<std::uint32_t> leaf_order<2>(const TreeState<2>&, std::span<const double>,
                                                  const std::vector<std::size_t>&, Interrupt&);
template std::vector<std::uint32_t> leaf_order<3>(const TreeState<3>&, std::span<const double>,
                                                  const std::vector<std::size_t>&, Interrupt&);

}  // namespace foresee::index
