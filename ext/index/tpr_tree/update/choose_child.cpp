#include "index/tpr_tree/update/choose_child.h"

#include <algorithm>
#include <array>
#include <numeric>

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
      slots_(children_),
      faces_(children_ * faces * D),
      widths_(children_ * faces / 2 * D),
      product_(children_),
      outside_(children_),
      before_(children_),
      after_(children_) {
  if (any_ends_) {
    times_.resize(times_size * children_);
    elapsed_.resize(3 * children_);
    weights_.resize(children_);
  }
  std::iota(slots_.begin(), slots_.end(), std::size_t{0});
  read(inner);
  costs_with({}, before_);
  std::stable_sort(slots_.begin(), slots_.end(),
                   [&](std::size_t a, std::size_t b) { return before_[a] < before_[b]; });
  read(inner);
  costs_with({}, before_);
}

/// The entries of the children, in the order of slots_.
template <int D>
void ChildChoice<D>::read(const Node& inner) {
  for (std::size_t child = 0; child < children_; ++child) {
    const double* from = inner.values.data() + slots_[child] * entry_size(D);
    if (any_ends_)
      for (std::size_t part = 0; part < times_size; ++part) times_[part * children_ + child] = from[part];
    from += times_size;
    for (std::size_t part = 0; part < faces * D; ++part) faces_[part * children_ + child] = from[part];
  }
}

/// The first child whose entry does not grow, in the order of slots_. Few children have the right place, so only those
/// are compared in everything.
template <int D>
std::optional<std::size_t> ChildChoice<D>::cheapest_containing(const Entry<D>& added) {
  std::fill(outside_.begin(), outside_.end(), 0);
  for (int axis = 0; axis < D; ++axis) {
    const double *lowest = face(x_lower, axis), *highest = face(x_upper, axis);
    const double low = added.bounds.x_lower[axis], high = added.bounds.x_upper[axis];
    for (std::size_t child = 0; child < children_; ++child)
      outside_[child] |= (lowest[child] <= low ? 0 : 1) | (high <= highest[child] ? 0 : 1);
  }
  for (std::size_t child = 0; child < children_; ++child)
    if (outside_[child] == 0 && contains_otherwise(child, added)) return slots_[child];
  return std::nullopt;
}

/// Whether a child's entry contains `added`, apart from its position.
template <int D>
bool ChildChoice<D>::contains_otherwise(std::size_t child, const Entry<D>& added) const {
  const Bounds<D>& bounds = added.bounds;
  for (int axis = 0; axis < D; ++axis)
    if (!(face(v_lower, axis)[child] <= bounds.v_lower[axis] &&
          bounds.v_upper[axis] <= face(v_upper, axis)[child] &&
          face(a_lower, axis)[child] <= bounds.a_lower[axis] &&
          bounds.a_upper[axis] <= face(a_upper, axis)[child]))
      return false;
  if (!any_ends_) return true;
  const double* times = times_.data() + child;
  return Times{times[0], times[children_], times[2 * children_]}.contains(added.times);
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
  if (const auto slot = cheapest_containing(added)) return *slot;
  costs_with(added, after_);
  std::size_t best = 0;
  double min_growth = std::numeric_limits<double>::infinity();
  for (std::size_t child = 0; child < children_; ++child) {
    const double growth = after_[child] - before_[child];
    if (growth < min_growth) best = child, min_growth = growth;
  }
  return slots_[best];
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
