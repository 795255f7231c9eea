// The exact stage of a join: which candidates of a slab are rows of the answer, and what stands in them?
//
//   ContactStage stage(question, interrupt);
//   stage.ask(candidates, slab, hits);                   // contact, and all that the question leaves out
//   stage.write(hits, rows);                             // ids, times, closest approach
//
// Keeps scratch space: used by one thread at a time; several may share a question.
#pragma once

#include "query/time_slabs.h"

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
  /// Both must outlive the stage. Throws Error for shapes without a distance.
  ContactStage(const JoinQuestion& question, Interrupt& interrupt);

  Contact::Reach reach() const { return contact_->reach(); }

  /// Puts the hits that `slab` holds into `hits`, in the order of the candidates, which are lost. Ends may be
  /// left for write(). Times are computed where they are read or decide.
  void ask(std::vector<Pair>& candidates, const TimeSlab& slab, Hits& hits);

  /// Appends a row for each hit.
  void write(Hits& hits, std::vector<JoinRow>& rows);

 private:
  template <class Work>
  void in_slices(std::size_t count, Work work);
  void keep_asked_pairs(std::vector<Pair>& candidates) const;
  void keep_asked_times(const TimeSlab& slab, Hits& hits) const;
  void add_ends(Hits& hits);

  const JoinQuestion& question_;
  Interrupt& interrupt_;
  std::unique_ptr<Contact> contact_;
  std::vector<Pair> without_ends_;
  std::vector<ClosestApproach> approaches_;
};

}  // namespace foresee
