#include "shape/swept_boxes.h"

#include <limits>

#include "base/float_environment.h"
#include "motion/swept_box.h"

namespace foresee {

namespace {

constexpr std::size_t rows_per_check = 4096;

/// Whether the predicate holds for a row.
template <class Predicate>
bool any_row(const Bodies& bodies, Interrupt& interrupt, Predicate&& holds) {
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % rows_per_check == 0) interrupt.check();
    if (holds(bodies.row(i))) return true;
  }
  return false;
}

}  // namespace

bool all_exist_at_start(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt) {
  if (bodies.at.t == Offsets::absent) return horizon.now >= 0;
  return !any_row(bodies, interrupt, [&](const double* row) {
    const double t = row[bodies.at.t];
    return t > horizon.now && !(t - horizon.now > horizon.h);
  });
}

bool all_exist_throughout(const Bodies& bodies, const Horizon& horizon, Interrupt& interrupt) {
  const Offsets& at = bodies.at;
  if (at.t == Offsets::absent && at.until == Offsets::absent && horizon.now >= 0) return true;
  return !any_row(bodies, interrupt, [&](const double* row) {
    const double t = value_or(row, at.t, 0);
    const bool late = t > horizon.now;
    const bool early = at.until != Offsets::absent && row[at.until] - horizon.now < horizon.h;
    return (late || early) &&
           !life_of(t, value_or(row, at.until, std::numeric_limits<double>::infinity()), horizon).none;
  });
}

template <int D>
std::vector<Box<D>> swept_boxes(const Bodies& bodies, const Horizon& horizon, const Vec<D>& margin,
                                Interrupt& interrupt) {
  const FloatEnvironment environment;
  std::vector<Box<D>> boxes;
  boxes.reserve(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % rows_per_check == 0) interrupt.check();
    boxes.push_back(swept_box<D>(bodies, i, horizon, margin));
  }
  return boxes;
}

template std::vector<Box<1>> swept_boxes<1>(const Bodies&, const Horizon&, const Vec<1>&, Interrupt&);
template std::vector<Box<2>> swept_boxes<2>(const Bodies&, const Horizon&, const Vec<2>&, Interrupt&);
template std::vector<Box<3>> swept_boxes<3>(const Bodies&, const Horizon&, const Vec<3>&, Interrupt&);

}  // namespace foresee
