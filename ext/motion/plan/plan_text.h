// Reads plans from well-known text with measures (WKT; OGC Simple Features, part 1, section 7), strictly, and writes
// them.
//
//   const Plan plan = read_plan("LINESTRING M(0 0 0, 10 0 5, 10 0 9)", interrupt);   // x y t per knot
//   write_plan(plan, interrupt) == "LINESTRING M(0 0 0, 10 0 5, 10 0 9)"
//
// LINESTRING M has x, y and the time, LINESTRING ZM also z; MULTILINESTRING M and ZM have parts, between which the
// mover does not exist, or jumps. Any case and white space; LINESTRINGM is read too. The last time may be inf or
// infinity, at the place of the knot before: the mover rests permanently. A prefix "SRID=n;" is dropped as for
// outlines (base/text/wkt_lexer.h). Numbers are the nearest doubles, and are written with the fewest digits that
// read back to the same double. Throws Error, which names the character, the knot or the part. Cost: some 20 ns
// per number to read, some 60 to write.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text/wkt_lexer.h"
#include "motion/plan/plan.h"

namespace foresee {

/// A plan of PlanKind::knots, which check_plan() accepts.
Plan read_plan(std::string_view text, Interrupt& interrupt, WktUnit unit = WktUnit::metres);

/// Requires: PlanKind::knots on two or three axes.
std::string write_plan(const Plan& plan, Interrupt& interrupt);

}  // namespace foresee
