// How much does each of the paper's stages remove, and what does it cost? predictive_explain as a library
// call.
//
//   for (const ExplainRow& row : explain_join({.a = ships, .now = 600, .h = 600}, interrupt))
//     use(row.stage, row.before, row.after, row.seconds, row.detail);
//
// The stages, in this order: candidates, projection overlap, centre point, time interval, trajectory
// intersection, exact time, refinement (docs/gpcd.md). What one leaves is what the next begins with; the
// first begins with all pairs of the question, the last leaves those that touch. Where a side has outlines
// or meshes, exact time decides about the smallest boxes around them and refinement about these; elsewhere
// that is left out. With method gpcd this is the join itself; the other methods go from candidates to exact
// time at once, and the stages between are measured on their pairs.
//
// Guarantee: which pairs touch depends on the question alone, and so does whether a test removes a given
// pair. What an index hands on, and so the counts between, depends a little on the order of the scene's rows
// too: the grid's cells and places follow a sample. The rows of one table may come in another order after a
// question by the tree, which needs them leaf by leaf, and after a change of the table. Seconds are processor
// time of this thread, taken once a stage and batch of some thousand pairs; the candidates' include the swept
// boxes and the index. Without objects on either side there are no rows. Cost: the join's, and the stages'
// that it leaves out.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "query/join/question.h"

namespace foresee {

struct ExplainRow {
  const char* stage;
  std::uint64_t before = 0, after = 0;
  double seconds = 0;
  std::string detail = {};

  /// In percent (eq. 5); nothing where there was nothing to remove.
  std::optional<double> prune_power() const {
    if (before == 0) return {};
    return 100 * static_cast<double>(before - after) / static_cast<double>(before);
  }
};

/// Throws Error as Join does. Of the question's wishes (only_a, queried_t, order, wants) none is regarded.
std::vector<ExplainRow> explain_join(const JoinQuestion& question, Interrupt& interrupt);

}  // namespace foresee
