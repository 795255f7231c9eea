#include "query/sweep/sweep.h"

#include <algorithm>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/search/sweep_walk.h"
#include "query/input_checks.h"
#include "query/legs/leg_scene.h"

namespace foresee {
namespace {

/// A box that intersects every box with queried corners.
template <int D>
Box<D> met_by_all(const std::vector<QueriedCorners>& queried) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box<D> box{Vec<D>::constant(-inf), Vec<D>::constant(inf)};
  for (int axis = 0; axis < std::min(D, static_cast<int>(queried.size())); ++axis) {
    const QueriedCorners& corners = queried[static_cast<std::size_t>(axis)];
    const double one = std::max(corners.lower_min, corners.upper_min),
                 other = std::min(corners.lower_max, corners.upper_max);
    box.lower[axis] = std::min(one, other), box.upper[axis] = std::max(one, other);
  }
  return box;
}

template <int D>
SweepRow sweep_row(std::int64_t id, const Box<D>& box) {
  SweepRow row;
  row.id = id;
  std::copy_n(box.lower.data(), D, row.lower.data());
  std::copy_n(box.upper.data(), D, row.upper.data());
  return row;
}

/// The rows of all objects with plans.
template <int D>
std::vector<SweepRow> sweep_plans(const SweepQuestion& question, Interrupt& interrupt) {
  const Horizon horizon{question.now, question.h};
  const Vec<D> margin = sweep_margin<D>(question.within, question.within_z);
  const Box<D> queried = met_by_all<D>(question.queried);
  std::vector<SweepRow> rows;
  for_each_plan(*question.chunks, question.tree->layout(), horizon, interrupt, [&](const Scene& legs) {
    const Box<D> box = swept_box_of<D>(legs.bodies(), {0, legs.size()}, horizon, margin);
    if (!box.is_empty() && box.meets(queried)) rows.push_back(sweep_row<D>(legs.ids[0], box));
  });
  return rows;
}

void require_valid_sweep(const SweepQuestion& question) {
  require_set(question.tree != nullptr, "a sweep has no tree", "SweepQuestion::tree");
  require_layout("sweep", question.tree->layout());
  require_not_negative("h", question.h);
  require_not_negative("within", question.within);
  if (question.within_z) require_not_negative("within_z", *question.within_z);
  require_finite("now", question.now);
  if (question.within_z && question.tree->layout().axes != 3)
    throw Error("within_z is for tables with x, y and z; leave it out here (within covers every axis)");
}

}  // namespace

class Sweep::Leaves {
 public:
  virtual ~Leaves() = default;
  /// Appends the rows of one leaf; false at the end.
  virtual bool next(std::vector<SweepRow>& rows) = 0;
};

template <int D>
class Sweep::LeavesOfAxes final : public Sweep::Leaves {
 public:
  LeavesOfAxes(SweepQuestion question, Interrupt& interrupt)
      : tree_(std::move(question.tree)),
        horizon_{question.now, question.h},
        margin_(sweep_margin<D>(question.within, question.within_z)),
        queried_(met_by_all<D>(question.queried)),
        walk_(*tree_, queried_, horizon_, margin_, interrupt),
        leaf_bodies_(tree_->layout()) {}

  bool next(std::vector<SweepRow>& rows) override {
    const auto leaf = walk_.next();
    if (!leaf) return false;
    const Bodies bodies = leaf_bodies_.of(*leaf);
    for (std::size_t i = 0; i < bodies.count; ++i) {
      const Box<D> box = swept_box<D>(bodies, i, horizon_, margin_);
      if (box.is_empty() || !box.meets(queried_)) continue;
      rows.push_back(sweep_row<D>(leaf->keys[i], box));
    }
    return true;
  }

 private:
  std::shared_ptr<NodeSource> tree_;
  Horizon horizon_;
  Vec<D> margin_;
  Box<D> queried_;
  SweepWalk<D> walk_;
  LeafBodies leaf_bodies_;
};

Sweep::Sweep(SweepQuestion question, Interrupt& interrupt) {
  const FloatEnvironment environment;
  require_valid_sweep(question);
  if (question.chunks)
    plans_ = with_axes(question.tree->layout().axes,
                       [&]<int D>(Axes<D>) { return sweep_plans<D>(question, interrupt); });
  leaves_ = with_axes(question.tree->layout().axes, [&]<int D>(Axes<D>) -> std::unique_ptr<Leaves> {
    return std::make_unique<LeavesOfAxes<D>>(std::move(question), interrupt);
  });
}

Sweep::~Sweep() = default;

std::span<const SweepRow> Sweep::next() {
  const FloatEnvironment environment;
  return unbroken_.run("the sweep", [this]() -> std::span<const SweepRow> {
    rows_.clear();
    while (rows_.empty() && leaves_->next(rows_)) {
    }
    if (rows_.empty()) rows_.swap(plans_);
    return rows_;
  });
}

}  // namespace foresee
