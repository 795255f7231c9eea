// One time slab of a join, answered by helper threads and the caller: candidates, contact and rows part by
// part.
//
//   SlabHelpers helpers(question, slab, sorts, reach, interrupt);
//   while (helpers.next(batch)) …                        // in the order of one thread
//
// Helpers never call SQLite. Each takes the next part of the grid; a part that is not yet read waits once it
// has some hundred kilobytes, and nobody runs far ahead, so memory stays bounded. The caller reads what is
// there; where there is nothing yet it takes a part too, and goes on with it between two batches. What a
// helper throws, next() throws after the batches that it has handed over; what the caller's own part throws,
// at once.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "query/join/contact_stage.h"

namespace foresee {

// What a helper thread hands over: answers to some candidates of a slab, in their order.
//
//   batch.add_touching(pairs);                           // the helper, as often as it likes
//   batch.add_rows([&](auto& rows) { stage.answer(part, pairs, slab, rows); });
//   for (auto rows = batch.next(stage); !rows.empty(); rows = batch.next(stage)) …   // the reader
//
// Pairs that touch are handed over as they are, and the reader writes their rows: these are nine times as
// large, and to carry them from one processor to another takes longer than to write them.

class SlabBatch {
 public:
  Hits hits;  ///< that need sorting: then a batch has nothing else

  /// Pairs for ContactStage::write_touching().
  void add_touching(std::span<const Pair> pairs) {
    touching_.insert(touching_.end(), pairs.begin(), pairs.end());
    add_chunk(true, pairs.size());
  }
  /// What `answer` appends to rows.
  template <class Answer>
  void add_rows(Answer answer) {
    const std::size_t before = rows_.size();
    answer(rows_);
    add_chunk(false, rows_.size() - before);
  }

  /// Some rows that have not been read yet; empty once there are none. Valid until the next call.
  std::span<const JoinRow> next(const ContactStage& stage) {
    if (chunk_ == chunks_.size()) return {};
    return chunks_[chunk_].touching ? write_some(chunks_[chunk_], stage) : rows_of(chunks_[chunk_]);
  }

  std::size_t bytes() const {
    return hits.pairs.size() * (sizeof(Pair) + sizeof(ContactTimes)) + rows_.size() * sizeof(JoinRow) +
           touching_.size() * sizeof(Pair);
  }
  void clear() {
    hits.clear(), rows_.clear(), touching_.clear(), chunks_.clear();
    chunk_ = rows_read_ = touching_read_ = 0;
  }

 private:
  /// So many of one kind, in a row.
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
    rows_read_ += chunk.size, ++chunk_;
    return rows;
  }
  /// Few at a time: they stay in the first cache until they are read.
  std::span<const JoinRow> write_some(Chunk& chunk, const ContactStage& stage) {
    constexpr std::size_t few = 128;
    const std::size_t count = std::min(chunk.size, few);
    written_.clear();
    stage.write_touching(std::span<const Pair>(touching_).subspan(touching_read_, count), written_);
    touching_read_ += count, chunk.size -= count;
    if (chunk.size == 0) ++chunk_;
    return written_;
  }

  std::vector<JoinRow> rows_, written_;
  std::vector<Pair> touching_;
  std::vector<Chunk> chunks_;
  std::size_t chunk_ = 0, rows_read_ = 0, touching_read_ = 0;  // what has been read
};

class SlabHelpers {
 public:
  /// Enters the slab's objects into a grid with question.helpers threads beside this one, then starts them.
  /// All must outlive this. `sorts`: batches have hits, otherwise rows.
  SlabHelpers(const JoinQuestion& question, const TimeSlab& slab, bool sorts, const Contact::Reach& reach,
              Interrupt& interrupt);
  /// Stops the helpers, which takes them a millisecond.
  ~SlabHelpers();
  SlabHelpers(const SlabHelpers&) = delete;
  SlabHelpers& operator=(const SlabHelpers&) = delete;

  /// The next batch in place of the one that has been read; false once there are none left.
  bool next(SlabBatch& batch);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace foresee
