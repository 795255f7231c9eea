// The hits of one slab in the order that the question asks for.
//
//   do {
//     while (next(hits)) sorted.add(hits, interrupt);      // all hits of the slab
//     sorted.sort(interrupt);
//     while (sorted.any()) sorted.take(hits);
//   } while (sorted.leaves_some_out());
//
// Hits wait here as 24 bytes each; ends and closest approaches are computed when rows are made, so that a
// LIMIT spares them. Where few rows are likely to be read (question.likely_rows), no more than twice as many
// hits are kept, the first ones. Whoever reads on has the slab answered again, for eight times as many of
// those that follow: memory stays within a factor of what is read.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "query/join/contact_stage.h"

namespace foresee {

class SortedHits {
 public:
  explicit SortedHits(const JoinQuestion& question)
      : question_(question), room_(std::max(min_room, question.likely_rows)) {}

  /// Of the slab's hits behind those taken the first are kept, at least as many as are likely to be read; of
  /// the others some may be left out (leaves_some_out).
  void add(const Hits& hits, Interrupt& interrupt);
  /// When all hits of the slab were added.
  void sort(Interrupt& interrupt);

  /// After sort(): are there hits left, and the next few of them.
  bool any() const { return given_ < sorted_; }
  void take(Hits& hits);

  /// After the last one: whether the slab has others. What is added then begins behind those that were taken.
  bool leaves_some_out() { return std::exchange(cut_, false); }

  /// How many hits wait.
  std::size_t size() const { return found_.size(); }

 private:
  static constexpr std::size_t min_room = 4096, growth = 8;

  struct Found {
    double t, dt;
    Pair pair;
  };
  /// In the question's order, which ids or row numbers make strict: no two hits are equal.
  bool precedes(const Found& l, const Found& r) const;
  void keep_first(Interrupt& interrupt);

  const JoinQuestion& question_;
  std::size_t room_;
  std::vector<Found> found_;
  std::size_t sorted_ = 0, given_ = 0;
  bool cut_ = false;            ///< hits behind `last_` have been left out
  Found last_{};                ///< of those that were kept
  std::optional<Found> after_;  ///< the last one that was taken, where a slab is answered again
};

}  // namespace foresee
