#include "spatialindex_tree.h"

#include "base/error.h"

namespace foresee::bench {
namespace {

namespace rival = SpatialIndex;

constexpr double unbounded = 1e6;  // the end of a stored motion

struct Counter final : rival::IVisitor {
  void visitNode(const rival::INode&) override {}
  void visitData(const rival::IData&) override { ++found; }
  void visitData(std::vector<const rival::IData*>&) override {}
  std::size_t found = 0;
};

}  // namespace

SpatialindexTree::SpatialindexTree(const Workload& w, double horizon)
    : workload_(w), memory_(rival::StorageManager::createNewMemoryStorageManager()) {
  if (w.layout.axes != 2 || w.layout.law != Law::uniform)
    throw Error("'" + w.name + "': libspatialindex's TPR-tree is used for two axes and uniform motion");
  rival::id_type index;
  tree_.reset(
      rival::TPRTree::createNewTPRTree(*memory_, 0.7, 32, 50, 2, rival::TPRTree::TPRV_RSTAR, horizon, index));
}

rival::MovingRegion SpatialindexTree::region(std::uint32_t row, double end) const {
  const Bodies bodies = workload_.bodies();
  const double* const numbers = bodies.row(row);
  const double *const x = numbers + bodies.at.x, *const v = numbers + bodies.at.v;
  const bool box = workload_.layout.shape == Shape::box;
  const double reach[] = {numbers[box ? bodies.at.half : bodies.at.r],
                          numbers[box ? bodies.at.half + 1 : bodies.at.r]};
  const double low[] = {x[0] - reach[0], x[1] - reach[1]}, high[] = {x[0] + reach[0], x[1] + reach[1]};
  return rival::MovingRegion(low, high, v, v, 0, end, 2);
}

void SpatialindexTree::insert_all() {
  for (std::uint32_t row = 0; row < workload_.count; ++row)
    tree_->insertData(0, nullptr, region(row, unbounded), row);
}

std::size_t SpatialindexTree::count(double x, double y, double reach) {
  const double low[] = {x - reach, y - reach}, high[] = {x + reach, y + reach}, still[] = {0, 0};
  Counter counter;
  tree_->intersectsWithQuery(rival::MovingRegion(low, high, still, still, 0, workload_.h, 2), counter);
  return counter.found;
}

}  // namespace foresee::bench
