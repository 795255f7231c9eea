#include "contact/clearance/departure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/clearance/separating_plane.h"
#include "contact/clearance/spread_of_changes.h"
#include "contact/clearance/straight_approach.h"

namespace foresee {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

template <int D>
double magnitude_of(const Encounter<D>& encounter) {
  return encounter.x.abs().largest() + encounter.extents.size();
}

/// The first instants of all changes of a range, along the normals of possible separating planes.
template <int D>
class Start {
 public:
  Start(const Encounter<D>& encounter, const TrajectoryFamily<D>& family)
      : encounter_(encounter), family_(family), velocity_(family.all.velocity) {
    for (int axis = 0; axis < D; ++axis) speed_[axis] = std::max(velocity_.max(axis), -velocity_.min(axis));
    speed_ += encounter.v.abs() + encounter.ev;
    acceleration_ = family.upper[2].abs().max(family.lower[2].abs()) + encounter.a.abs();
  }

  /// Discs and balls, whose distance on these axes may also increase as they pass each other. Its square
  /// exceeds that of the reach by `gap`, and later by gap + 2 c0 tau + c1 tau^2 + …, as long as c1 outweighs
  /// the rest.
  void probe_round(int axes, double gap) {
    EnclosedNumber c0, c1, c2;
    for (int axis = 0; axis < axes; ++axis) {
      const EnclosedNumber x{encounter_.x[axis] - encounter_.ex[axis],
                             encounter_.x[axis] + encounter_.ex[axis]},
          v = relative_velocity(axis), a = relative_acceleration(axis);
      c0 += product(x, v);
      c1 += square(v);
      c1 += product(x, a);
      c2 += product(v, a);
    }
    // They touch at once if the sum of the first three terms falls below 0; an approach alone is not enough.
    all_approach_ = false;
    all_touch_ = c0.high < 0 && gap * std::max(c1.high, 0.0) <= c0.high * c0.high;
    const bool is_bent = !(acceleration_ == 0).all();
    for (const double share : {0.5, 0x1p-6}) {
      const double rest = is_bent ? (1 - share) * c1.low : c1.low;
      if (!(rest > 0) || !(c0.low >= 0 || c0.low * c0.low < gap * rest * (1 - 0x1p-40))) continue;
      away_until_round_ = !is_bent || c2.low >= 0 ? unbounded : share * c1.low / -c2.low * (1 - 0x1p-40);
      return;
    }
    if (is_bent || c0.low >= 0) return;
    const double until = 0.25 * gap / -c0.low;
    if (c1.low >= 0 || -c1.low * until * until < 0.25 * gap) away_until_round_ = until;
  }

  /// Tests the plane of this normal, which is within `error` on each axis.
  void probe_along(const Vec<D>& n, const Vec<D>& error) {
    if (!(n.abs().largest() >= min_normal)) return set_unknown();
    const auto& extents = encounter_.extents;
    double growth = 0;
    if (extents.grows) {
      growth = extents.growth.support(n);
      growth += (error.sum() * extents.growth.size() + 4 * unit_roundoff * growth) * (1 + 0x1p-48);
    }
    const double off = (error * speed_).sum() * (1 + 0x1p-48);
    const double unsure = 0x1p-44 * ((n.abs() * speed_).sum() + growth) + off;
    const double min_speed = min_of<D>(n, encounter_.v, encounter_.ev, velocity_) - growth - off;
    const double max_speed = (n * encounter_.v).sum() + velocity_.support(-n) - growth;
    away_until_ = std::min(away_until_, min_speed < 0 ? -1.0 : bent_until(n, error, min_speed));
    all_approach_ = all_approach_ && max_speed < -unsure;
    ++count_;
  }

  void set_unknown() {
    away_until_ = -1;
    all_approach_ = false;
  }
  Departure departure() const {
    return {count_ > 0 ? std::max(away_until_, away_until_round_) : -1, count_ > 0 && all_approach_,
            all_touch_};
  }

 private:
  EnclosedNumber relative_velocity(int axis) const {
    const double size = 0x1p-50 * speed_[axis];
    return {encounter_.v[axis] - encounter_.ev[axis] - velocity_.max(axis) - size,
            encounter_.v[axis] + encounter_.ev[axis] - velocity_.min(axis) + size};
  }
  EnclosedNumber relative_acceleration(int axis) const {
    const double size = 0x1p-50 * acceleration_[axis];
    return {encounter_.a[axis] - family_.upper[2][axis] - size,
            encounter_.a[axis] - family_.lower[2][axis] + size};
  }

