// Who might touch? Every index answers with candidates: pairs of row numbers that may touch during the
// horizon, pulled in batches.
//
//   auto candidates = make_gpcd_grid<2>({ships, horizon, margin}, nullptr, interrupt);
//   std::vector<Pair> batch;
//   while (candidates->next(batch)) { …; batch.clear(); }
//
// Guarantee: every pair that touches comes exactly once; other pairs may come too, none twice. What an index
// knows decides how many those are: swept boxes that meet (space), or beams that do (space and time). In a
// self-join the two row numbers of a pair differ and come in any order. Empty boxes meet nothing.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "shape/swept_boxes.h"

namespace foresee {

class Candidates {
 public:
  virtual ~Candidates() = default;

  /// Appends the next candidates to `out`; false once there are none left (then nothing is appended).
  /// A batch is some hundred pairs or a few thousand, so that memory stays small and the first rows come
  /// early; it may be empty.
  virtual bool next(std::vector<Pair>& out) = 0;

  /// Whether it is certain that all pairs of the last batch touch when the horizon begins: none needs a look.
  virtual bool touching() const { return false; }

  /// What has been built to find them, for people: sizes and counts; "" where there is nothing to tell.
  virtual std::string describe() const { return {}; }
};

/// Candidates in parts, for several threads.
class DividedCandidates {
 public:
  virtual ~DividedCandidates() = default;
  virtual std::size_t parts() const = 0;
  /// Each part is asked for once, by any thread, and looked at by the thread whose `interrupt` it takes.
  virtual std::unique_ptr<Candidates> part(std::size_t i, Interrupt& interrupt) = 0;
};

}  // namespace foresee
