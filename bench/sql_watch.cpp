// Watches through SQL: the cost of keeping the pairs of a join, beside computing them again and beside
// triggers.
//
//   bench_sql_watch [--quick] [--reports] [--growth] [--ships]
//
// Every figure is a ratio of processor times measured in this run, with its goal. Tables are in files with
// the default journal; no commit waits for the disk (PRAGMA synchronous = OFF). Reports are those of
// reports/feed.h: single-row UPDATEs by id of t, place, speed and acceleration of an object drawn at random.
// The clock of the watch follows their t, 1/n second per report. A watch has horizon = 3, the scene's.
//
//   --reports  S-100000 (workloads.h): 1, 100, 1000 and 10,000 reports per commit, and all objects in one,
//              beside the watch, with the same reports:
//
//              join + compare: the same table without a watch; before COMMIT predictive_join goes into a
//              temporary table, which is compared in SQL with a table of pairs; the differences go into a
//              table of changes and into the pairs (watches/compared_join.cpp). Both must hold the same pairs
//              at the end.
//
//              R*Tree + trigger: base table and R*Tree of swept boxes, both of which a report updates; a
//              trigger finds the pairs of the object with foresee's own contact as an SQL function and writes
//              pairs and changes (watches/triggered_pairs.cpp). It queries from 0 on, as its clock is fixed.
//
//              R*Tree with base table: both updated, without pairs.
//
//              (--quick: S-10000, without 10,000 reports.)
//
//   --growth   one report per commit: S-1000000 beside S-62500, both watched; S-100000 without a watch in a
//              file that has a watch of another table, beside a file without any. (--quick: a tenth.)
//
//   --ships    99,647 reports of 10,616 ships (the file of AIS reports in ../shared/data, or in the folder
//              that FORESEE_SHARED_DATA names; skipped where it is not), as points in a plane, horizon = 600,
//              within = 926. Each second of reports is a commit; after ten minutes, when nearly all of them
//              have reported, two are timed: the watch beside join + compare, and the rows of pairs that it
//              writes for a report. Then the clock alone, a second at a time for 600 s: 'advance' beside all
//              rows of predictive_join at each, and beside a commit of as many pages of an ordinary table.
//              (--quick: ten seconds, ten more, and 60 s of the clock.)
//
// Fails if two sides that must agree hold other pairs.
#include "watches/modes.h"

namespace foresee::bench {
namespace {

int main_of(const Options& options) {
  return run_modes(options, {{"--reports", measure_watched_reports},
                             {"--growth", measure_watch_growth},
                             {"--ships", measure_watched_ships}});
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
