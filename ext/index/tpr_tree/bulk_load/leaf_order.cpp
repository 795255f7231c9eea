#include "index/tpr_tree/bulk_load/leaf_order.h"

#include <optional>

#include "base/interrupt_steps.h"
#include "index/tpr_tree/bulk_load/leaf_order_items.h"

namespace foresee {
namespace {

template <int D, bool timed>
class LeafOrder {
 public:
  using Items = OrderItems<D, timed>;
  using Item = typename Items::Item;

  LeafOrder(const TreeState<D>& state, std::span<const double> records,
            const std::vector<std::size_t>& levels, LeafRange leaves, Interrupt& interrupt)
      : state_(state),
        records_(records),
        levels_(levels),
        leaves_(leaves),
        interrupt_(interrupt),
        step_(interrupt),
        order_(state, records),
        items_(records.size() / state.reader.record_size()) {}

  std::vector<std::uint32_t> order() {
    fill();
    const std::size_t giants = move_giants_last(), inert = move_inert_last(giants);
    std::size_t first = leaves_.first;
    for (const std::size_t end : {endless_before(0, inert, true), inert, endless_before(inert, giants, true),
                                  giants, endless_before(giants, items_.size(), false), items_.size()}) {
      const std::size_t last = leaves_.first + end * leaves_.count / items_.size();
      halve(first, last);
      first = last;
    }
    std::vector<std::uint32_t> order(items_.size());
    for (std::size_t i = 0; i < order.size(); step_(), ++i) order[i] = items_[i].index;
    return order;
  }

 private:
  void fill() {
    reach_.resize(items_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (i % 4096 == 0) interrupt_.check();
      items_[i] = order_.of(records_.data() + i * state_.reader.record_size(), static_cast<std::uint32_t>(i),
                            reach_[i]);
    }
  }

  /// Moves objects with far more than the median reach to the end; returns the number of the others.
  std::size_t move_giants_last() {
    std::vector<float> sample;
    for (std::size_t i = 0; i < items_.size(); i += items_.size() / 1024 + 1) sample.push_back(reach_[i]);
    std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2),
                     sample.end());
    const float limit = 16 * sample[sample.size() / 2];
    const auto end = std::partition(items_.begin(), items_.end(), [&](const Item& item) {
      step_();
      return reach_[item.index] <= limit;
    });
    return static_cast<std::size_t>(end - items_.begin());
  }

  /// Moves the objects that may meet none of all to the end of the first `count` items; returns where they start.
  std::size_t move_inert_last(std::size_t count) {
    if (!state_.reader.has_kinds()) return count;
    Kinds all = Kinds::none();
    for (const Item& item : items_) {
      step_();
      all.include(kinds_of_item(item));
    }
    const auto begin = items_.begin(), end = begin + static_cast<std::ptrdiff_t>(count);
    const auto inert = std::partition(begin, end, [&](const Item& item) {
      step_();
      return may_meet(kinds_of_item(item), all);
    });
    return static_cast<std::size_t>(inert - begin);
  }

  Kinds kinds_of_item(const Item& item) const {
    return state_.reader.kinds(records_.data() + item.index * state_.reader.record_size());
  }

  /// Moves the objects without an end to one side of some items; returns where the sides meet. In a leaf of
  /// legs such an object would let queries of every time visit it.
  std::size_t endless_before(std::size_t first, std::size_t last, bool before) {
    if constexpr (!timed) return before ? last : first;
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(first),
               end = items_.begin() + static_cast<std::ptrdiff_t>(last);
    const auto middle = std::partition(begin, end, [&](const Item& item) {
      step_();
      return is_endless(item) == before;
    });
    return static_cast<std::size_t>(middle - items_.begin());
  }

  bool is_endless(const Item& item) const {
    const double* record = records_.data() + item.index * state_.reader.record_size();
    return !(state_.reader.until(record) < std::numeric_limits<double>::infinity());
  }

