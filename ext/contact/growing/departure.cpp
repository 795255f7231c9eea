#include "contact/growing/departure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/growing/plane.h"
#include "contact/growing/spread_of_changes.h"
#include "contact/growing/straight_approach.h"

namespace foresee::contact {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();

template <int D>
double magnitude_of(const Encounter<D>& met) {
  return met.x.abs().maxCoeff() + met.extents.size();
}

/// How the changes of a range start.
template <int D>
class Start {
 public:
  Start(const Encounter<D>& met, const ChangedWays<D>& ways)
      : met_(met), ways_(ways), velocity_(ways.all.velocity) {
    for (int axis = 0; axis < D; ++axis)
      speed_[axis] = std::max(velocity_.greatest(axis), -velocity_.least(axis));
    speed_ += met.v.abs() + met.ev;
    acceleration_ = ways.most[2].abs().max(ways.least[2].abs()) + met.a.abs();
  }

  /// Of discs and balls, on whose axes the distance may grow as they move past each other, too: its square
  /// exceeds that of the reach by `gap`, and by 2 c0 tau + c1 tau^2 + ..., as long as c1 outweighs the rest.
  void look_round(int axes, double gap) {
    EnclosedNumber c0, c1, c2;
    for (int axis = 0; axis < axes; ++axis) {
      const EnclosedNumber x{met_.x[axis] - met_.ex[axis], met_.x[axis] + met_.ex[axis]},
          v = relative_velocity(axis), a = relative_acceleration(axis);
      c0 += product(x, v), c1 += square(v), c1 += product(x, a), c2 += product(v, a);
    }
    // They touch at once where the sum of the first three falls below 0, and not for coming nearer alone.
    all_approach_ = false;
    all_touch_ = c0.high < 0 && gap * std::max(c1.high, 0.0) <= c0.high * c0.high;
    const bool is_bent = !(acceleration_ == 0).all();
    for (const double share : {0.5, 0x1p-6}) {
      const double rest = is_bent ? (1 - share) * c1.low : c1.low;
      if (!(rest > 0) || !(c0.low >= 0 || c0.low * c0.low < gap * rest * (1 - 0x1p-40))) continue;
      away_until_round_ = !is_bent || c2.low >= 0 ? for_ever : share * c1.low / -c2.low * (1 - 0x1p-40);
      return;
    }
    if (is_bent || c0.low >= 0) return;
    const double until = 0.25 * gap / -c0.low;
    if (c1.low >= 0 || -c1.low * until * until < 0.25 * gap) away_until_round_ = until;
  }

  /// Whose plane has this normal, off by no more than `error` on an axis.
  void look_along(const Vec<D>& n, const Vec<D>& error) {
    if (!(n.abs().maxCoeff() >= least_normal)) return is_unknown();
    const auto& extents = met_.extents;
    double growth = 0;
    if (extents.grows) {
      growth = extents.growth.most(n);
      growth += (error.sum() * extents.growth.size() + 4 * unit_roundoff * growth) * (1 + 0x1p-48);
    }
    const double off = (error * speed_).sum() * (1 + 0x1p-48);
    const double unsure = 0x1p-44 * ((n.abs() * speed_).sum() + growth) + off;
    const double least = least_of<D>(n, met_.v, met_.ev, velocity_) - growth - off;
    const double most = (n * met_.v).sum() + velocity_.most(-n) - growth;
    away_until_ = std::min(away_until_, least < 0 ? -1.0 : bent_until(n, error, least));
    all_approach_ = all_approach_ && most < -unsure;
    ++count_;
  }

  void is_unknown() { away_until_ = -1, all_approach_ = false; }
  Departure departure() const {
    return {count_ > 0 ? std::max(away_until_, away_until_round_) : -1, count_ > 0 && all_approach_,
            all_touch_};
  }

 private:
  EnclosedNumber relative_velocity(int axis) const {
    const double size = 0x1p-50 * speed_[axis];
    return {met_.v[axis] - met_.ev[axis] - velocity_.greatest(axis) - size,
            met_.v[axis] + met_.ev[axis] - velocity_.least(axis) + size};
  }
  EnclosedNumber relative_acceleration(int axis) const {
    const double size = 0x1p-50 * acceleration_[axis];
    return {met_.a[axis] - ways_.most[2][axis] - size, met_.a[axis] - ways_.least[2][axis] + size};
  }

  /// How long they are on their way outward along n: `speed` + tau `acceleration` / 2 is not below 0.
  double bent_until(const Vec<D>& n, const Vec<D>& error, double speed) const {
    if ((acceleration_ == 0).all()) return for_ever;
    const double least = 0.5 * least_of<D>(n, met_.a, Vec<D>(Vec<D>::Zero()), ways_.all.acceleration) -
                         (error * acceleration_).sum();
    return least >= 0 ? for_ever : speed / -least * (1 - 0x1p-48);
  }

