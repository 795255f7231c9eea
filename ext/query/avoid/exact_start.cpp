// What is exact about the first time of an object: position and velocity of an intruder, in dyadic numbers, and
// whether the object separates from what it touches.
#include <algorithm>
#include <limits>

#include "base/axes.h"
#include "contact/minkowski/relative_motion.h"
#include "numbers/dyadic.h"
#include "query/avoid/exact_avoidance.h"
#include "query/avoid/intruder.h"
#include "query/join/question.h"

namespace foresee {
namespace {

/// Whether the distance of the centres never decreases. On straight paths its slope increases, so the first
/// decides.
template <int D>
bool separates_exactly(const Setup& setup, const double* own, const double* other) {
  const auto relative = relative_motion_of<Dyadic, D>(setup, own, other);
  Dyadic slope;
  for (const auto& [x, v, half_a] : relative) slope = slope + x * v;
  return slope.sign() >= 0;
}

bool bends(const Bodies& bodies, const double* row) {
  if (bodies.at.a == Offsets::absent) return false;
  return std::any_of(row + bodies.at.a, row + bodies.at.a + bodies.layout.axes,
                     [](double a) { return a != 0; });
}

template <int D>
bool grows_at_all(const Bodies& bodies, const double* row) {
  return (growth_of<D>(bodies.layout.shape, row, bodies.at) > 0).any();
}

bool are_convex(const PairRule& rule, const Bodies& own, std::size_t leg, const Bodies& others,
                std::size_t row) {
  if (rule.pieces == PieceKind::none) return true;
  ObjectPieces one, other;
  one.take_row(own, own.outlines, leg);
  other.take_row(others, others.outlines, row);
  return one.count() == 1 && other.count() == 1;
}

}  // namespace

ExactAvoidance::InitialState ExactAvoidance::initial_state(const Records& legs, const NearRow& near_row) {
  set_motion(legs);
  const Bodies own = moved_.bodies(), others = near_scene(near_row.table).bodies();
  const double *own_row = own.row(0), *row = others.row(near_row.row);
  const PairRule rule(own.layout, others.layout, question_.within, question_.within_z);
  const bool upright = rule.distance == Distance::upright;
  const bool round = rule.distance != Distance::per_axis && rule.pieces == PieceKind::none &&
                     !rule.has_extent(0) && !rule.grows;
  const auto reach = size_as_of_t<Dyadic>(rule.radius, own_row, row);
  Dyadic gap = -(reach * reach);
  InitialState state;
  const auto split_nearest = [](const Dyadic& exact, double& nearest, double& error) {
    nearest = rounded(exact);
    const Dyadic left = exact - Dyadic(nearest);
    error = left.sign() == 0 ? 0 : std::abs(rounded(left)) * (1 + 0x1p-50);
  };
  with_axes(own.layout.axes, [&]<int D>(Axes<D>) {
    const auto relative = relative_motion_of<Dyadic, D>({own, others, {start_, 0}}, own_row, row);
    for (std::size_t axis = 0; axis < D; ++axis) {
      const auto& [x, v, half_a] = relative[axis];
      split_nearest(x, state.x[axis], state.ex[axis]);
      const AxisMotion<double> mine = axis_motion(own, own_row, static_cast<int>(axis));
      split_nearest(v + Dyadic(mine.v), state.v[axis], state.ev[axis]);
      if (!upright || axis < 2) gap = gap + x * x;
    }
  });
  if (round && gap.sign() > 0) state.square_gap = rounded(gap) * (1 - 0x1p-50);
  return state;
}

bool ExactAvoidance::touches_at_start(std::uint32_t leg, const NearRow& near_row) {
  auto& at_start = start_contacts_[near_row.table];
  if (!at_start) at_start = contact(near_row.table, {start_, 0});
  return touches(*at_start, leg, near_row);
}

bool ExactAvoidance::all_separate(const NearRow& near_row) {
  interrupt_.check();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Bodies own = moved_.bodies(), others = near_scene(near_row.table).bodies();
  const double* const row = others.row(near_row.row);
  const double t = value_or(row, others.at.t, -infinity), until = value_or(row, others.at.until, infinity);
  for (std::uint32_t leg = 0; leg < legs_; ++leg) {
    const double* const own_row = own.row(leg);
    if (value_or(own_row, own.at.until, infinity) < t || value_or(own_row, own.at.t, -infinity) > until)
      continue;  // they never exist together
    const bool is_apart = leg > 0 && !touches_at_start(leg, near_row);
    if (is_apart ? touches(*contacts_[near_row.table], leg, near_row) : !separates(leg, near_row))
      return false;
  }
  return true;
}

bool ExactAvoidance::separates(std::uint32_t leg, const NearRow& near_row) {
  const Bodies own = moved_.bodies(), others = near_scene(near_row.table).bodies();
  const double *own_row = own.row(leg), *row = others.row(near_row.row);
  const PairLifetime lifetime = pair_lifetime_of({own, others, {question_.now, question_.h}}, own_row, row);
  if (lifetime.none || (lifetime.t_start == lifetime.t_end && lifetime.dt_start == lifetime.dt_end))
    return true;
  const Horizon first{start_, 0};
  const PairRule rule(own.layout, others.layout, question_.within, question_.within_z);
  const bool has_outlines = rule.pieces == PieceKind::planar;
  if (has_outlines && !touches_at_start(leg, near_row))
    return !touches(*contacts_[near_row.table], leg, near_row);
  return with_axes(own.layout.axes, [&]<int D>(Axes<D>) {
    const bool grow = grows_at_all<D>(own, own_row) || grows_at_all<D>(others, row);
    if (!grow && !bends(own, own_row) && !bends(others, row) &&
        are_convex(rule, own, leg, others, near_row.row))
      return separates_exactly<D>({own, others, first}, own_row, row);
    OwnMotion motion;
    motion.t = value_or(own_row, own.at.t, 0);
    motion.until = value_or(own_row, own.at.until, std::numeric_limits<double>::infinity());
    for (int axis = 0; axis < D; ++axis) {
      const AxisMotion<double> one = axis_motion(own, own_row, axis);
      const auto j = static_cast<std::size_t>(axis);
      motion.x[j] = one.x;
      motion.v[j] = one.v;
      motion.a[j] = one.a;
    }
    const OwnMotion base = motion_from(motion, std::max(start_, motion.t));
    const auto encounter = encounter_of<D>(base, {question_.now, question_.h}, others, row,
                                           extents_of_both<D>(rule, own_row, row, base.t));
    std::shared_ptr<const OutlinePair> outlines;
    if (has_outlines)
      outlines =
          std::make_shared<OutlinePair>(std::make_shared<OwnOutline>(own, leg, false), others, near_row.row);
    return is_clear_of<D>({encounter, Intruder<D>::AtStart::touches, outlines},
                          trajectory_family<D>(*no_changes_of(base), 0, 0));
  });
}

}  // namespace foresee
