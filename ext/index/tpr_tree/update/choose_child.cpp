#include "index/tpr_tree/update/choose_child.h"

#include <array>

namespace foresee {
namespace {

/// The side of a typical query: half the mean width of some of the children.
template <int D>
double typical_query(const Node& inner, const VisitCost<D>& cost) {
  constexpr std::size_t limit = 8;
  const std::size_t step = (inner.size() + limit - 1) / limit;
  std::array<double, limit> widths;
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < inner.size(); slot += step)
    widths[count++] = cost.mean_width(bounds_at<D>(inner, slot));
  std::nth_element(widths.begin(), widths.begin() + count / 2, widths.begin() + count);
  return 0.5 * widths[count / 2];
}

}  // namespace

template <int D>
ChildChoice<D>::ChildChoice(const Node& inner, const VisitCost<D>& cost)
    : children_(inner.size()),
      cost_(cost),
      query_(typical_query(inner, cost)),
      faces_(children_ * faces * D),
      widths_(children_ * faces / 2 * D),
      product_(children_),
      before_(children_),
      after_(children_) {
  for (std::size_t slot = 0; slot < children_; ++slot) {
    const double* from = inner.values.data() + slot * entry_size(D) + times_size;
    for (std::size_t part = 0; part < faces * D; ++part) faces_[part * children_ + slot] = from[part];
  }
  costs_with(Bounds<D>::nothing(), before_);
}

/// The cost of each child with `added` in it, as in VisitCost, for all children in columns.
template <int D>
void ChildChoice<D>::costs_with(const Bounds<D>& added, std::vector<double>& costs) {
  const Vec<D>* ends[] = {&added.x_lower, &added.x_upper, &added.v_lower,
                          &added.v_upper, &added.a_lower, &added.a_upper};
  for (int part = 0; part < faces; part += 2) {
    const double more = part == x_lower ? query_ : 0, share = part == a_lower ? 0.5 : 1;
    for (int axis = 0; axis < D; ++axis) {
      const double *lowest = face(part, axis), *highest = face(part + 1, axis);
      const double low = (*ends[part])[axis], high = (*ends[part + 1])[axis];
      double* width = widths_.data() + static_cast<std::size_t>(part / 2 * D + axis) * children_;
      for (std::size_t slot = 0; slot < children_; ++slot)
        width[slot] =
            ((highest[slot] > high ? highest[slot] : high) - (lowest[slot] < low ? lowest[slot] : low)) *
                share +
            more;
    }
  }
  std::fill(costs.begin(), costs.end(), 0.0);
  for (int time = 0; time < 3; ++time) {
    const double s = cost_.elapsed(time);
    std::fill(product_.begin(), product_.end(), time == 1 ? 4.0 : 1.0);
    for (int axis = 0; axis < D; ++axis) {
      const double* x = widths_.data() + static_cast<std::size_t>(axis) * children_;
      const double *v = x + D * children_, *a = v + D * children_;
      for (std::size_t slot = 0; slot < children_; ++slot)
        product_[slot] *= VisitCost<D>::within_reason(x[slot] + s * (v[slot] + s * a[slot]));
    }
    for (std::size_t slot = 0; slot < children_; ++slot) costs[slot] += product_[slot];
  }
}

template <int D>
std::size_t ChildChoice<D>::choose(const Bounds<D>& added) {
  costs_with(added, after_);
  std::size_t best = 0;
  double min_growth = std::numeric_limits<double>::infinity(), min_cost = min_growth;
  for (std::size_t slot = 0; slot < children_; ++slot) {
    const double growth = after_[slot] - before_[slot];
    if (growth < min_growth || (growth == min_growth && before_[slot] < min_cost))
      best = slot, min_growth = growth, min_cost = before_[slot];
  }
  return best;
}

template <int D>
std::vector<Growth> growths(const Node& inner, const Bounds<D>& added, const VisitCost<D>& cost,
                            double query) {
  std::vector<Growth> all;
  all.reserve(inner.size());
  for (std::size_t slot = 0; slot < inner.size(); ++slot) {
    Bounds<D> both = bounds_at<D>(inner, slot);
    const double apart = cost(both, query);
    both.include(added);
    all.push_back({cost(both, query) - apart, slot});
  }
  return all;
}

template <int D>
std::vector<std::size_t> closest_children(const TreeState<D>& state, const Node& above, NodeNumber number,
                                          std::size_t limit) {
  const VisitCost<D> cost = state.cost(above.epoch);
  const std::size_t own = slot_of(above, number);
  const Bounds<D> bounds = bounds_at<D>(above, own);
  std::vector<Growth> all = growths(above, bounds, cost, 0.1 * cost.mean_width(bounds));
  all[own].cost = -std::numeric_limits<double>::infinity();
  std::vector<std::size_t> closest(std::min(limit, all.size()));
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(closest.size()), all.end());
  for (std::size_t i = 0; i < closest.size(); ++i) closest[i] = all[i].slot;
  return closest;
}

template <int D>
std::size_t closest_sibling(const TreeState<D>& state, const Node& above, NodeNumber number) {
  return closest_children(state, above, number, 2).back();
}

#define FORESEE_OF_AXES(D)                                                                          \
  template class ChildChoice<D>;                                                                    \
  template std::vector<Growth> growths(const Node&, const Bounds<D>&, const VisitCost<D>&, double); \
  template std::vector<std::size_t> closest_children(const TreeState<D>&, const Node&, NodeNumber,  \
                                                     std::size_t);                                  \
  template std::size_t closest_sibling(const TreeState<D>&, const Node&, NodeNumber)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
