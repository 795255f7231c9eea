// Plans through SQL: as values, as a column beside their legs as rows, and orbits.
//
//   bench_sql_plans [--values] [--movers] [--satellites] [--waits] [--hours N] [--quick]       (all modes without any)
//
//   --values      1,000 movers with 1,000 legs each (--quick: 100), on two axes: to make plans from rows, to read them
//                 as rows, to store their legs in a table. First one plan of 1,000,000 legs (--quick: 100,000), for the
//                 memory of each aggregate.
//   --movers      random way-points, one mover per 100 m², legs of 10 s, r = 1 m: 10,000 movers of 100 legs joined over
//                 900 s, 100,000 of 10 over 90 s (--quick: a tenth). Load, bytes, join with and without ends, and a
//                 commit of one new plan, each against the legs as rows; plans of one leg against plain rows.
//   --satellites  30,000 circular orbits (--quick: 3,000) of legs of 60 s for two hours (--hours): pairs within 3 km,
//                 seconds and peak memory; the pairs of some satellites against every other one, leg by leg.
//   --waits       predictive_avoid 'wait' of a mover among two others, for the whole plan: 2,000 legs each, and 20,000
//                 (--quick: 200 and 2,000).
//
// Processor time, medians of repetitions; ratios are within a repetition. Fails if plans and rows give different pairs.
#include "plans/modes.h"

namespace foresee::bench {
namespace {

int main_of(const Options& options) {
  return run_modes(options, {{"--values", measure_values},
                             {"--movers", measure_movers},
                             {"--satellites", measure_satellites},
                             {"--waits", measure_waits}});
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
