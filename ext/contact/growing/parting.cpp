#include "contact/growing/parting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/growing/separation_case.h"

namespace foresee {
namespace {

/// A ball, or upright a disc: no box is within. Of pieces too the distance is asked on all their axes.
template <int D>
bool rounds_alone(const PairExtents<D>& extents) {
  if (extents.sum) return true;
  for (int axis = 0; axis < extents.round_axes; ++axis)
    if (extents.half[axis] != 0) return false;
  return true;
}

/// Does the distance of the centres never shrink, on paths that are not bent? Its slope grows with time, so
/// that at the first moment decides.
template <int D>
Judgement judge_straight_parting(const Encounter<D>& met, const ChangedWays<D>& ways) {
  const auto& own = ways.all.velocity;
  const double along = (met.x * met.v).sum(), most = own.most(met.x);
  const Vec<D> v = ways.most[1].abs().max(ways.least[1].abs()) + met.v.abs();
  // What is 0 has no error: side by side at the same speed, nothing shrinks.
  double error = 0;
  for (int axis = 0; axis < D; ++axis)
    error += met.ex[axis] * (v[axis] + met.ev[axis]) + std::abs(met.x[axis]) * met.ev[axis] +
             8 * unit_roundoff * std::abs(met.x[axis]) * v[axis];
  error *= 1 + 0x1p-48;
  const double least = along - most;
  if (least - error >= 0) return Judgement::clear;
  const double greatest = along + own.most(-met.x), slack = touching_share * (met.x.abs() * v).sum();
  return greatest <= slack ? Judgement::blocked : Judgement::open;
}

/// Does a part of the gap never shrink, of a set that grows by `rate`? `x`: where the other is, as seen along
/// some axes.
template <int D>
Judgement judge_gap(const Encounter<D>& met, const ChangedWays<D>& ways, const Vec<D>& x, double rate) {
  const auto& own = ways.all.velocity;
  const double opening = std::sqrt((x * x).sum()) * rate, along = (x * met.v).sum() - opening;
  const Vec<D> v = ways.most[1].abs().max(ways.least[1].abs()) + met.v.abs() + met.ev;
  const double error = ((met.ex * (v + rate) + x.abs() * met.ev).sum() +
                        16 * unit_roundoff * ((x.abs() * v).sum() + opening)) *
                       (1 + 0x1p-48);
  if (along - own.most(x) - error >= 0) return Judgement::clear;
  const double slack = touching_share * ((x.abs() * v).sum() + opening);
  return along + own.most(-x) <= slack ? Judgement::blocked : Judgement::open;
}

/// The same of all of it, on paths that are not bent. A disc or ball is left for good if the distance of the
/// centres grows at least as fast as it does; of other sets each axis is asked, as of an interval that grows
/// like all of them: that is enough. What is smaller at first is not met later either.
template <int D>
Judgement judge_parting_of_growing(const Encounter<D>& met, const ChangedWays<D>& ways) {
  const PairExtents<D>& growth = met.extents.growth;
  const int together = rounds_alone(met.extents) ? met.extents.round_axes : 0;
  std::array<Judgement, D + 1> parts;
  std::size_t count = 0;
  if (together > 0) {
    Vec<D> round = Vec<D>::Zero();
    for (int axis = 0; axis < together; ++axis) round[axis] = met.x[axis];
    parts[count++] = judge_gap<D>(met, ways, round, growth.radius);
  }
  for (int axis = together; axis < D; ++axis) {
    Vec<D> one = Vec<D>::Zero();
    one[axis] = met.x[axis];
    const double rate = growth.half[axis] + (axis < met.extents.round_axes ? growth.radius : 0);
    parts[count++] = judge_gap<D>(met, ways, one, rate);
  }
  const auto any = [&](Judgement what) {
    return std::find(parts.begin(), parts.begin() + count, what) != parts.begin() + count;
  };
  return any(Judgement::blocked) ? Judgement::blocked
         : any(Judgement::open)  ? Judgement::open
                                 : Judgement::clear;
}

/// The least value of x y, each within its ends; nothing is known of it where doubles do not hold a product.
double least_product(double x0, double x1, double y0, double y1) {
  if (!std::isfinite(x0 * y0 + x0 * y1 + x1 * y0 + x1 * y1)) return -std::numeric_limits<double>::infinity();
  const double least = std::min({x0 * y0, x0 * y1, x1 * y0, x1 * y1});
  return least - 4 * unit_roundoff * std::abs(least);
}

/// Place times velocity on one axis, at least, during [begin, end].
template <int D>
double least_turn(const Encounter<D>& met, const ChangedWays<D>& ways, int axis, double begin, double end) {
  const double ev = met.ev[axis];
  const double v0 = met.v[axis] - ev - ways.most[1][axis], v1 = met.v[axis] + ev - ways.least[1][axis];
  const double a0 = met.a[axis] - ways.most[2][axis], a1 = met.a[axis] - ways.least[2][axis];
  const double slow = v0 + std::min(begin * a0, end * a0), fast = v1 + std::max(begin * a1, end * a1);
  const double low = met.x[axis] + begin * (v0 + 0.5 * begin * a0) + std::min(0.0, (end - begin) * slow);
  const double high = met.x[axis] + begin * (v1 + 0.5 * begin * a1) + std::max(0.0, (end - begin) * fast);
  const double speed = std::abs(v0) + std::abs(v1) + end * (std::abs(a0) + std::abs(a1));
  const double pad = met.ex[axis] + 16 * unit_roundoff * (std::abs(met.x[axis]) + end * speed),
               speed_pad = 16 * unit_roundoff * speed;
  return least_product(low - pad, high + pad, slow - speed_pad, fast + speed_pad);
}

/// The same where paths bend: place times velocity, as intervals, over ever shorter times. A ball is left for
/// good where the sum does not shrink; a box or cylinder, if no part of it does.
template <int D>
bool never_shrinks(const Encounter<D>& met, const ChangedWays<D>& ways, double begin, double end, int cuts) {
  const bool rounds = rounds_alone(met.extents);
  double round = 0, least = 0;
  for (int axis = 0; axis < D; ++axis) {
    const double turn = least_turn<D>(met, ways, axis, begin, end);
    if (rounds && axis < met.extents.round_axes)
      round += turn;
    else
      least = std::min(least, turn);
  }
  if (least >= 0 && round >= 0) return true;
  if (cuts == 0) return false;
  const double middle = 0.5 * (begin + end);
  return never_shrinks<D>(met, ways, begin, middle, cuts - 1) &&
         never_shrinks<D>(met, ways, middle, end, cuts - 1);
}

/// What never_shrinks() asks for fails at some moment, or may as well. Roughly.
template <int D>
bool shrinks(const Encounter<D>& met, const RoughWay<D>& own, double end) {
  const RoughWay<D> way = relative<D>(met, own);
  const double step = end / moments_looked_at;
  for (int i = 0; i <= moments_looked_at; ++i) {
    const double tau = i * step;
    const Vec<D> turn = place_at<D>(way, tau) * (way.v + tau * way.a);
    const double slack = touching_share * turn.abs().sum();
    const int round_axes = rounds_alone(met.extents) ? met.extents.round_axes : 0;
    double round = 0;
    for (int axis = 0; axis < round_axes; ++axis) round += turn[axis];
    if (round_axes > 0 && round <= slack) return true;
    for (int axis = round_axes; axis < D; ++axis)
      if (turn[axis] < -slack || (turn[axis] <= slack && way.a[axis] != 0)) return true;
  }
  return false;
}

}  // namespace

template <int D>
Judgement judge_parting(const Encounter<D>& met, const ChangedWays<D>& ways) {
  const SeparationCase<D> question(met, ways);
  if (question.never_together() || question.end() <= 0) return Judgement::clear;
  if (!question.is_finite()) return Judgement::blocked;
  // What grows may catch up with what turns away ever more slowly, and pieces lie on no side of the middle.
  if (question.bends() && (met.extents.grows || met.extents.sum)) return Judgement::blocked;
  if (met.extents.grows) return judge_parting_of_growing<D>(met, ways);
  if (!question.bends()) return judge_straight_parting<D>(met, ways);
  if (never_shrinks<D>(met, ways, 0, question.end(), 6)) return Judgement::clear;
  const bool all_shrink = shrinks(met, ways.first, question.end()) &&
                          shrinks(met, ways.middle, question.end()) &&
                          shrinks(met, ways.last, question.end());
  return all_shrink ? Judgement::blocked : Judgement::open;
}

namespace {

/// What turns by less is not looked at more closely where all of it seems to touch.
constexpr double least_chord = 0x1p-17;

/// Who moves which way at a line that may part a place from a piece.
enum class Way : std::uint8_t { out, in, either };

/// Of all that may part them: who is outside at first is beyond one of these lines, and stays so if it moves
/// out. Requires: near the boundary; paths that are not bent.
template <int D>
Way way_at_boundary(const Encounter<D>& met, const ChangedWays<D>& ways, double slack) {
  const auto& extents = met.extents;
  const double speed = (ways.most[1].abs().max(ways.least[1].abs()) + met.v.abs() + met.ev).sum();
  Way way = Way::out;
  const auto look_along = [&](const Vec<D>& n, double error, double growth) {
    const double unsure = (error + 0x1p-44) * (speed + growth);
    if (least_of<D>(n, met.v, met.ev, ways.all.velocity) > growth + unsure || way == Way::in) return;
    const bool in = (n * met.v).sum() + ways.all.velocity.most(-n) < growth - unsure;
    way = in ? Way::in : Way::either;
  };
  Vec<D> n = Vec<D>::Zero();
  for (int axis = 2; axis < D; ++axis) {
    n[axis] = std::copysign(1, met.x[axis]);
    if (extents.half[axis] - std::abs(met.x[axis]) <= slack) look_along(n, 0, extents.growth.half[axis]);
    n[axis] = 0;
  }
  const double rate = extents.growth.radius, around = extents.radius;
  if (depth_in_round<D>(extents, met.x.abs(), met.x, n) < -met.play - slack) return way;
  n.setZero();
  if (around > 0x1p20 * (met.play + slack)) {
    // The nearest place of a piece that is off by so little lies in nearly the same direction.
    const double distance = extents.sum->outside(met.x[0], met.x[1], n[0], n[1]);
    if (!(distance > 0.5 * around)) return Way::either;
    look_along(n, 4 * std::sqrt((met.play + slack) / distance), rate);
  } else if (around > slack) {
    return Way::either;
  } else {
    const double near = 2 * met.chord * (met.x.abs().sum() + extents.size()) + met.play + slack;
    extents.sum->for_each_edge_near(met.x[0], met.x[1], near, [&](double x, double y, double error) {
      n[0] = x, n[1] = y;
      look_along(n, error + 2 * met.chord, rate);
    });
  }
  return way;
}

}  // namespace

template <int D>
Judgement judge_parting_of_piece(const Encounter<D>& met, const ChangedWays<D>& ways, std::uint64_t& looks) {
  const auto judged = [&] { return judge<D>(met, ways, looks); };
  if (met.begin > 0) return judged();
  Vec<D> ignored;
  const double slack = touching_share * (met.x.abs().maxCoeff() + met.extents.size());
  const double outside = depth_in<D>(met.extents, met.x, ignored);
  if (outside <= -met.play - slack) return judge_parting<D>(met, ways);
  if (outside > met.play + slack) return judged();
  const Judgement parting = judge_parting<D>(met, ways);
  if (D == 1 || (parting == Judgement::blocked && met.chord < least_chord)) return Judgement::blocked;
  const Way way = way_at_boundary<D>(met, ways, slack);
  if (way == Way::in) return met.chord < least_chord ? Judgement::blocked : Judgement::open;
  return way == Way::out && parting == Judgement::clear ? parting : Judgement::open;
}

template Judgement judge_parting<1>(const Encounter<1>&, const ChangedWays<1>&);
template Judgement judge_parting<2>(const Encounter<2>&, const ChangedWays<2>&);
template Judgement judge_parting<3>(const Encounter<3>&, const ChangedWays<3>&);
template Judgement judge_parting_of_piece<1>(const Encounter<1>&, const ChangedWays<1>&, std::uint64_t&);
template Judgement judge_parting_of_piece<2>(const Encounter<2>&, const ChangedWays<2>&, std::uint64_t&);
template Judgement judge_parting_of_piece<3>(const Encounter<3>&, const ChangedWays<3>&, std::uint64_t&);

}  // namespace foresee
