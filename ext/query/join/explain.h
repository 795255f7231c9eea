// Statistics of a join's stages: how many pairs each removes, and its cost. predictive_explain as a library
// call.
//
//   for (const ExplainRow& row : explain_join({.a = ships, .now = 600, .h = 600}, interrupt))
//     use(row.stage, row.before, row.after, row.seconds, row.detail);
//
// The stages, in this order: candidates, projection overlap, centre point, time interval, trajectory
// intersection, exact time, refinement (docs/explanation/gpcd.md). The pairs that one stage keeps are the input of the
// next. The input of the first is all queried pairs; the last keeps those that touch. Where a side has
// outlines or meshes, exact time decides on the smallest boxes around them, and refinement on the shapes;
// elsewhere refinement is left out. Where objects have plans, these stages count pairs of legs, and an eighth one,
// movers, joins those that touch to pairs of objects, the rows of the join. With method gpcd this is the join
// itself. The other methods go from candidates to exact time directly, and the stages between are measured on their
// pairs.
//
// Guarantee: which pairs touch depends on the query alone, and so does whether a test removes a given pair.
// Which candidates an index yields, and so the counts between, depends a little on the order of the scene's
// rows too: the grid's cells and places follow a sample. The rows of a table may come in another order after
// a join by the tree, which needs leaf order, and after a change of the table. Seconds are processor time of
// this thread, read once per stage and batch of some thousand pairs; those of candidates include the swept
// boxes and the index. Without objects on either side there are no rows. Cost: the join's, and that of the
// stages that the join leaves out.
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

  /// In percent (eq. 5); empty if the stage had no input.
  std::optional<double> prune_power() const {
    if (before == 0) return {};
    return 100 * static_cast<double>(before - after) / static_cast<double>(before);
  }
};

/// Throws Error as Join does. Ignores which rows of `question` are wanted: only_a, only_b, queried_t, queried_dt,
/// order, all_contacts, wants, likely_rows and helpers.
std::vector<ExplainRow> explain_join(const JoinQuestion& question, Interrupt& interrupt);

}  // namespace foresee
