// The hits of one slab in the order that the question asks for.
//
// Hits wait here as 24 bytes each; ends and closest approaches are computed when rows are made, so that a
// LIMIT spares them.
#pragma once

#include "query/join/contact_stage.h"

namespace foresee {

class SortedHits {
 public:
  explicit SortedHits(const JoinQuestion& question) : question_(question) {}

  void add(const Hits& hits);
  void sort(Interrupt& interrupt);

  /// After sort(): are there hits left, and the next few of them.
  bool any() const { return given_ < sorted_; }
  void take(Hits& hits);

 private:
  struct Found {
    double t, dt;
    Pair pair;
  };
  bool precedes(const Found& l, const Found& r) const;

  const JoinQuestion& question_;
  std::vector<Found> found_;
  std::size_t sorted_ = 0, given_ = 0;
};

}  // namespace foresee
