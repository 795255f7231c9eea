// Sorted hits of one time slab: a buffer that keeps the first ones, for ordered joins with a LIMIT.
//
//   do {
//     while (next(hits)) sorted.add(hits, interrupt);      // all hits of the slab
//     sorted.sort(interrupt);
//     while (sorted.any()) sorted.take(hits);
//   } while (sorted.take_left_out());
//
// A hit takes 24 bytes; ends and closest approaches are computed when rows are written, so a LIMIT saves
// them. If few rows are likely to be read (`likely_rows`), at most twice as many hits are kept, the
// first ones. If the reader continues, the slab is answered again for eight times as many of the hits that
// follow. Memory stays within a constant factor of the rows that are read.
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

  /// Keeps the first of the slab's hits after those taken, at least as many as are likely to be read. Others
  /// may be left out (take_left_out).
  void add(const Hits& hits, Interrupt& interrupt);
  /// Requires: all hits of the slab were added.
  void sort(Interrupt& interrupt);

  /// After sort(): whether hits are left, and the next few of them.
  bool any() const { return given_ < sorted_; }
  void take(Hits& hits);

  /// After the last hit was taken: whether hits of the slab were left out. True once: then the caller adds all hits of
  /// the slab again, and only those after the last hit are kept.
  bool take_left_out() { return std::exchange(cut_, false); }

  /// The number of hits in the buffer.
  std::size_t size() const { return found_.size(); }

 private:
  static constexpr std::size_t min_room = 4096, growth = 8;

  struct Found {
    double t, dt;
    Pair pair;
  };
  /// In the requested order. dt, ids or row numbers break ties, so no two hits are equal.
  bool precedes(const Found& l, const Found& r) const;
  void keep_first(Interrupt& interrupt);

  const JoinQuestion& question_;
  std::size_t room_;
  std::vector<Found> found_;
  std::size_t sorted_ = 0, given_ = 0;
  bool cut_ = false;            ///< hits after `last_` have been left out
  Found last_{};                ///< the last hit that was kept
  std::optional<Found> after_;  ///< the last hit that was taken, while a slab is answered again
};

}  // namespace foresee
