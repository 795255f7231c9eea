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

#include "query/join/slab_batch.h"

namespace foresee {

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
