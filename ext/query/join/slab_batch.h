// What a helper thread hands over: answers to some candidates of a slab, in their order.
//
//   batch.add_touching(pairs);                           // the helper, as often as it likes
//   batch.add_rows([&](auto& rows) { stage.answer(part, pairs, slab, rows); });
//   for (auto rows = batch.next(stage); !rows.empty(); rows = batch.next(stage)) …   // the reader
//
// Pairs that touch are handed over as they are, and the reader writes their rows: these are nine times as
// large, and to carry them from one processor to another takes longer than to write them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "query/join/contact_stage.h"

namespace foresee {

class SlabBatch {
 public:
  Hits hits;  ///< that need sorting: then a batch has nothing else

  /// Pairs for ContactStage::write_touching().
  void add_touching(std::span<const Pair> pairs) {
    touching_.insert(touching_.end(), pairs.begin(), pairs.end());
    add_run(true, pairs.size());
  }
  /// What `answer` appends to rows.
  template <class Answer>
  void add_rows(Answer answer) {
    const std::size_t before = rows_.size();
    answer(rows_);
    add_run(false, rows_.size() - before);
  }

  /// Some rows that have not been read yet; empty once there are none. Valid until the next call.
  std::span<const JoinRow> next(const ContactStage& stage) {
    if (run_ == runs_.size()) return {};
    return runs_[run_].touching ? write_some(runs_[run_], stage) : rows_of(runs_[run_]);
  }

  std::size_t bytes() const {
    return hits.pairs.size() * (sizeof(Pair) + sizeof(ContactTimes)) + rows_.size() * sizeof(JoinRow) +
           touching_.size() * sizeof(Pair);
  }
  void clear() {
    hits.clear(), rows_.clear(), touching_.clear(), runs_.clear();
    run_ = rows_read_ = touching_read_ = 0;
  }

 private:
  /// So many of one kind, in a row.
  struct Run {
    bool touching;
    std::size_t size;
  };

  void add_run(bool touching, std::size_t size) {
    if (size == 0) return;
    if (!runs_.empty() && runs_.back().touching == touching)
      runs_.back().size += size;
    else
      runs_.push_back({touching, size});
  }
  std::span<const JoinRow> rows_of(const Run& run) {
    const auto rows = std::span<const JoinRow>(rows_).subspan(rows_read_, run.size);
    rows_read_ += run.size, ++run_;
    return rows;
  }
  /// Few at a time: they stay in the first cache until they are read.
  std::span<const JoinRow> write_some(Run& run, const ContactStage& stage) {
    constexpr std::size_t few = 128;
    const std::size_t count = std::min(run.size, few);
    written_.clear();
    stage.write_touching(std::span<const Pair>(touching_).subspan(touching_read_, count), written_);
    touching_read_ += count, run.size -= count;
    if (run.size == 0) ++run_;
    return written_;
  }

  std::vector<JoinRow> rows_, written_;
  std::vector<Pair> touching_;
  std::vector<Run> runs_;
  std::size_t run_ = 0, rows_read_ = 0, touching_read_ = 0;  // what has been read
};

}  // namespace foresee
