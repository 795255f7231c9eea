#include "shape/lives.h"

#include <limits>

#include "motion/life.h"

namespace foresee {
namespace {

constexpr std::size_t lives_per_check = 8192;

}  // namespace

bool all_exist_at_begin(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt) {
  if (bodies.at.t == Offsets::absent) return horizon.now >= 0;
  bool late = false;
  for (std::size_t i = 0; i < bodies.count && !late; ++i) {
    if (i % lives_per_check == 0) interrupt.check();
    const double t = bodies.row(i)[bodies.at.t];
    late = t > horizon.now && !(t - horizon.now > horizon.h);
  }
  return !late;
}

bool all_exist_throughout(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt) {
  const Offsets& at = bodies.at;
  if (at.t == Offsets::absent && at.until == Offsets::absent && horizon.now >= 0) return true;
  bool partly = false;
  for (std::size_t i = 0; i < bodies.count && !partly; ++i) {
    if (i % lives_per_check == 0) interrupt.check();
    const double* row = bodies.row(i);
    const double t = value_or(row, at.t, 0);
    const bool late = t > horizon.now;
    const bool early = at.until != Offsets::absent && row[at.until] - horizon.now < horizon.h;
    partly = (late || early) &&
             !life_of(t, value_or(row, at.until, std::numeric_limits<double>::infinity()), horizon).none;
  }
  return !partly;
}

}  // namespace foresee
