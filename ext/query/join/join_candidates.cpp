#include "query/join/join_candidates.h"

#include <algorithm>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/all_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/paper_grid/paper_candidates.h"
#include "index/tpr_tree/search/tree_join.h"
#include "query/join/movers/leg_tree.h"
#include "query/join/pair_kinds.h"
#include "query/legs/leg_candidates.h"
#include "query/tile/tile.h"

namespace foresee {
namespace {

/// For a query of one id: that row with all rows of the other side; an unknown id has no pairs.
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

bool some_may_not_meet(const JoinQuestion& question) {
  return question.kinds && !question.kinds->all_meet();
}

/// Those of the rows of a side, for the indexes that test them; null if all pairs may meet.
const Kinds* kinds_of_a(const JoinQuestion& question) {
  return some_may_not_meet(question) ? question.kinds->a->of.data() : nullptr;
}
const Kinds* kinds_of_b(const JoinQuestion& question) {
  return some_may_not_meet(question) ? question.kinds->b->of.data() : nullptr;
}

bool tests_kinds(const JoinQuestion& question, JoinMethod method) {
  const bool one = question.only_a || question.only_b;
  return !one && (method == JoinMethod::grid || method == JoinMethod::tree);
}

std::unique_ptr<Candidates> scan(const Scene& a, const Scene* b, Interrupt& interrupt) {
  return b ? make_all_pairs(a.size(), b->size(), interrupt) : make_all_pairs(a.size(), interrupt);
}

std::unique_ptr<Candidates> leg_candidates(const JoinQuestion& question, const Horizon& horizon,
                                           Interrupt& interrupt) {
  return make_leg_candidates({.a = Movers(question.a),
                              .b = Movers(question.b ? question.b : question.a),
                              .each_once = !question.b,
                              .are_one = question.b == question.a,
                              .only_a = question.only_a,
                              .only_b = question.only_b},
                             horizon, interrupt);
}

template <int D>
std::unique_ptr<Candidates> tree(const JoinQuestion& question, const Horizon& horizon, const Vec<D>& margin,
                                 Interrupt& interrupt) {
  const Scene& a = *question.a;
  const Kinds* const kinds = kinds_of_a(question);
  if (!question.b) return make_tree_join<D>(a.bodies(), a.levels.value(), horizon, margin, interrupt, kinds);
  const Scene& b = *question.b;
  return make_tree_join<D>(a.bodies(), a.levels.value(), b.bodies(), b.levels.value(), horizon, margin,
                           interrupt, kinds, kinds_of_b(question));
}

std::unique_ptr<Candidates> all_candidates(const JoinQuestion& question, JoinMethod method,
                                           const Horizon& horizon, Interrupt& interrupt) {
  const Scene& a = *question.a;
  const Scene& b = question.side_b();
  if (has_plans(question) && (question.only_a || question.only_b || method == JoinMethod::scan))
    return leg_candidates(question, horizon, interrupt);
  if (question.only_a) return one_row(a, *question.only_a, Side::a, b.size(), interrupt);
  if (question.only_b) return one_row(b, *question.only_b, Side::b, a.size(), interrupt);
  if (method == JoinMethod::scan) return scan(a, question.b.get(), interrupt);
  return with_axes(a.layout.axes, [&]<int D>(Axes<D>) -> std::unique_ptr<Candidates> {
    const Vec<D> margin = margin_of<D>(question);
    if (method == JoinMethod::tree && has_plans(question))
      return make_leg_tree<D>(question, horizon, margin, interrupt);
    if (method == JoinMethod::tree) return tree<D>(question, horizon, margin, interrupt);
    const Bodies bodies_a = a.bodies(), bodies_b = b.bodies();
    if (method == JoinMethod::gpcd)
      return make_paper_candidates<D>(bodies_a, bodies_b, question.b != nullptr, horizon, margin, interrupt);
    const MovingBoxes<D> boxes_a{bodies_a, horizon, margin, kinds_of_a(question)};
    const MovingBoxes<D> boxes_b{bodies_b, horizon, margin, kinds_of_b(question)};
    return make_gpcd_grid<D>(boxes_a, question.b ? &boxes_b : nullptr, interrupt, question.space);
  });
}

}  // namespace

std::unique_ptr<DividedCandidates> divided_candidates(const JoinQuestion& question, const Horizon& horizon,
                                                      Interrupt& interrupt) {
  const FloatEnvironment environment;
  auto all = with_axes(question.a->layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> margin = margin_of<D>(question);
    const MovingBoxes<D> a{question.a->bodies(), horizon, margin, kinds_of_a(question)};
    const MovingBoxes<D> b{question.side_b().bodies(), horizon, margin, kinds_of_b(question)};
    return make_divided_grid<D>(a, question.b ? &b : nullptr, question.helpers, interrupt, question.space);
  });
  return question.own ? owned_candidates(std::move(all), question.own) : std::move(all);
}

std::unique_ptr<Candidates> join_candidates(const JoinQuestion& question, JoinMethod method,
                                            const Horizon& horizon, Interrupt& interrupt) {
  const FloatEnvironment environment;
  auto all = all_candidates(question, method, horizon, interrupt);
  if (some_may_not_meet(question) && !tests_kinds(question, method))
    all = meeting_candidates(std::move(all), question.kinds);
  return question.own ? owned_candidates(std::move(all), question.own) : std::move(all);
}

}  // namespace foresee
