// The exact stage of a join: which candidates of a slab are rows of the answer, and what stands in them?
//
//   ContactStage stage(question, interrupt);
//   stage.answer(candidates, batch, slab, rows);         // at once, or where hits are sorted in between:
//   stage.query(candidates, batch, slab, hits);            // contact, and all that the question leaves out
//   stage.write(hits, rows);                             // ids, times, closest approach
//
// Of a batch that touches for certain when the slab begins nothing is asked.
//
// Keeps scratch space: used by one thread at a time; several may share a question.
#pragma once

#include "index/candidates.h"
#include "query/join/time_slabs.h"

namespace foresee {

/// Pairs that touch, in the question's columns, and when.
struct Hits {
  std::vector<Pair> pairs;
  std::vector<ContactTimes> times;
  bool with_ends = false;

  void clear() { pairs.clear(), times.clear(), with_ends = false; }
};

class ContactStage {
 public:
  /// For this question's pairs (contact_of). Both must outlive the stage. Throws Error for shapes without a
  /// distance.
  ContactStage(const JoinQuestion& question, Interrupt& interrupt);

  Contact::Reach reach() const { return contact_->reach(); }

  /// Appends those of the last batch that are hits and that `slab` holds to `hits`, in order; the batch is
  /// lost. Ends may be left for write(). Times are computed where they are read or decide, and where it is
  /// not certain what they are.
  void query(const Candidates& candidates, std::vector<Pair>& batch, const TimeSlab& slab, Hits& hits);

  /// Appends a row for each hit, in order, with the columns that the question wants.
  void write(Hits& hits, std::vector<JoinRow>& rows);

  /// Both.
  void answer(const Candidates& candidates, std::vector<Pair>& batch, const TimeSlab& slab,
              std::vector<JoinRow>& rows);

  /// Whether answer() would do no more with the last batch than write_touching().
  bool would_only_write(const Candidates& candidates) const;
  /// Whether pairs that touch when the slab begins are rows of it, and not of an earlier one.
  bool queries_start(const TimeSlab& slab) const;
  /// Appends their rows.
  void write_touching(std::span<const Pair> pairs, std::vector<JoinRow>& rows) const;

 private:
  /// work(begin, count) for all of them, slice by slice in order; heeds an interrupt before each.
  template <class Work>
  void in_slices(std::size_t count, Work work);
  /// Appends the asked pairs of a batch that touches for certain at `now`; the batch is lost.
  void take_touching(std::vector<Pair>& batch, Hits& hits) const;
  /// Leaves the pairs that the question asks about, in order and in its columns: the ids asked for, no object
  /// with itself, and within one scene the smaller id first.
  void keep_queried_pairs(std::vector<Pair>& batch) const;
  /// Of the hits from number `first` on leaves those whose times the slab holds and the question asks about,
  /// in order.
  void keep_queried_times(const TimeSlab& slab, std::size_t first, Hits& hits) const;
  /// The same hits, with the ends of their contacts.
  void add_ends(Hits& hits);

  const JoinQuestion& question_;
  Interrupt& interrupt_;
  std::unique_ptr<Contact> contact_;
  Hits hits_;
  std::vector<Pair> without_ends_;
  std::vector<ClosestApproach> approaches_;
};

}  // namespace foresee
