// Storage at the speed of a feed: reports, loads and look-ups through SQL.
//
//   bench_sql_reports [--quick] [--updates] [--commits] [--loads] [--lookups] [--after] [--lives] [--planner]
//                     [--degrees] [--memory] [--journal] [--wal] [scene ...]
//
// The objects of a scene (workloads.h) report their position and motion; reports/feed.h describes how a
// report is made. Ours is a moving_objects table with t (without t if it is only loaded and read by id). The
// R*Tree is SQLite's, of the boxes swept from t over the scene's horizon, beside an ordinary table of the
// same columns. A report updates both; its boxes are ready before the clock starts. All statements are
// prepared; a report is one single-row UPDATE by id of t, position, speed and acceleration (if the scene has
// one). Tables are in memory, in a file with the default journal, or in one with WAL. No commit waits for the
// disk (PRAGMA synchronous = OFF). Ids count from 1 in the order of the scene's rows, which are in no spatial
// order.
//
//   --updates  S-100000, S-1000000, P-zipf-5000, L-30, M-100000, each in every medium:
//              100,000 reports of random objects in one transaction, against the R*Tree;
//              one report of every object in random order in one transaction: in memory against a load of the
//              same rows, in a file against the ordinary table alone;
//              one report per transaction, 2000 per repetition, against the R*Tree.
//              (--quick: S-100000 and P-zipf-5000, in memory.)
//   --commits  S-1000000 in a file, journal and WAL: 100,000 transactions of one report: the median and the
//              slowest, and how many pages a commit writes. (--quick: 10,000, S-100000.)
//   --loads    S-500000 into a file, with the default journal (--wal: with WAL), ids ascending or shuffled, in
//              1, 20 and 100 transactions, each beside an ordinary table; of twenty, shuffled, then one UPDATE
//              of all rows, 'optimize', 'rebuild', and a DELETE of a third (us per row of the table). Each in a
//              process of its own, with the bytes that it writes and its peak memory beyond that of an empty
//              table. us a row are compared with the first
//              load of the first scene: --loads S-500000 S-10000000 shows how they grow. Then a load in one
//              transaction against the R*Tree, for scenes up to a million. (--quick: S-100000.)
//   --lookups  S-1000000, in memory: x of a fifth of the ids, drawn at random, in that or in rising order: by
//              a prepared query, from a list table by CROSS JOIN, by IN; ranges of 100 ids; and the pairs of
//              a join with horizon 11 joined to the table by id on one side or both. Against an ordinary
//              table of the same rows in the same database; the time of list or join alone is subtracted on
//              both sides.
//              (--quick: S-100000.)
//   --after    S-100000 and S-1000000, in memory: every object reports ten times, each time in ten
//              transactions of a random tenth. Then joins, windows of about 10, 100 and 1000, nearest and
//              a = ?, against a fresh table of the same objects, and the size of both. Two other tables are loaded
//              in twenty and in a hundred transactions, and read each time that a twentieth is loaded: the
//              median and the slowest of the twenty.
//              Scenes of two axes. (--quick: S-100000.)
//   --lives    10,000 and 100,000 objects as those of S, in memory, that come and go and never report: each lives
//              for 50 s. Windows of about 10 and nearest, sixteen times in two lives, against a fresh table of
//              the same rows. (--quick: 10,000.)
//   --planner  S-100000, S-1000000 and L-30: tables joined to functions as one writes it, and in the orders
//              that CROSS JOIN can prescribe: ships s JOIN predictive_join(60, 'ships') j ON j.a = s.id WHERE
//              s.x < 100; then with the scene's horizon the same, and by a box, by id, both sides, LEFT JOIN,
//              a window for each of 1000 zones. A prescribed order that takes more than twice as long is
//              stopped. (--quick: S-10000 and L-30.)
//   --degrees  500,000 reports in knots with a name, ids in random order, into a file: a table in degrees
//              against a plain table of the projected metres, and against INSERT … SELECT through
//              geo_to_plane; then all rows and a join. (--quick: 50,000.)
//
// Processor time, medians; a ratio is the other side's time over ours in the same repetition, unless it says
// "times". Fails if two sides that must agree hold different rows or give different results.
#include "reports/modes.h"

namespace foresee::bench {
namespace {

int main_of(const Options& options) {
  return run_modes(options, {{"--updates", measure_updates},
                             {"--commits", measure_commits},
                             {"--loads", measure_loads},
                             {"--lookups", measure_lookups},
                             {"--after", measure_after},
                             {"--lives", measure_lives},
                             {"--planner", measure_planner},
                             {"--degrees", measure_degrees}});
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
