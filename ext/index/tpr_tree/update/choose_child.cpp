#include "index/tpr_tree/update/choose_child.h"

#include <array>

namespace foresee {
namespace {

double median_of(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Half the mean width of some of the children, and, if any ends, half their spread in time.
template <int D>
TypicalQuery typical_query(const Node& inner, const VisitCost<D>& cost, bool any_ends) {
  constexpr std::size_t limit = 8;
  const std::size_t step = (inner.size() + limit - 1) / limit;
  std::array<double, limit> sides, durations;
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < inner.size(); slot += step, ++count) {
    const Times times = times_at<D>(inner, slot);
    sides[count] = cost.mean_width(bounds_at<D>(inner, slot), times);
    durations[count] = ends(times) ? cost.spread(times) : 0;
  }
  return {0.5 * median_of({sides.data(), count}), any_ends ? 0.5 * median_of({durations.data(), count}) : 0};
}

template <int D>
bool any_child_ends(const Node& inner) {
  bool any = false;
  for (std::size_t slot = 0; slot < inner.size() && !any; ++slot) any = ends(times_at<D>(inner, slot));
  return any;
}

}  // namespace

template <int D>
ChildChoice<D>::ChildChoice(const Node& inner, const VisitCost<D>& cost)
    : children_(inner.size()),
      cost_(cost),
      any_ends_(any_child_ends<D>(inner)),
      query_(typical_query(inner, cost, any_ends_)),
      faces_(children_ * faces * D),
      widths_(children_ * faces / 2 * D),
      product_(children_),
      before_(children_),
      after_(children_) {
  for (std::size_t slot = 0; slot < children_; ++slot) {
    const double* from = inner.values.data() + slot * entry_size(D) + times_size;
    for (std::size_t part = 0; part < faces * D; ++part) faces_[part * children_ + slot] = from[part];
  }
  if (any_ends_) {
    times_.resize(times_size * children_);
    elapsed_.resize(3 * children_);
    weights_.resize(children_);
    for (std::size_t slot = 0; slot < children_; ++slot)
      for (std::size_t part = 0; part < times_size; ++part)
        times_[part * children_ + slot] = inner.values[slot * entry_size(D) + part];
  }
  costs_with({}, before_);
}

/// The width of each child with `added` in it.
template <int D>
void ChildChoice<D>::set_widths(const Bounds<D>& added) {
  const Vec<D>* ends[] = {&added.x_lower, &added.x_upper, &added.v_lower,
                          &added.v_upper, &added.a_lower, &added.a_upper};
  for (int part = 0; part < faces; part += 2) {
    const double more = part == x_lower ? query_.side : 0, share = part == a_lower ? 0.5 : 1;
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
}

/// The window of each child with `added` in it.
template <int D>
void ChildChoice<D>::set_windows(const Times& added) {
  const double *t_min = times_.data(), *t_max = t_min + children_, *until_max = t_max + children_;
  double *start = elapsed_.data(), *middle = start + children_, *end = middle + children_;
  for (std::size_t slot = 0; slot < children_; ++slot) {
    Times times{t_min[slot], t_max[slot], until_max[slot]};
    times.include(added);
    const auto window = cost_.window_of(times, query_.duration);
    start[slot] = window.elapsed[0];
    middle[slot] = window.elapsed[1];
    end[slot] = window.elapsed[2];
    weights_[slot] = window.weight;
  }
}

/// The cost of each child with `added` in it, as in VisitCost, for all children in columns.
template <int D>
void ChildChoice<D>::costs_with(const Entry<D>& added, std::vector<double>& costs) {
  set_widths(added.bounds);
  if (any_ends_) set_windows(added.times);
  std::fill(costs.begin(), costs.end(), 0.0);
  const auto integrate = [&](double weight, auto elapsed) {
    std::fill(product_.begin(), product_.end(), weight);
    for (int axis = 0; axis < D; ++axis) {
      const double* x = widths_.data() + static_cast<std::size_t>(axis) * children_;
      const double *v = x + D * children_, *a = v + D * children_;
      for (std::size_t slot = 0; slot < children_; ++slot) {
        const double s = elapsed(slot);
        product_[slot] *= VisitCost<D>::within_reason(x[slot] + s * (v[slot] + s * a[slot]));
      }
    }
    for (std::size_t slot = 0; slot < children_; ++slot) costs[slot] += product_[slot];
  };
  for (std::size_t time = 0; time < 3; ++time) {
    const double weight = time == 1 ? 4.0 : 1.0, shared = cost_.endless()[time];
    if (!any_ends_)
      integrate(weight, [shared](std::size_t) { return shared; });
    else
      integrate(weight, [each = elapsed_.data() + time * children_](std::size_t slot) { return each[slot]; });
  }
  if (any_ends_)
    for (std::size_t slot = 0; slot < children_; ++slot) costs[slot] *= weights_[slot];
}

template <int D>
std::size_t ChildChoice<D>::choose(const Entry<D>& added) {
  costs_with(added, after_);
  std::size_t best = 0;
  double min_growth = std::numeric_limits<double>::infinity(), min_cost = min_growth;
  for (std::size_t slot = 0; slot < children_; ++slot) {
    const double growth = after_[slot] - before_[slot];
    if (growth < min_growth || (growth == min_growth && before_[slot] < min_cost)) {
      best = slot;
      min_growth = growth;
      min_cost = before_[slot];
    }
  }
  return best;
}

template <int D>
std::vector<Growth> growths(const Node& inner, const Entry<D>& added, const VisitCost<D>& cost,
                            const TypicalQuery& query) {
  std::vector<Growth> all;
  all.reserve(inner.size());
  for (std::size_t slot = 0; slot < inner.size(); ++slot) {
    Entry<D> both = entry_at<D>(inner, slot);
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
  const Entry<D> entry = entry_at<D>(above, own);
  std::vector<Growth> all = growths(above, entry, cost, cost.query_like(0.1, entry));
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

#define FORESEE_OF_AXES(D)                                                                         \
  template class ChildChoice<D>;                                                                   \
  template std::vector<Growth> growths(const Node&, const Entry<D>&, const VisitCost<D>&,          \
                                       const TypicalQuery&);                                       \
  template std::vector<std::size_t> closest_children(const TreeState<D>&, const Node&, NodeNumber, \
                                                     std::size_t);                                 \
  template std::size_t closest_sibling(const TreeState<D>&, const Node&, NodeNumber)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