  /// Orders the objects of leaves [first, last).
  void halve(std::size_t first, std::size_t last) {
    while (last - first > 1) {
      interrupt_.check();
      const std::span<const Item> items(items_.data() + object(first), items_.data() + object(last));
      const std::size_t along = order_.widest_axis(items);
      const std::optional<float> time = along == 2 * D ? order_.time_of_cut(items) : std::nullopt;
      const LeafRange between = time ? cut_in_time(first, *time, last) : cut(first, along, last);
      halve(first, between.first);
      first = between.first + between.count;
    }
  }

  /// Moves the objects of leaves [first, last) to the side of a boundary between nodes where they belong.
  LeafRange cut(std::size_t first, std::size_t along, std::size_t last) {
    const std::size_t middle = boundary_near_middle(first, last);
    place_nth(object(first), object(middle), object(last),
              [along](const Item& a, const Item& b) { return a.place[along] < b.place[along]; });
    return {middle, 0};
  }

  /// Separates the objects before a time from the others. Returns the leaf that has objects of both sides, if there is
  /// one; they are those at one border of space, so that few queries visit it.
  LeafRange cut_in_time(std::size_t first, float time, std::size_t last) {
    const auto begin = items_.begin() + object(first), end = items_.begin() + object(last);
    const auto later = std::partition(begin, end, [&](const Item& item) {
      step_();
      return item.place.back() < time;
    });
    const std::ptrdiff_t at = later - items_.begin();
    std::size_t mixed = leaves_.first + static_cast<std::size_t>(at) * leaves_.count / items_.size();
    while (object(mixed) > at) --mixed;
    while (object(mixed + 1) <= at) ++mixed;
    if (object(mixed) == at) return {mixed, 0};
    const auto is_left = [](const Item& a, const Item& b) { return a.place[0] < b.place[0]; };
    place_nth(object(first), object(mixed), at, is_left);
    place_nth(at, object(mixed + 1), object(last),
              [&](const Item& a, const Item& b) { return is_left(b, a); });
    return {mixed, 1};
  }

  /// std::nth_element() of the items [first, last), with checks for interrupts.
  template <class Before>
  void place_nth(std::ptrdiff_t first, std::ptrdiff_t nth, std::ptrdiff_t last, Before before) {
    std::nth_element(items_.begin() + first, items_.begin() + nth, items_.begin() + last,
                     [&](const Item& a, const Item& b) {
                       step_();
                       return before(a, b);
                     });
  }

  std::ptrdiff_t object(std::size_t leaf) const {
    return static_cast<std::ptrdiff_t>(first_child(leaf - leaves_.first, leaves_.count, items_.size()));
  }

  /// The boundary between two nodes, of the highest level with a boundary strictly between two leaves.
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

  const TreeState<D>& state_;
  std::span<const double> records_;
  const std::vector<std::size_t>& levels_;
  LeafRange leaves_;
  Interrupt& interrupt_;
  Steps step_;
  Items order_;
  std::vector<Item> items_;
  std::vector<float> reach_;  ///< how far an object extends over the horizon, by record
};

}  // namespace

std::vector<std::size_t> level_sizes(std::size_t leaves, std::size_t inner_capacity) {
  std::vector<std::size_t> levels{leaves};
  while (levels.back() > 1) levels.push_back((levels.back() + inner_capacity - 1) / inner_capacity);
  return levels;
}

template <int D>
std::vector<std::uint32_t> leaf_order(const TreeState<D>& state, std::span<const double> records,
                                      const std::vector<std::size_t>& levels, LeafRange leaves,
                                      Interrupt& interrupt) {
  if (state.reader.ends()) return LeafOrder<D, true>(state, records, levels, leaves, interrupt).order();
  return LeafOrder<D, false>(state, records, levels, leaves, interrupt).order();
}

template std::vector<std::uint32_t> leaf_order<1>(const TreeState<1>&, std::span<const double>,
                                                  const std::vector<std::size_t>&, LeafRange, Interrupt&);
template std::vector<std::uint32_t> leaf_order<2>(const TreeState<2>&, std::span<const double>,
                                                  const std::vector<std::size_t>&, LeafRange, Interrupt&);
template std::vector<std::uint32_t> leaf_order<3>(const TreeState<3>&, std::span<const double>,
                                                  const std::vector<std::size_t>&, LeafRange, Interrupt&);

}  // namespace foresee
