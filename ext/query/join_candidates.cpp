#include "query/join_candidates.h"

#include <algorithm>

#include "index/all_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/one_with_all.h"
#include "index/paper_grid/paper_candidates.h"
#include "index/tpr_tree/tree_join.h"
#include "motion/float_environment.h"
#include "query/join_question.h"

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

template <int D>
std::unique_ptr<Candidates> tree(const JoinQuestion& question, const Vec<D>& margin, Interrupt& interrupt) {
  const Horizon horizon{question.now, question.h};
  const Scene& a = *question.a;
  if (!question.b) return make_tree_join<D>(a.bodies(), a.outline.value(), horizon, margin, interrupt);
  const Scene& b = *question.b;
  return make_tree_join<D>(a.bodies(), a.outline.value(), b.bodies(), b.outline.value(), horizon, margin,
                           interrupt);
}

template <int D>
std::unique_ptr<Candidates> by_index(const JoinQuestion& question, const Contact::Reach& reach,
                                     Interrupt& interrupt) {
  const Horizon horizon{question.now, question.h};
  const Vec<D> margin = margin_of<D>(reach);
  if (question.method == JoinMethod::tree) return tree<D>(question, margin, interrupt);
  if (question.method == JoinMethod::gpcd) {
    const Scene& b = question.b ? *question.b : *question.a;
    return make_paper_candidates<D>(question.a->bodies(), b.bodies(), question.b != nullptr, horizon, margin,
                                    interrupt);
  }
  const MovingBoxes<D> a{question.a->bodies(), horizon, margin};
  if (!question.b) return make_gpcd_grid<D>(a, nullptr, interrupt, question.space);
  const MovingBoxes<D> b{question.b->bodies(), horizon, margin};
  return make_gpcd_grid<D>(a, &b, interrupt, question.space);
}

std::unique_ptr<Candidates> by_index_of_axes(const JoinQuestion& question, const Contact::Reach& reach,
                                             Interrupt& interrupt) {
  switch (question.a->layout.axes) {
    case 1:
      return by_index<1>(question, reach, interrupt);
    case 2:
      return by_index<2>(question, reach, interrupt);
    default:
      return by_index<3>(question, reach, interrupt);
  }
}

}  // namespace

MethodChoice choose_method(const JoinQuestion& question) {
  if (question.method != JoinMethod::automatic) return {question.method, "as asked"};
  const double a = static_cast<double>(question.a->size());
  const double pairs = question.b ? a * static_cast<double>(question.b->size()) : a * (a - 1) / 2;
  if (pairs <= scan_pairs) return {JoinMethod::scan, "a look at each of so few pairs costs less than a grid"};
  return {JoinMethod::grid, "there are too many pairs to look at each"};
}

std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, const Contact::Reach& reach,
                                            Interrupt& interrupt) {
  const FloatEnvironment environment;
  const Scene& a = *question.a;
  const Scene& b = question.b ? *question.b : a;
  if (question.only_a) return one_row(a, *question.only_a, Side::a, b.size(), interrupt);
  if (question.only_b) return one_row(b, *question.only_b, Side::b, a.size(), interrupt);
  if (choose_method(question).method == JoinMethod::scan) return scan(a, question.b.get(), interrupt);
  return by_index_of_axes(question, reach, interrupt);
}

}  // namespace foresee