  const Encounter<D>& met_;
  const ChangedWays<D>& ways_;
  const VectorSet<D>& velocity_;
  Vec<D> speed_, acceleration_;
  double away_until_ = for_ever, away_until_round_ = -1;
  bool all_approach_ = true, all_touch_ = false;
  int count_ = 0;
};

/// The planes of a sum, of which that around a corner is not known.
template <int D>
void look_along_sum(const Encounter<D>& met, double slack, Start<D>& start) {
  const auto& extents = met.extents;
  Vec<D> n = Vec<D>::Zero(), error = Vec<D>::Zero();
  if (extents.radius > 0x1p20 * slack) {
    // The nearest place of a piece that is off by so little lies in nearly the same direction.
    const double distance = extents.sum->outside(met.x[0], met.x[1], n[0], n[1]);
    if (!(distance > 0.5 * extents.radius)) return start.is_unknown();
    error[0] = error[1] = 4 * std::sqrt(slack / distance);
    start.look_along(n, error);
  } else if (extents.radius > slack) {
    start.is_unknown();
  } else {
    extents.sum->for_each_edge_near(met.x[0], met.x[1], slack, [&](double x, double y, double off) {
      n[0] = x, n[1] = y, error[0] = error[1] = off;
      start.look_along(n, error);
    });
  }
}

/// The normal of a box grown round by a radius: the way from the box.
template <int D>
void look_along_round(const Encounter<D>& met, double slack, Start<D>& start) {
  const auto& extents = met.extents;
  if constexpr (D > 1)
    if (extents.sum) return look_along_sum<D>(met, slack, start);
  Vec<D> n = Vec<D>::Zero(), error = Vec<D>::Zero();
  int beyond = 0;
  for (int axis = 0; axis < extents.round_axes; ++axis) {
    const double over = std::abs(met.x[axis]) - extents.half[axis];
    const double off = met.ex[axis] + 0x1p-49 * extents.half[axis] +
                       (extents.half[axis] > 0 ? 0x1p-49 * std::abs(met.x[axis]) : 0);
    if (over < -off) continue;
    n[axis] = std::copysign(std::max(over, 0.0), met.x[axis]), error[axis] = off;
    beyond += n[axis] != 0 || off > 0;
  }
  if (beyond == 1) n = n.sign(), error.setZero();
  if (beyond == 0 || extents.radius <= slack)
    start.is_unknown();
  else
    start.look_along(n, error);
}

}  // namespace

template <int D>
Departure departure_of(const Encounter<D>& met, const ChangedWays<D>& ways) {
  const auto& extents = met.extents;
  const double slack = touching_share * magnitude_of(met);
  Start<D> start(met, ways);
  Vec<D> ignored = Vec<D>::Zero();
  const Vec<D> over = met.x.abs() - extents.half;
  const bool is_round = extents.sum || (D > 1 && extents.radius > 0);
  if (is_round && depth_in_round<D>(extents, over, met.x, ignored) >= -slack)
    look_along_round<D>(met, slack, start);
  bool may_be_above = false;
  for (int axis = extents.round_axes; axis < D; ++axis) may_be_above = may_be_above || over[axis] >= -slack;
  if (met.square_gap > 0 && !may_be_above) start.look_round(extents.round_axes, met.square_gap);
  for (int axis = is_round ? extents.round_axes : 0; axis < D; ++axis) {
    if (over[axis] - (D == 1 ? extents.radius : 0) < -slack) continue;
    Vec<D> n = Vec<D>::Zero();
    n[axis] = std::copysign(1, met.x[axis]);
    start.look_along(n, Vec<D>::Zero());
  }
  return start.departure();
}

template <int D>
bool is_beside(const Encounter<D>& met) {
  const auto& extents = met.extents;
  if (extents.radius < 0 || (extents.half < 0).any()) return false;  // it may yet become something
  Vec<D> ignored;
  return depth_in<D>(extents, met.x, ignored) <= 0x1p-24 * magnitude_of(met);
}

template Departure departure_of<1>(const Encounter<1>&, const ChangedWays<1>&);
template Departure departure_of<2>(const Encounter<2>&, const ChangedWays<2>&);
template Departure departure_of<3>(const Encounter<3>&, const ChangedWays<3>&);
template bool is_beside<1>(const Encounter<1>&);
template bool is_beside<2>(const Encounter<2>&);
template bool is_beside<3>(const Encounter<3>&);

}  // namespace foresee::contact
