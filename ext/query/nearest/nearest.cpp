#include "query/nearest/nearest.h"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

#include "base/axes.h"
#include "base/float_environment.h"
#include "contact/closest_approach.h"
#include "contact/window_contact.h"
#include "index/tpr_tree/search/nearest_walk.h"
#include "query/input_checks.h"
#include "shape/kinds.h"

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The k nearest rows so far.
class Best {
 public:
  explicit Best(std::int64_t k) : k_(static_cast<std::uint64_t>(k)) {}

  void offer(const NearestRow& row) {
    if (rows_.size() == k_) {
      if (!before(row, rows_.front())) return;
      std::pop_heap(rows_.begin(), rows_.end(), before);
      rows_.pop_back();
    }
    rows_.push_back(row);
    std::push_heap(rows_.begin(), rows_.end(), before);
  }

  /// No object farther than this is a row. One double above the largest distance: an object whose distance
  /// rounds to that may still precede it by its id.
  double reach() const {
    return rows_.size() == k_ ? std::nextafter(rows_.front().distance, infinity) : infinity;
  }

  std::vector<NearestRow> ranked() && {
    std::sort_heap(rows_.begin(), rows_.end(), before);
    return std::move(rows_);
  }

 private:
  static bool before(const NearestRow& a, const NearestRow& b) {
    return std::tie(a.distance, a.id) < std::tie(b.distance, b.id);
  }

  std::uint64_t k_;
  std::vector<NearestRow> rows_;  ///< a heap with the last row on top
};

template <int D>
class Search {
 public:
  Search(const NearestQuestion& question, Interrupt& interrupt)
      : interrupt_(interrupt),
        horizon_{question.now, question.h},
        best_(question.k),
        point_(faces_of(question), {.axes = D}, question.now) {
    if (question.mask) test_ = KindTest::of_categories(*question.mask);
    setup_.a = point_.bodies();
    setup_.horizon = horizon_;
  }

  std::vector<NearestRow> in_scene(const Scene& scene) && {
    const Bodies bodies = scene.bodies();
    setup_.b = bodies;
    const MovingBox<D> question = moving_window<D>(place(), place(), velocity(), horizon_);
    for (std::size_t i = 0; i < bodies.count; ++i) {
      if (i % 256 == 0) interrupt_.check();
      if (test_ && !test_->accepts(kinds_of(bodies.row(i), bodies.at))) continue;
      const MovingBox<D> box =
          moving_box<D>(motion_of<D>(bodies, i), Extents<D>::none(), horizon_, Vec<D>::Zero());
      if (box.span.is_empty() || min_distance(box, question, box.span) > best_.reach()) continue;
      offer(scene.ids[i], bodies.row(i));
    }
    return std::move(best_).ranked();
  }

  std::vector<NearestRow> in_tree(NodeSource& tree) && {
    setup_.b = Bodies(tree.layout(), nullptr, 0);
    const auto record_size = static_cast<std::size_t>(record_offsets(tree.layout()).size);
    std::vector<double> row(static_cast<std::size_t>(setup_.b.at.size));
    NearestWalk<D> walk(tree, place(), velocity(), horizon_, interrupt_, test_);
    for (LeafHits hits; walk.next(best_.reach(), hits);)
      for (std::size_t i = 0; i < hits.slots.size() && hits.distances[i] <= best_.reach(); ++i) {
        const std::uint32_t slot = hits.slots[i];
        row_from_record(tree.layout(), hits.leaf->values.data() + slot * record_size, row.data());
        offer(hits.leaf->keys[slot], row.data());
      }
    return std::move(best_).ranked();
  }

 private:
  static WindowFaces faces_of(const NearestQuestion& question) {
    WindowFaces faces{.velocity = question.velocity};
    for (std::size_t axis = 0; axis < D; ++axis)
      faces.lower[axis] = faces.upper[axis] = *question.point[axis];
    return faces;
  }
  Vec<D> place() const { return Eigen::Map<const Vec<D>>(point_.faces().lower.data()); }
  Vec<D> velocity() const { return Eigen::Map<const Vec<D>>(point_.faces().velocity.data()); }

  void offer(std::int64_t id, const double* row) {
    const double* from = point_.bodies().row(0);
    if (pair_lifetime_of(setup_, from, row).none) return;
    const ClosestApproach near = closest_approach_of<D>(setup_, from, row);
    best_.offer({id, near.d, near.t, near.dt});
  }

  Interrupt& interrupt_;
  Horizon horizon_;
  Best best_;
  MovingWindow point_;
  std::optional<KindTest> test_;
  Setup setup_;
};

template <int D>
std::vector<NearestRow> search(const NearestQuestion& question, Interrupt& interrupt) {
  Search<D> search(question, interrupt);
  const SearchTarget& objects = question.objects;
  return objects.scene ? std::move(search).in_scene(*objects.scene)
                       : std::move(search).in_tree(*objects.tree);
}

void require_valid(const NearestQuestion& question) {
  require_not_negative("h", question.h);
  require_finite("now", question.now);
  if (question.k < 1) throw Error("k must be a whole number >= 1, not " + std::to_string(question.k));
  const int axes = question.objects.layout().axes;
  for (int axis = 0; axis < 3; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    const std::string letter(1, "xyz"[axis]);
    const auto& at = question.point[j];
    if (axis < axes) {
      if (!at) reject_missing(question.objects, letter);
      require_finite(letter.c_str(), *at);
      require_finite(("qv" + letter).c_str(), question.velocity[j]);
    } else {
      if (at) reject_axis(question.objects, letter);
      if (question.velocity[j] != 0) reject_axis(question.objects, "qv" + letter);
    }
  }
}

}  // namespace

std::vector<NearestRow> nearest(const NearestQuestion& question, Interrupt& interrupt) {
  const FloatEnvironment environment;
  require_valid(question);
  return with_axes(question.objects.layout().axes,
                   [&]<int D>(Axes<D>) { return search<D>(question, interrupt); });
}

}  // namespace foresee
