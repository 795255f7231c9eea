#include "index/tpr_tree/choose.h"

#include <array>

namespace foresee::index {
namespace {

/// The side of a typical question: half the mean width of some of the children.
template <int D>
double typical_query(const Node& inner, const VisitCost<D>& cost) {
  constexpr std::size_t most = 8;
  const std::size_t step = (inner.size() + most - 1) / most;
  std::array<double, most> widths;
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < inner.size(); slot += step)
    widths[count++] = cost.mean_width(bounds_at<D>(inner, slot));
  std::nth_element(widths.begin(), widths.begin() + count / 2, widths.begin() + count);
  return 0.5 * widths[count / 2];
}

}  // namespace

template <int D>
std::size_t choose_child(const Node& inner, const Bounds<D>& added, const VisitCost<D>& cost) {
  const double query = typical_query(inner, cost);
  std::size_t best = 0;
  double least_growth = std::numeric_limits<double>::infinity(), least_cost = least_growth;
  for (std::size_t slot = 0; slot < inner.size(); ++slot) {
    const Bounds<D> before = bounds_at<D>(inner, slot);
    Bounds<D> after = before;
    after.include(added);
    const double cost_before = cost(before, query), growth = cost(after, query) - cost_before;
    if (growth < least_growth || (growth == least_growth && cost_before < least_cost))
      best = slot, least_growth = growth, least_cost = cost_before;
  }
  return best;
}

template std::size_t choose_child<1>(const Node&, const Bounds<1>&, const VisitCost<1>&);
template std::size_t choose_child<2>(const Node&, const Bounds<2>&, const VisitCost<2>&);
template std::size_t choose_child<3>(const Node&, const Bounds<3>&, const VisitCost<3>&);

}  // namespace foresee::index
