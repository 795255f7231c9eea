// Exact stage of a join: decides which candidates of a time slab touch, and fills the rows of the result.
//
//   ContactStage stage(question, interrupt);
//   const BatchProof proof = proof_of(candidates);
//   stage.find_and_write(batch, proof, slab, rows);      // in one step; where hits are sorted in between:
//   stage.find_hits(batch, proof, slab, hits);           // contact, and the conditions of `question`
//   stage.write_rows(hits, rows);                        // ids, times, closest approach
//
// A batch that certainly touches when the slab starts needs no contact test.
//
// Keeps scratch space: used by one thread at a time; several may share a JoinQuestion.
#pragma once

#include "index/candidates.h"
#include "query/join/time_slabs.h"

namespace foresee {

/// Pairs that touch, each in the order of the columns a and b, and their contact times.
struct Hits {
  std::vector<Pair> pairs;
  std::vector<ContactTimes> times;
  bool with_ends = false;  ///< else the times have no t_end and dt_end yet

  void clear() {
    pairs.clear();
    times.clear();
    with_ends = false;
  }
};

/// What an index has proved of all pairs of a batch.
enum class BatchProof : std::uint8_t { none, touch_at_start };

/// Of the last batch of `candidates`.
inline BatchProof proof_of(const Candidates& candidates) {
  return candidates.touching() ? BatchProof::touch_at_start : BatchProof::none;
}

class ContactStage {
 public:
  /// For the pairs of `question` (contact_of). Both arguments must outlive the stage. Throws Error for shapes
  /// without a distance.
  ContactStage(const JoinQuestion& question, Interrupt& interrupt)
      : ContactStage(question, contact_of(question), interrupt) {}
  /// With a contact test that the caller has made: contact_of() the same scenes, time and distances.
  ContactStage(const JoinQuestion& question, std::shared_ptr<Contact> contact, Interrupt& interrupt);

  /// Appends the pairs of the batch that touch, and whose time `slab` holds, to `hits`, in order; the batch is
  /// overwritten. Ends may be left to write_rows(). Times are computed only where they are read, decide
  /// whether a pair is a hit, or are not certain yet.
  void find_hits(std::vector<Pair>& batch, BatchProof proof, const TimeSlab& slab, Hits& hits);

  /// Appends a row for each hit, in order, with the columns of JoinQuestion::wants. Computes ends that find_hits()
  /// has left out.
  void write_rows(Hits& hits, std::vector<JoinRow>& rows);

  /// find_hits() and write_rows() in one step.
  void find_and_write(std::vector<Pair>& batch, BatchProof proof, const TimeSlab& slab,
                      std::vector<JoinRow>& rows);

  /// Whether find_and_write() would do nothing with a batch of this proof but write_touching().
  bool would_only_write(BatchProof proof) const;
  /// Whether a contact that starts at `now` is a row of this slab: by the slab, and by the queried t and dt.
  bool queries_start(const TimeSlab& slab) const;
  /// Appends the rows of pairs that touch at `now`.
  void write_touching(std::span<const Pair> pairs, std::vector<JoinRow>& rows) const;

 private:
  /// find_hits() for all contacts of each pair, with their ends.
  void find_all_contacts(std::vector<Pair>& batch, const TimeSlab& slab, Hits& hits);
  /// Computes the ends of hits of find_all_contacts() that were sorted: a hit stands for all contacts of its pair
  /// with its t and dt.
  void add_all_ends(Hits& hits);
  /// Calls work(begin, count) for slices of [0, count), in order; checks for an interrupt before each.
  template <class Work>
  void in_slices(std::size_t count, Work work);
  /// Appends the queried pairs of a batch that certainly touches at `now`; the batch is overwritten.
  void add_touching(std::vector<Pair>& batch, Hits& hits) const;
  /// Keeps the queried pairs, in order and with the objects in their columns: the requested ids, and within one
  /// scene the smaller id first. No object is paired with itself or another of its legs.
  void keep_queried_pairs(std::vector<Pair>& batch) const;
  /// Keeps, of the hits from number `first` on, those whose times the slab and the queried times hold, in
  /// order.
  void keep_queried_times(const TimeSlab& slab, std::size_t first, Hits& hits) const;
  /// Computes the ends of the contacts of all hits.
  void add_ends(Hits& hits);

  const JoinQuestion& question_;
  Interrupt& interrupt_;
  std::shared_ptr<Contact> contact_;
  Hits hits_;
  std::vector<Pair> without_ends_;
  Hits without_all_ends_;
  std::vector<ClosestApproach> approaches_;
};

}  // namespace foresee
