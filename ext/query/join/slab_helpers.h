// Parallel execution of one time slab of a join: helper threads and the caller answer partitions of the grid.
//
//   SlabHelpers helpers(question, slab, sorts, interrupt);
//   while (helpers.next(batch)) …                        // in the order of one thread
//
// Helpers never call SQLite. Each takes the next partition of the grid. A helper pauses once some hundred
// kilobytes of its partition are unread, and none runs far ahead of the reader, so memory stays bounded. The
// caller reads finished batches; if none is ready it takes a partition too, and continues it between two
// batches. An exception of a helper is rethrown by next() after the batches that it has handed over; one of
// the caller's own partition at once.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "query/join/contact_stage.h"

namespace foresee {

// Batch of results that a helper thread hands over: rows, hits or touching pairs, in the candidates' order.
//
//   batch.add_touching(pairs);                           // the helper, any number of times
//   batch.add_rows([&](auto& rows) { stage.find_and_write(pairs, proof_of(part), slab, rows); });
//   for (auto rows = batch.next(stage); !rows.empty(); rows = batch.next(stage)) …   // the reader
//
// Touching pairs are handed over as pairs, and the reader writes their rows. A row is nine times as large as
// a pair, and its transfer from one processor to another takes longer than writing it.
class SlabBatch {
 public:
  Hits hits;  ///< to be sorted; a batch with hits has neither rows nor pairs

  /// Pairs for ContactStage::write_touching().
  void add_touching(std::span<const Pair> pairs) {
    touching_.insert(touching_.end(), pairs.begin(), pairs.end());
    add_chunk(true, pairs.size());
  }
  /// Adds the rows that `append(rows)` appends.
  template <class Append>
  void add_rows(Append append) {
    const std::size_t before = rows_.size();
    append(rows_);
    add_chunk(false, rows_.size() - before);
  }

  /// The next rows of the batch; empty at its end. Valid until the next call.
  std::span<const JoinRow> next(const ContactStage& stage) {
    if (chunk_ == chunks_.size()) return {};
    return chunks_[chunk_].touching ? write_some(chunks_[chunk_], stage) : rows_of(chunks_[chunk_]);
  }

  std::size_t bytes() const {
    return hits.pairs.size() * (sizeof(Pair) + sizeof(ContactTimes)) + rows_.size() * sizeof(JoinRow) +
           touching_.size() * sizeof(Pair);
  }
  void clear() {
    hits.clear();
    rows_.clear();
    touching_.clear();
    chunks_.clear();
    chunk_ = rows_read_ = touching_read_ = 0;
  }

 private:
  /// A run of consecutive results of one kind.
  struct Chunk {
    bool touching;
    std::size_t size;
  };

  void add_chunk(bool touching, std::size_t size) {
    if (size == 0) return;
    if (!chunks_.empty() && chunks_.back().touching == touching)
      chunks_.back().size += size;
    else
      chunks_.push_back({touching, size});
  }
  std::span<const JoinRow> rows_of(const Chunk& chunk) {
    const auto rows = std::span<const JoinRow>(rows_).subspan(rows_read_, chunk.size);
    rows_read_ += chunk.size;
    ++chunk_;
    return rows;
  }
  /// A few rows at a time: they stay in the first-level cache until they are read.
  std::span<const JoinRow> write_some(Chunk& chunk, const ContactStage& stage) {
    constexpr std::size_t few = 128;
    const std::size_t count = std::min(chunk.size, few);
    written_.clear();
    stage.write_touching(std::span<const Pair>(touching_).subspan(touching_read_, count), written_);
    touching_read_ += count;
    chunk.size -= count;
    if (chunk.size == 0) ++chunk_;
    return written_;
  }

  std::vector<JoinRow> rows_, written_;
  std::vector<Pair> touching_;
  std::vector<Chunk> chunks_;
  std::size_t chunk_ = 0, rows_read_ = 0, touching_read_ = 0;  // position of the reader
};

/// Of the wanted helper threads at most 16, or twice the machine's processors if that is more: others would only wait
/// for a processor.
std::size_t useful_helpers(std::size_t wanted);

class SlabHelpers {
 public:
  /// Builds a grid of the slab's objects with `question.helpers` threads besides the caller's, then starts
  /// the helpers. All arguments must outlive this. `sorts`: batches have hits, otherwise rows and pairs.
  SlabHelpers(const JoinQuestion& question, const TimeSlab& slab, bool sorts, Interrupt& interrupt);
  /// Stops the helpers, which takes about a millisecond.
  ~SlabHelpers();
  SlabHelpers(const SlabHelpers&) = delete;
  SlabHelpers& operator=(const SlabHelpers&) = delete;

  /// Replaces the batch, which has been read, by the next one; false at the end.
  bool next(SlabBatch& batch);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace foresee
