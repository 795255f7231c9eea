#include "query/join_candidates.h"

#include <algorithm>
#include <cmath>

#include "index/all_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/one_with_all.h"
#include "motion/float_environment.h"

namespace foresee {
namespace {

/// Up to so many pairs, looking at all of them is faster than setting up a grid: on one to three axes the two
/// cross between 120 and 280 pairs, at 5 to 10 microseconds.
constexpr double scan_pairs = 200;

/// A question about one id: that row with all rows of the other side; an unknown id has no pairs.
std::unique_ptr<Candidates> one_row(const Scene& scene, std::int64_t id, Side side, std::size_t others,
                                    Interrupt& interrupt) {
  const auto found = std::find(scene.ids.begin(), scene.ids.end(), id);
  OneWithAll rows{.one = 0, .side = side, .count = 0};
  if (found != scene.ids.end()) {
    rows.one = static_cast<std::uint32_t>(found - scene.ids.begin());
    rows.count = static_cast<std::uint32_t>(others);
  }
  return make_one_with_all(rows, interrupt);
}

std::unique_ptr<Candidates> scan(const Scene& a, const Scene* b, Interrupt& interrupt) {
  return b ? make_all_pairs(a.size(), b->size(), interrupt) : make_all_pairs(a.size(), interrupt);
}

/// Each side's boxes grow by half the reach, rounded up: two grown boxes meet wherever the pair can touch.
template <int D>
Vec<D> margin_of(const Contact::Reach& reach) {
  auto half = [](double whole) {
    return whole > 0 ? std::nextafter(whole / 2, std::numeric_limits<double>::infinity()) : 0.0;
  };
  Vec<D> margin = Vec<D>::Constant(half(reach.within));
  if constexpr (D == 3) margin[2] = half(reach.within_z);
  return margin;
}

template <int D>
std::unique_ptr<Candidates> grid(const JoinQuestion& question, const Contact::Reach& reach,
                                 Interrupt& interrupt) {
  const Horizon horizon{question.now, question.h};
  const Vec<D> margin = margin_of<D>(reach);
  const std::vector<Box<D>> boxes_a = swept_boxes<D>(question.a->bodies(), horizon, margin, interrupt);
  if (!question.b) return make_gpcd_grid<D>(boxes_a, interrupt);
  const std::vector<Box<D>> boxes_b = swept_boxes<D>(question.b->bodies(), horizon, margin, interrupt);
  return make_gpcd_grid<D>(boxes_a, boxes_b, interrupt);
}

std::unique_ptr<Candidates> grid_of_axes(const JoinQuestion& question, const Contact::Reach& reach,
                                         Interrupt& interrupt) {
  switch (question.a->layout.axes) {
    case 1:
      return grid<1>(question, reach, interrupt);
    case 2:
      return grid<2>(question, reach, interrupt);
    default:
      return grid<3>(question, reach, interrupt);
  }
}

JoinMethod chosen_method(const JoinQuestion& question) {
  if (question.method != JoinMethod::automatic) return question.method;
  const double a = static_cast<double>(question.a->size());
  const double pairs = question.b ? a * static_cast<double>(question.b->size()) : a * (a - 1) / 2;
  return pairs <= scan_pairs ? JoinMethod::scan : JoinMethod::grid;
}

}  // namespace

std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, const Contact::Reach& reach,
                                            Interrupt& interrupt) {
  const FloatEnvironment environment;
  const Scene& a = *question.a;
  const Scene& b = question.b ? *question.b : a;
  if (question.only_a) return one_row(a, *question.only_a, Side::a, b.size(), interrupt);
  if (question.only_b) return one_row(b, *question.only_b, Side::b, a.size(), interrupt);
  if (chosen_method(question) == JoinMethod::scan) return scan(a, question.b.get(), interrupt);
  return grid_of_axes(question, reach, interrupt);
}

}  // namespace foresee
