#include "query/nearest/nearest.h"

#include <algorithm>
#include <string>

#include "base/axes.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "contact/contact.h"
#include "contact/window_contact.h"
#include "index/tpr_tree/search/nearest_walk.h"
#include "query/input_checks.h"
#include "query/legs/leg_scene.h"
#include "query/nearest/nearest_rows.h"
#include "shape/kinds.h"

namespace foresee {
namespace {

template <int D>
class Search {
 public:
  Search(const NearestQuestion& question, Interrupt& interrupt)
      : interrupt_(interrupt),
        horizon_{question.now, question.h},
        best_(question.k),
        movers_(question.k),
        point_(faces_of(question), {.axes = D}, question.now),
        box_(moving_window<D>(place(), place(), velocity(), horizon_)) {
    if (question.mask) test_ = KindTest::of_categories(*question.mask);
    setup_.a = point_.bodies();
    setup_.horizon = horizon_;
  }

  std::vector<NearestRow> in_scene(const Scene& scene) && {
    if (scene.layout.has_plan) return std::move(*this).in_plans(scene);
    const Bodies bodies = scene.bodies();
    setup_.b = bodies;
    for (std::size_t i = 0; i < bodies.count; ++i) {
      if (i % 256 == 0) interrupt_.check();
      if (test_ && !test_->accepts(kinds_of(bodies.row(i), bodies.at))) continue;
      if (!may_come_within(best_.reach(), motion_of<D>(bodies, i))) continue;
      if (const auto near = approach_of(scene.ids[i], bodies.row(i))) best_.offer(*near);
    }
    return std::move(best_).ranked();
  }

  std::vector<NearestRow> in_tree(NodeSource& tree) && {
    setup_.b = Bodies(tree.layout(), nullptr, 0);
    row_.resize(static_cast<std::size_t>(setup_.b.at.size));
    NearestWalk<D> walk(tree, place(), velocity(), horizon_, interrupt_, test_);
    while (offer_leaf(tree.layout(), walk)) {
    }
    return std::move(best_).ranked();
  }

  /// Both trees, whichever may have the nearer object next.
  std::vector<NearestRow> in_trees(NodeSource& tree, ChunkSource& chunks) && {
    setup_.b = Bodies(tree.layout(), nullptr, 0);
    row_.resize(static_cast<std::size_t>(setup_.b.at.size));
    legs_.layout = tree.layout(), legs_.legs_during = leg_times_of(horizon_);
    NearestWalk<D> walk(tree, place(), velocity(), horizon_, interrupt_, test_);
    NearestWalk<D> chunk_walk(chunks.tree(), place(), velocity(), horizon_, interrupt_, test_,
                              DistanceTo::boxes);
    // The nearer one first; next_distance() is a bound, so after a walk that has nothing the other one goes on.
    const auto offer_object = [&] { return offer_leaf(tree.layout(), walk); };
    const auto offer_chunk = [&] { return offer_chunks(chunks, chunk_walk); };
    for (bool more = true; more;)
      more = chunk_walk.next_distance() < walk.next_distance() ? offer_chunk() || offer_object()
                                                               : offer_object() || offer_chunk();
    return std::move(movers_).ranked();
  }

 private:
  /// Offers the objects of the next leaf; false if no other can be a row.
  bool offer_leaf(const Layout& layout, NearestWalk<D>& walk) {
    const auto record_size = static_cast<std::size_t>(record_offsets(layout).size);
    if (!walk.next(reach(layout), hits_)) return false;
    for (std::size_t i = 0; i < hits_.slots.size() && hits_.distances[i] <= reach(layout); ++i) {
      const std::uint32_t slot = hits_.slots[i];
      row_from_record(layout, hits_.leaf->values.data() + slot * record_size, row_.data());
      const auto near = approach_of(hits_.leaf->keys[slot], row_.data());
      if (near && layout.has_plan)
        movers_.offer(*near);
      else if (near)
        best_.offer(*near);
    }
    return true;
  }
  double reach(const Layout& layout) const { return layout.has_plan ? movers_.reach() : best_.reach(); }

