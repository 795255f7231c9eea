// Boost.Geometry's packed R-tree of swept boxes: built at once, kept up to date, and joined with itself.
//
//   BoostTree<2> tree(workload);
//   tree.join(emitter);                         // candidates: pairs whose swept boxes meet
#pragma once

#include <boost/geometry.hpp>
#include <utility>
#include <vector>

#include "core_emitter.h"

namespace foresee::bench {

template <int D>
class BoostTree {
  using Point = boost::geometry::model::point<double, D, boost::geometry::cs::cartesian>;

 public:
  using SweptBox = boost::geometry::model::box<Point>;
  using Value = std::pair<SweptBox, std::uint32_t>;  ///< with the number of its object

  explicit BoostTree(const Workload& w) : values_(values_of(w)), tree_(values_) {}

  /// Replaces the box of an object.
  void move(std::uint32_t row, const Box<D>& swept) {
    tree_.remove(values_[row]);
    values_[row].first = boost_box(swept);
    tree_.insert(values_[row]);
  }

  /// Calls take(object of the query, object of the tree) for all that `value` meets.
  template <class Take>
  void probe(const Value& value, Take&& take) const {
    namespace index = boost::geometry::index;
    for (auto hit = tree_.qbegin(index::intersects(value.first)); hit != tree_.qend(); ++hit)
      take(value.second, hit->second);
  }
  /// Every pair once.
  void join(PlainEmitter& emitter) const {
    for (const Value& value : values_)
      probe(value, [&](std::uint32_t a, std::uint32_t b) {
        if (a < b) emitter.take(a, b);
      });
  }

  static std::vector<Value> values_of(const Workload& w) {
    const std::vector<Box<D>> boxes = boxes_swept_by<D>(w);
    std::vector<Value> values;
    values.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) values.push_back({boost_box(boxes[i]), i});
    return values;
  }

 private:
  static Point point(const Vec<D>& x) {
    if constexpr (D == 2)
      return {x[0], x[1]};
    else
      return {x[0], x[1], x[2]};
  }
  static SweptBox boost_box(const Box<D>& box) { return {point(box.lower), point(box.upper)}; }

  std::vector<Value> values_;
  boost::geometry::index::rtree<Value, boost::geometry::index::rstar<16>> tree_;
};

}  // namespace foresee::bench
