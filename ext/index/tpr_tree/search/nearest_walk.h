// Nearest-neighbour search around a moving point in a TPR-tree: leaves in order of their min possible
// distance (best first, Hjaltason and Samet 1999, with time-parameterized bounds).
//
//   NearestWalk<2> walk(source, point, velocity, horizon, interrupt);
//   double reach = infinity;                               // distance of the k-th best so far
//   for (LeafHits hits; walk.next(reach, hits);)
//     for (std::size_t i = 0; i < hits.slots.size() && hits.distances[i] <= reach; ++i)
//       …                                                // measure exactly, shrink reach
//
// Guarantee: once next() returns false, every object that was not returned has its centre farther than `reach` from
// the point. That holds at every time of the horizon at which the object exists. Left out are objects that `test` does
// not accept, and those with a plan. The objects of one leaf are sorted by a lower bound of their distance. A chunk of
// a plan is an item whose box contains the centre of its object: DistanceTo::boxes bounds by the boxes.
#pragma once

#include "base/error.h"
#include "index/tpr_tree/leaf_hits.h"

namespace foresee {

/// A lower bound of the distance between two boxes during `span`. Requires: the span is not empty.
template <int D>
double min_distance(const MovingBox<D>& a, const MovingBox<D>& b, const SharedInterval& span);

/// min_distance() of the centre of an object without extents and a moving point, during the object's span.
template <int D>
double min_point_distance(const MovingBox<D>& point, const MovingBox<D>& query);

enum class DistanceTo : std::uint8_t { centres, boxes };

template <int D>
class NearestWalk {
 public:
  /// The point is at `point` at `now` and then moves with `velocity`.
  NearestWalk(NodeSource& source, const Vec<D>& point, const Vec<D>& velocity, const Horizon& horizon,
              Interrupt& interrupt, const std::optional<KindTest>& test = {},
              DistanceTo to = DistanceTo::centres);

  /// Returns the next leaf with at least one object that may come within `reach`; false once no such leaf is
  /// left. Requires: `reach` does not increase from call to call.
  bool next(double reach, LeafHits& hits);

  /// A lower bound of the distance of all that has not been returned; infinite if nothing is left.
  double next_distance() const {
    return open_.empty() ? std::numeric_limits<double>::infinity() : open_.front().distance;
  }

 private:
  struct Open {
    double distance;
    Unread node;

    friend bool operator<(const Open& a, const Open& b) { return a.distance > b.distance; }  // the min on top
  };

  void open_children(NodeNumber number, const Node& inner, double reach);
  void find_in_leaf(const Node& leaf, double reach, LeafHits& hits);
  /// Adds what is within reach to near_. Plain: all pass the test, and none has a plan.
  template <bool plain, bool to_centre>
  void find_near(const Node& leaf, double reach);

  NodeSource& source_;
  Interrupt& interrupt_;
  LeafReader<D> reader_;
  Horizon horizon_;
  MovingBox<D> query_;
  std::optional<KindTest> test_;  ///< of the objects that are returned
  DistanceTo to_;
  std::vector<Open> open_;  ///< a heap
  std::vector<std::pair<double, std::uint32_t>> near_;
};

}  // namespace foresee