  bool offer_chunks(ChunkSource& chunks, NearestWalk<D>& walk) {
    if (!walk.next(movers_.reach(), hits_)) return false;
    const auto is_near = [&](std::size_t i) {
      return i < hits_.slots.size() && hits_.distances[i] <= movers_.reach();
    };
    const auto number = [&](std::size_t i) { return hits_.leaf->keys[hits_.slots[i]]; };
    for (std::size_t i = 0; i < chunks_ahead && is_near(i); ++i) chunks.prefetch_chunk(number(i));
    for (std::size_t i = 0; is_near(i); ++i) {
      if (is_near(i + chunks_ahead)) chunks.prefetch_chunk(number(i + chunks_ahead));
      chunks.read_chunk(number(i), legs_.legs_during, chunk_);
      // A leg as long as its plan says: the object may end earlier.
      std::erase_if(chunk_.legs,
                    [&](const Leg& leg) { return !may_come_within(movers_.reach(), motion_of<D>(leg)); });
      if (chunk_.legs.empty()) continue;
      legs_.ids.clear();
      legs_.rows.clear();
      legs_.first_rows.clear();
      legs_.add(chunk_.object, chunk_.record.data(), chunk_.legs);
      const Bodies bodies = legs_.bodies();
      for (std::size_t row = 0; row < legs_.size(); ++row) offer_leg(chunk_.object, bodies, row);
    }
    return true;
  }

  std::vector<NearestRow> in_plans(const Scene& scene) && {
    const Bodies bodies = scene.bodies();
    setup_.b = bodies;
    Steps steps(interrupt_);
    for (std::size_t i = 0; i < scene.object_count(); ++i) {
      steps.costly(64);
      const RowRange rows = rows_during(bodies, scene.rows_of(i), horizon_);
      if (rows.size() == 0) continue;
      if (test_ && !test_->accepts(kinds_of(bodies.row(rows.first), bodies.at))) continue;
      for (std::size_t row = rows.first; row < rows.last; ++row) {
        steps.costly(64);
        if (may_come_within(movers_.reach(), motion_of<D>(bodies, row)))
          offer_leg(scene.ids[row], bodies, row);
      }
    }
    return std::move(movers_).ranked();
  }

  void offer_leg(std::int64_t id, const Bodies& bodies, std::size_t row) {
    if (const auto near = approach_of(id, bodies.row(row))) movers_.offer(*near);
  }

  /// False only for what is farther than `reach` during the whole horizon.
  bool may_come_within(double reach, const Motion<D>& motion) const {
    const MovingBox<D> box = moving_box<D>(motion, Extents<D>::none(), horizon_, Vec<D>::zero());
    return !box.span.is_empty() && min_point_distance(box, box_) <= reach;
  }

  static WindowFaces faces_of(const NearestQuestion& question) {
    WindowFaces faces{.velocity = question.velocity};
    for (std::size_t axis = 0; axis < D; ++axis)
      faces.lower[axis] = faces.upper[axis] = *question.point[axis];
    return faces;
  }
  Vec<D> place() const { return vector_of<D>(point_.faces().lower); }
  Vec<D> velocity() const { return vector_of<D>(point_.faces().velocity); }

  /// Nothing if the object does not exist during the horizon.
  std::optional<NearestRow> approach_of(std::int64_t id, const double* row) const {
    const double* from = point_.bodies().row(0);
    if (pair_lifetime_of(setup_, from, row).none) return std::nullopt;
    const ClosestApproach near = closest_approach_of<D>(setup_, from, row);
    return NearestRow{id, near.d, near.t, near.dt};
  }

  Interrupt& interrupt_;
  Horizon horizon_;
  NearestObjects best_;
  NearestMovers movers_;  ///< of a layout with plans, in place of best_
  MovingWindow point_;
  MovingBox<D> box_;  ///< of the point
  std::optional<KindTest> test_;
  Setup setup_;
  LeafHits hits_;
  std::vector<double> row_;
  Chunk chunk_;
  Scene legs_;  ///< of one chunk
};

template <int D>
std::vector<NearestRow> search(const NearestQuestion& question, Interrupt& interrupt) {
  Search<D> search(question, interrupt);
  const SearchTarget& objects = question.objects;
  if (objects.scene) return std::move(search).in_scene(*objects.scene);
  if (objects.chunks) return std::move(search).in_trees(*objects.tree, *objects.chunks);
  return std::move(search).in_tree(*objects.tree);
}

void require_valid(const NearestQuestion& question) {
  require_target(question.objects, "a nearest query has no objects", "NearestQuestion::objects");
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