  /// Until when the two move apart along n: `speed` + tau `acceleration` / 2 is not below 0.
  double bent_until(const Vec<D>& n, const Vec<D>& error, double speed) const {
    if ((acceleration_ == 0).all()) return unbounded;
    const double min_acceleration =
        0.5 * min_of<D>(n, encounter_.a, Vec<D>::zero(), family_.all.acceleration) -
        (error * acceleration_).sum();
    return min_acceleration >= 0 ? unbounded : speed / -min_acceleration * (1 - 0x1p-48);
  }

  const Encounter<D>& encounter_;
  const TrajectoryFamily<D>& family_;
  const VectorSet<D>& velocity_;
  Vec<D> speed_, acceleration_;
  double away_until_ = unbounded, away_until_round_ = -1;
  bool all_approach_ = true, all_touch_ = false;
  int count_ = 0;
};

/// The planes of a sum of pieces. At a corner the normal is not known.
template <int D>
void probe_sum(const Encounter<D>& encounter, double slack, Start<D>& start) {
  const auto& extents = encounter.extents;
  Vec<D> n = Vec<D>::zero(), error = Vec<D>::zero();
  if (extents.radius > 0x1p20 * slack) {
    // With so small an error the nearest point of a piece has nearly the same direction.
    const double distance = extents.sum->signed_distance(encounter.x[0], encounter.x[1], n[0], n[1]);
    if (!(distance > 0.5 * extents.radius)) return start.set_unknown();
    error[0] = error[1] = 4 * std::sqrt(slack / distance);
    start.probe_along(n, error);
  } else if (extents.radius > slack) {
    start.set_unknown();
  } else {
    extents.sum->for_each_edge_near(encounter.x[0], encounter.x[1], slack,
                                    [&](double x, double y, double off) {
                                      n[0] = x, n[1] = y, error[0] = error[1] = off;
                                      start.probe_along(n, error);
                                    });
  }
}

/// The normal of a box grown by a radius: the direction away from the box.
template <int D>
void probe_round_set(const Encounter<D>& encounter, double slack, Start<D>& start) {
  const auto& extents = encounter.extents;
  if constexpr (D > 1)
    if (extents.sum) return probe_sum<D>(encounter, slack, start);
  Vec<D> n = Vec<D>::zero(), error = Vec<D>::zero();
  int beyond = 0;
  for (int axis = 0; axis < extents.round_axes; ++axis) {
    const double over = std::abs(encounter.x[axis]) - extents.half[axis];
    const double off = encounter.ex[axis] + 0x1p-49 * extents.half[axis] +
                       (extents.half[axis] > 0 ? 0x1p-49 * std::abs(encounter.x[axis]) : 0);
    if (over < -off) continue;
    n[axis] = std::copysign(std::max(over, 0.0), encounter.x[axis]);
    error[axis] = off;
    beyond += n[axis] != 0 || off > 0;
  }
  if (beyond == 1) {
    n = n.sign();
    error = Vec<D>::zero();
  }
  if (beyond == 0 || extents.radius <= slack)
    start.set_unknown();
  else
    start.probe_along(n, error);
}

}  // namespace

template <int D>
Departure departure_of(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  const auto& extents = encounter.extents;
  const double slack = touching_share * magnitude_of(encounter);
  Start<D> start(encounter, family);
  Vec<D> ignored = Vec<D>::zero();
  const Vec<D> over = encounter.x.abs() - extents.half;
  const bool is_round = extents.sum || (D > 1 && extents.radius > 0);
  if (is_round && signed_distance_in_round_axes<D>(extents, over, encounter.x, ignored) >= -slack)
    probe_round_set<D>(encounter, slack, start);
  bool may_be_above = false;
  for (int axis = extents.round_axes; axis < D; ++axis) may_be_above = may_be_above || over[axis] >= -slack;
  if (encounter.square_gap > 0 && !may_be_above) start.probe_round(extents.round_axes, encounter.square_gap);
  for (int axis = is_round ? extents.round_axes : 0; axis < D; ++axis) {
    if (over[axis] - (D == 1 ? extents.radius : 0) < -slack) continue;
    Vec<D> n = Vec<D>::zero();
    n[axis] = std::copysign(1, encounter.x[axis]);
    start.probe_along(n, Vec<D>::zero());
  }
  return start.departure();
}

template <int D>
bool starts_nearly_touching(const Encounter<D>& encounter) {
  const auto& extents = encounter.extents;
  if (extents.radius < 0 || (extents.half < 0).any()) return false;  // the extents may grow later
  Vec<D> ignored;
  return signed_distance<D>(extents, encounter.x, ignored) <= 0x1p-24 * magnitude_of(encounter);
}

template Departure departure_of<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template Departure departure_of<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template Departure departure_of<3>(const Encounter<3>&, const TrajectoryFamily<3>&);
template bool starts_nearly_touching<1>(const Encounter<1>&);
template bool starts_nearly_touching<2>(const Encounter<2>&);
template bool starts_nearly_touching<3>(const Encounter<3>&);

}  // namespace foresee
