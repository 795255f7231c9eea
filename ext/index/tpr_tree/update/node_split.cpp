#include <numeric>

#include "index/tpr_tree/update/choose_child.h"

namespace foresee {
namespace {

/// The sort key of elements: their centre at half the look-ahead, or their velocity.
template <int D>
double sort_key(const Bounds<D>& b, int axis, bool by_velocity, double middle) {
  const double v = 0.5 * b.v_lower[axis] + 0.5 * b.v_upper[axis];
  const double key = by_velocity ? v : 0.5 * b.x_lower[axis] + 0.5 * b.x_upper[axis] + v * middle;
  return std::isnan(key) ? 0 : key;
}

template <int D>
class SplitSearch {
 public:
  SplitSearch(std::span<const Entry<D>> elements, const VisitCost<D>& cost)
      : elements_(elements),
        cost_(cost),
        order_(elements.size()),
        key_(elements.size()),
        from_(elements.size()) {
    Entry<D> all;
    for (const Entry<D>& element : elements) all.include(element);
    query_ = cost.query_like(0.25, all);
    middle_ = cost.middle(all.times);
  }

  void try_order(int axis, bool by_velocity) {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      key_[i] = sort_key(elements_[i].bounds, axis, by_velocity, middle_);
    try_keys();
  }

  void try_times(const ReferenceTimes& times) {
    bool any_ends = false;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const Times& own = elements_[i].times;
      any_ends = any_ends || ends(own);
      key_[i] = ends(own) ? times.of(own) : std::numeric_limits<double>::infinity();
    }
    if (any_ends) try_keys();
  }

  std::vector<std::uint32_t> leaving() const { return leaving_; }

 private:
  void try_keys() {
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
      return key_[a] != key_[b] ? key_[a] < key_[b] : a < b;
    });
    try_cuts();
  }

  /// from_[i] is set to the entry of all elements from place i of the order on.
  void try_cuts() {
    const std::size_t count = elements_.size(), min_count = std::max<std::size_t>(2, count * 2 / 5);
    Entry<D> right, left;
    for (std::size_t i = count; i-- > 0;) {
      right.include(elements_[order_[i]]);
      from_[i] = right;
    }
    std::size_t best_cut = 0;
    for (std::size_t cut = 1; cut + min_count <= count; ++cut) {
      left.include(elements_[order_[cut - 1]]);
      if (cut < min_count) continue;
      const double total = cost_(left, query_) + cost_(from_[cut], query_);
      if (total < lowest_) lowest_ = total, best_cut = cut;
    }
    if (best_cut == 0) return;
    leaving_.assign(order_.begin() + static_cast<std::ptrdiff_t>(best_cut), order_.end());
    std::sort(leaving_.begin(), leaving_.end());
  }

  std::span<const Entry<D>> elements_;
  const VisitCost<D>& cost_;
  std::vector<std::uint32_t> order_, leaving_;
  std::vector<double> key_;
  std::vector<Entry<D>> from_;
  TypicalQuery query_;
  double middle_ = 0, lowest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

template <int D>
std::vector<std::uint32_t> choose_split(std::span<const Entry<D>> elements, const VisitCost<D>& cost) {
  SplitSearch<D> search(elements, cost);
  for (int axis = 0; axis < D; ++axis) {
    search.try_order(axis, false);
    search.try_order(axis, true);
  }
  search.try_times(cost.reference_times());
  return search.leaving();
}

template std::vector<std::uint32_t> choose_split<1>(std::span<const Entry<1>>, const VisitCost<1>&);
template std::vector<std::uint32_t> choose_split<2>(std::span<const Entry<2>>, const VisitCost<2>&);
template std::vector<std::uint32_t> choose_split<3>(std::span<const Entry<3>>, const VisitCost<3>&);

}  // namespace foresee
