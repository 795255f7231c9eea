// The interface of every index: candidate pairs, row numbers of objects that may touch during the horizon, in
// batches.
//
//   auto candidates = make_gpcd_grid<2>({ships, horizon, margin}, nullptr, interrupt);
//   std::vector<Pair> batch;
//   while (candidates->next(batch)) { …; batch.clear(); }
//
// Guarantee: every pair that touches is reported exactly once. Other pairs may be reported too, none twice.
// Their number depends on the index: it may compare swept boxes (space) or beams (space and time). In a
// self-join the two row numbers of a pair differ and have no order. Empty boxes meet nothing.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "shape/swept_boxes.h"

namespace foresee {

class Candidates {
 public:
  virtual ~Candidates() = default;

  /// Appends the next candidates to `out`. Returns false, and appends nothing, once no candidates are left.
  /// A batch has some hundred to a few thousand pairs, so memory stays small and the first rows come early;
  /// it may be empty.
  virtual bool next(std::vector<Pair>& out) = 0;

  /// True if all pairs of the last batch certainly touch at the start of the horizon: they need no exact
  /// test.
  virtual bool touching() const { return false; }

  /// Sizes and counts of the index, as text for people; "" if the index has none.
  virtual std::string describe() const { return {}; }
};

/// Candidates divided into partitions, for several threads.
class DividedCandidates {
 public:
  virtual ~DividedCandidates() = default;
  virtual std::size_t parts() const = 0;
  /// Called once per partition, by any thread; `interrupt` belongs to the thread that pulls the candidates.
  virtual std::unique_ptr<Candidates> part(std::size_t i, Interrupt& interrupt) = 0;
};

}  // namespace foresee
