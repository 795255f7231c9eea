#include "query/join/movers/leg_tree.h"

#include <numeric>

#include "index/memory_pages.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/join/pair_kinds.h"

namespace foresee {
namespace {

/// The rows of a scene in leaf order.
struct LegTree {
  TreeScene rows;  ///< ids are row numbers of the scene
  std::vector<Kinds> kinds;

  const Kinds* kinds_if_any() const { return kinds.empty() ? nullptr : kinds.data(); }
};

LegTree tree_of(const Scene& scene, const SceneKinds* kinds, const Horizon& horizon, Interrupt& interrupt) {
  Layout layout = scene.layout;  // records like rows
  layout.has_plan = false;
  if (layout.law == Law::forced) layout.law = Law::accelerated;
  MemoryPages pages(layout);
  std::vector<std::int64_t> numbers(scene.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  make_tpr_tree(pages, horizon.h)->bulk_load(numbers, scene.rows, interrupt);
  LegTree tree{read_tree(pages, interrupt), {}};
  if (!kinds) return tree;
  tree.kinds.reserve(scene.size());
  for (const std::int64_t row : tree.rows.ids) tree.kinds.push_back(kinds->of[static_cast<std::size_t>(row)]);
  return tree;
}

/// The pairs of joined trees, as row numbers of the scenes.
class LegTreePairs final : public Candidates {
 public:
  LegTreePairs(std::unique_ptr<Candidates> pairs, std::vector<std::int64_t> rows_a,
               std::vector<std::int64_t> rows_b)
      : pairs_(std::move(pairs)), rows_a_(std::move(rows_a)), rows_b_(std::move(rows_b)) {}

  bool next(std::vector<Pair>& out) override {
    const std::size_t before = out.size();
    if (!pairs_->next(out)) return false;
    const std::vector<std::int64_t>& rows_b = rows_b_.empty() ? rows_a_ : rows_b_;
    for (std::size_t i = before; i < out.size(); ++i)
      out[i] = {static_cast<std::uint32_t>(rows_a_[out[i].a]), static_cast<std::uint32_t>(rows_b[out[i].b])};
    return true;
  }

 private:
  std::unique_ptr<Candidates> pairs_;
  std::vector<std::int64_t> rows_a_, rows_b_;
};

}  // namespace

template <int D>
std::unique_ptr<Candidates> make_leg_tree(const JoinQuestion& question, const Horizon& horizon,
                                          const Vec<D>& margin, Interrupt& interrupt) {
  const PairKinds* const kinds = question.kinds.get();
  LegTree a = tree_of(*question.a, kinds ? kinds->a.get() : nullptr, horizon, interrupt);
  if (!question.b) {
    auto pairs =
        make_tree_join<D>(a.rows.bodies(), a.rows.levels, horizon, margin, interrupt, a.kinds_if_any());
    return std::make_unique<LegTreePairs>(std::move(pairs), std::move(a.rows.ids),
                                          std::vector<std::int64_t>());
  }
  LegTree b = tree_of(*question.b, kinds ? kinds->b.get() : nullptr, horizon, interrupt);
  auto pairs = make_tree_join<D>(a.rows.bodies(), a.rows.levels, b.rows.bodies(), b.rows.levels, horizon,
                                 margin, interrupt, a.kinds_if_any(), b.kinds_if_any());
  return std::make_unique<LegTreePairs>(std::move(pairs), std::move(a.rows.ids), std::move(b.rows.ids));
}

#define FORESEE_OF_AXES(D)                                                                                  \
  template std::unique_ptr<Candidates> make_leg_tree<D>(const JoinQuestion&, const Horizon&, const Vec<D>&, \
                                                        Interrupt&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
