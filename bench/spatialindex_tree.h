// libspatialindex's TPR-tree in memory: objects in uniform motion, inserted one by one (it has no bulk load).
//
//   SpatialindexTree tree(workload, horizon);
//   tree.insert_all();
//   tree.join(take);                            // take(a, b), a < b: pairs whose moving boxes meet
//
// A join is one query per object, since the library's selfJoinQuery is not implemented. Objects are not moved:
// version 1.9.3 demands a later time for each removal, which loosens its bounds. A report of U-1000 took 1.4 ms
// so, and the reports of U-10000 were not awaited. Only where it is installed (Debian: libspatialindex-dev).
// Throws Tools::Exception.
#pragma once

#include <spatialindex/SpatialIndex.h>

#include <cstdint>
#include <memory>

#include "workloads.h"

namespace foresee::bench {

/// Objects of two axes in uniform motion: boxes or discs. The workload must outlive the tree.
class SpatialindexTree {
 public:
  /// `horizon`: that for which the tree is tuned; longer than any query.
  SpatialindexTree(const Workload& w, double horizon);

  void insert_all();

  /// The number of objects that meet the square of half side `reach` around (x, y), which does not move,
  /// during [0, h].
  std::size_t count(double x, double y, double reach);

  template <class Take>
  void join(Take take) {
    for (std::uint32_t i = 0; i < workload_.count; ++i) {
      Visitor<Take> visitor(i, take);
      tree_->intersectsWithQuery(region(i, workload_.h), visitor);
    }
  }

 private:
  template <class Take>
  struct Visitor final : SpatialIndex::IVisitor {
    Visitor(std::uint32_t of_query, Take& take_pair) : row(of_query), take(take_pair) {}
    void visitNode(const SpatialIndex::INode&) override {}
    void visitData(const SpatialIndex::IData& data) override {
      if (data.getIdentifier() > row) take(row, static_cast<std::uint32_t>(data.getIdentifier()));
    }
    void visitData(std::vector<const SpatialIndex::IData*>&) override {}
    std::uint32_t row;
    Take& take;
  };

  /// The object's motion during [0, end].
  SpatialIndex::MovingRegion region(std::uint32_t row, double end) const;

  const Workload& workload_;
  std::unique_ptr<SpatialIndex::IStorageManager> memory_;
  std::unique_ptr<SpatialIndex::ISpatialIndex> tree_;
};

}  // namespace foresee::bench
