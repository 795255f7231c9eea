// Outlines through SQL, beside boxes and discs of the same ships.
//
//   bench_sql_outlines [--quick] [--writes] [--joins] [--zones] [--real FILE]
//
//   --writes  100,000 ships as hulls that turn with their course, 50 outlines in all, as boxes around these,
//             and as discs (hulls/ships.h): loaded row by row in 20 transactions; 100,000 reports of a ship
//             each (t, place, speed, and heading or box) in one. A ratio is the others' time over the hulls'.
//   --joins   the same: the pairs that touch or come within 50 m in 600 s, counted, with times, joined to
//             both rows of their table; for 1000 ships by a = ?. What the refinement removes.
//   --zones   100 zones of 100 corners, in a table, over the positions of these ships as points, against
//             windows of their boxes, and against steps of 0.1 s over what the boxes let through.
//   --real    ships of the Lower Mississippi with hulls from length and width, within 0 and 50 m in 600 s,
//             against their boxes. FILE is the database that real_hulls.sh makes.
//
// Tables are in memory. Processor time, medians over repetitions in which each table is queried once, one
// after another. A table without outlines has no row, member or branch of theirs: there is nothing to
// compare.
#include "hulls/modes.h"

namespace foresee::bench {
namespace {

int main_of(Options options) {
  const bool quick = options.has("--quick");
  const auto file = options.value("--real");
  const bool all = !file && !options.has("--writes") && !options.has("--joins") && !options.has("--zones");
  if (all || options.has("--writes")) measure_hull_writes(quick);
  if (all || options.has("--joins")) measure_hull_joins(quick);
  if (all || options.has("--zones")) measure_zones(quick);
  if (file) measure_real_hulls(*file, quick);
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
