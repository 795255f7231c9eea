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
#include <utility>
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

/// The candidates that `keep(pair)` accepts, in their order.
template <class Keep>
class FilteredCandidates final : public Candidates {
 public:
  FilteredCandidates(std::unique_ptr<Candidates> all, Keep keep)
      : all_(std::move(all)), keep_(std::move(keep)) {}

  /// Without a branch on `keep`, which would be mispredicted.
  bool next(std::vector<Pair>& out) override {
    std::size_t kept = out.size();
    const std::size_t before = kept;
    if (!all_->next(out)) return false;
    for (std::size_t i = before; i < out.size(); ++i) {
      const Pair pair = out[i];
      out[kept] = pair;
      kept += keep_(pair);
    }
    out.resize(kept);
    return true;
  }

  bool touching() const override { return all_->touching(); }
  std::string describe() const override { return all_->describe(); }

 private:
  std::unique_ptr<Candidates> all_;
  Keep keep_;
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
