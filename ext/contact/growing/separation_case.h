// One question about a range of changes: an encounter, the changed motions, and the moments of both, looked
// at for proofs and for whom all of them touch.
#pragma once

#include <array>

#include "contact/growing/changed_ways.h"
#include "contact/growing/straight_approach.h"
#include "numbers/double_double.h"

namespace foresee {

// Does a plane stand between an object and all the changed motions of another, throughout some moments? The
// proof that avoidance rests on (separation.h), with every rounding counted.

/// Nothing is lost to underflow that is larger.
inline constexpr double least_gap = 0x1p-960;
/// The squares of shorter normals would vanish.
inline constexpr double least_normal = 0x1p-400;

/// c0 + c1 tau + c2 tau^2 > 0 throughout [begin, end]; false where doubles do not tell.
inline bool surely_positive(double c0, double c1, double c2, double begin, double end) {
  const auto above = [&](double tau) {
    const double size = std::abs(c0) + tau * (std::abs(c1) + tau * std::abs(c2));
    return c0 + tau * (c1 + tau * c2) > 8 * unit_roundoff * size + least_gap;
  };
  if (!above(begin) || !above(end)) return false;
  if (!(c2 > 0) || !(c1 < 0) || -c1 <= 2 * c2 * begin || -c1 >= 2 * c2 * end) return true;
  const double dip = c1 * (c1 / (4 * c2));
  return c0 - dip > 8 * unit_roundoff * (std::abs(c0) + dip) + least_gap;
}

/// n (other) - most of n (own), from below.
template <int D>
double least_of(const Vec<D>& n, const Vec<D>& other, const Vec<D>& error, const VectorSet<D>& own) {
  const double along = (n * other).sum(), most = own.most(n);
  return along - most -
         ((n.abs() * (error + 8 * unit_roundoff * other.abs())).sum() + 4 * unit_roundoff * std::abs(most));
}

template <int D>
bool plane_proves(const Encounter<D>& met, const MotionSet<D>& all, const Vec<D>& n, double begin,
                  double end) {
  if (!(n.abs().maxCoeff() >= least_normal)) return false;
  double play = 0;  // in x and y
  if constexpr (D > 1)
    if (met.play > 0) play = met.play * (std::abs(n[0]) + std::abs(n[1])) * (1 + 0x1p-50);
  const double reach = met.extents.most(n) + play,
               growth = met.extents.grows ? met.extents.growth.most(n) : 0;
  const double c0 = least_of<D>(n, met.x, met.ex, all.place) - reach;
  const double v = least_of<D>(n, met.v, met.ev, all.velocity);
  const double c1 = growth == 0 ? v : v - growth - 4 * unit_roundoff * (std::abs(v) + growth);
  const double c2 = 0.5 * least_of<D>(n, met.a, Vec<D>(Vec<D>::Zero()), all.acceleration);
  return surely_positive(c0 - 4 * unit_roundoff * (std::abs(c0) + std::abs(reach)), c1, c2, begin, end);
}

/// What a guess has come to.
enum class Look : std::uint8_t { proven, touches, open };

/// One question: an encounter, a range of changes, and the moments of both.
template <int D>
class SeparationCase {
 public:
  SeparationCase(const Encounter<D>& met, const ChangedWays<D>& ways)
      : met_(met),
        ways_(ways),
        begin_(std::max(met.begin, ways.all.begin)),
        end_(std::min(met.end, ways.all.end)),
        bends_(ways.bends || met.bends()) {}

  bool never_together() const { return begin_ > end_; }
  /// Doubles hold all that is to be computed.
  bool is_finite() const {
    const Vec<D> far = met_.x.abs() + end_ * (met_.v.abs() + end_ * met_.a.abs());
    return std::isfinite(far.sum()) && std::isfinite(scale_at(end_)) && std::isfinite(width_at(end_));
  }
  bool bends() const { return bends_; }
  /// Of the time of bent paths, that were looked at so far.
  std::uint64_t parts() const { return parts_; }
  double begin() const { return begin_; }
  double end() const { return end_; }

  /// Is there a plane, guessed from one of the motions? `tau`: where that touches, or is near.
  Look look(const RoughWay<D>& own, double& tau) const {
    const RoughWay<D> way = relative(met_, own);
    return bends_ ? look_at_bent(way, tau) : look_at_straight(way, tau);
  }

  bool touches(const RoughWay<D>& own) const {
    const RoughWay<D> way = relative(met_, own);
    if (!(way.begin <= way.end)) return false;
    const auto near = straight_approach<D>(met_.extents, way.x, way.v, way.begin, way.end);
    return near.gap <= touching_share * scale_at(near.tau);
  }

  /// Do all motions of the range touch at tau, or at the moment nearest to it at which all are there? On one
  /// axis also if all pass the other. Roughly.
  bool all_touch_about(double tau) const {
    const double first = std::max(begin_, ways_.last.begin), last = std::min(end_, ways_.first.end);
    if (first > last) return false;
    tau = std::clamp(tau, first, last);
    if constexpr (D == 1)
      if (all_pass(first, last, tau)) return true;
    return all_touch_at(tau);
  }

  /// The same, where all places of the range at one moment lie on a segment, or on an arc near one: what is
  /// convex holds all of a segment whose ends it holds.
  bool ends_touch_about(double tau) const {
    const double first = std::max(begin_, ways_.last.begin), last = std::min(end_, ways_.first.end);
    if (first > last) return false;
    tau = std::clamp(tau, first, last);
    const double slack = touching_share * scale_at(tau), beside = ways_.turned[0] - slack;
    const double turned = tau * (ways_.turned[1] + 0.5 * tau * ways_.turned[2]) + met_.play;
    for (const RoughWay<D>* end : {&ways_.first, &ways_.last})
      if (!touches_at(place_at<D>(relative(met_, *end), tau), tau, beside + turned, beside)) return false;
    return true;
  }

  /// When one of the motions is nearest, on a path that is not bent.
  double nearest_moment(const RoughWay<D>& own) const {
    const RoughWay<D> way = relative(met_, own);
    if (!(way.begin <= way.end)) return begin_;
    return straight_approach<D>(met_.extents, way.x, way.v, way.begin, way.end).tau;
  }

 private:
  /// Whether a place is so deep within, on the axes that are round together, and on the others.
  bool touches_at(const Vec<D>& place, double tau, double round, double upright) const {
    const PairExtents<D> extents = met_.extents.after(tau);
    const Vec<D> over = place.abs() - extents.half;
    for (int axis = extents.round_axes; axis < D; ++axis)
      if (!(over[axis] <= -upright)) return false;
    Vec<D> ignored;
    return depth_in_round<D>(extents, over, place, ignored) <= -round;
  }

  /// All are on one side at one moment and on the other at another.
  bool all_pass(double first, double last, double tau) const {
    bool below = false, above = false;
    const auto look_at = [&](double at) {
      const int side = side_at(std::clamp(at, first, last));
      below = below || side < 0, above = above || side > 0;
    };
    for (const double at : {first, tau, last}) look_at(at);
    for (const RoughWay<D>* own : {&ways_.first, &ways_.middle, &ways_.last}) {
      const RoughWay<D> way = relative(met_, *own);
      if (way.a[0] != 0) look_at(-way.v[0] / way.a[0]);  // where it turns round
    }
    return below && above;
  }

  /// On which side of the other all are: 1 or -1; 0: not on one.
  int side_at(double tau) const {
    const double most = place_of(ways_.least, 0, tau), least = place_of(ways_.most, 0, tau);
    return least >= 0 ? 1 : most <= 0 ? -1 : 0;
  }

  bool all_touch_at(double tau) const {
    const double slack = touching_share * scale_at(tau);
    const PairExtents<D> extents = met_.extents.after(tau);
    double square = 0;
    int first = 0;
    if constexpr (D > 1)
      if (extents.sum) {
        const double beside = beside_middle(tau);
        Vec<D> middle = Vec<D>::Zero(), ignored;
        for (int axis = 0; axis < 2; ++axis)
          middle[axis] = 0.5 * (place_of(ways_.most, axis, tau) + place_of(ways_.least, axis, tau));
        if (!(depth_in_round<D>(extents, middle, middle, ignored) + beside + met_.play <= slack))
          return false;
        first = 2;
      }
    for (int axis = first; axis < D; ++axis) {
      const double far = farthest(axis, tau) - extents.half[axis];
      if (axis >= extents.round_axes) {
        if (!(far <= slack)) return false;
      } else if (far > 0) {
        square += far * far;
      }
    }
    return first > 0 || std::sqrt(square) <= extents.radius + slack;
  }

  /// How far from the middle of the box around all of them, in x and y, anything of the range is at tau.
  double beside_middle(double tau) const {
    double square = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const double half = 0.5 * (place_of(ways_.most, axis, tau) - place_of(ways_.least, axis, tau));
      square += half * half;
    }
    return std::sqrt(square);
  }

  /// The other on one axis, seen from an end of the range's places, velocities and accelerations.
  double place_of(const Vec<D> (&end)[3], int axis, double tau) const {
    const auto at = [&](double x, double v, double a) { return x + tau * (v + 0.5 * tau * a); };
    return at(met_.x[axis], met_.v[axis], met_.a[axis]) - at(end[0][axis], end[1][axis], end[2][axis]);
  }
  /// How far from the origin on one axis anything of the range is at tau.
  double farthest(int axis, double tau) const {
    return std::max(std::abs(place_of(ways_.most, axis, tau)), std::abs(place_of(ways_.least, axis, tau)));
  }

  double scale_at(double tau) const {
    const Vec<D> v = ways_.most[1].abs().max(ways_.least[1].abs()) + met_.v.abs();
    const PairExtents<D> extents = met_.extents.after(tau);
    const double sum = extents.sum ? extents.sum->size() : 0;
    return (met_.x.abs() + extents.half.abs() + tau * v).maxCoeff() + std::abs(extents.radius) + sum;
  }

  Look look_at_straight(const RoughWay<D>& way, double& tau) const {
    const auto near = straight_approach<D>(met_.extents, way.x, way.v, begin_, end_);
    tau = near.tau;
    if (!(near.gap > 0)) return Look::touches;
    return plane_proves<D>(met_, ways_.all, near.normal, begin_, end_) ? Look::proven : Look::open;
  }

  /// Part by part of the time, each taken for straight.
  Look look_at_bent(const RoughWay<D>& way, double& tau) const {
    struct Part {
      double begin, end;
    };
    std::array<Part, 64> parts;
    std::size_t count = 0;
    parts[count++] = {begin_, end_};
    for (int looks = 0; count > 0; ++looks, ++parts_) {
      const Part part = parts[--count];
      const double middle = 0.5 * (part.begin + part.end), length = part.end - part.begin;
      const Vec<D> v = way.v + middle * way.a, x = place_at<D>(way, middle) - middle * v;
      const auto near = straight_approach<D>(met_.extents, x, v, part.begin, part.end);
      tau = near.tau;
      if (near.gap > 0 && plane_proves<D>(met_, ways_.all, near.normal, part.begin, part.end)) continue;
      Vec<D> ignored;
      if (!(depth_in<D>(met_.extents.after(tau), place_at<D>(way, tau), ignored) > 0)) {
        parts_ += moments_looked_at;
        tau = deepest_moment(way, tau);
        return Look::touches;
      }
      const double bend = 0.125 * length * length * way.a.abs().sum();
      if (looks > 200 || !(bend > 0.5 * width_at(part.end))) return Look::open;
      parts[count++] = {middle, part.end};
      parts[count++] = {part.begin, middle};
      if (count + 2 > parts.size()) return Look::open;
    }
    return Look::proven;
  }

  /// Where a bent path is deepest within, or about there: the best of some moments and `tau`, then between
  /// its neighbours.
  double deepest_moment(const RoughWay<D>& way, double tau) const {
    Vec<D> ignored;
    const auto depth = [&](double at) {
      return depth_in<D>(met_.extents.after(at), place_at<D>(way, at), ignored);
    };
    double best = tau, least = depth(tau), step = (end_ - begin_) / moments_looked_at;
    const auto look_at = [&](double at) {
      const double here = depth(at);
      if (here < least) best = at, least = here;
    };
    for (int i = 0; i <= moments_looked_at; ++i) look_at(std::min(begin_ + i * step, end_));
    for (int look = 0; look < 12; ++look) {
      step *= 0.5;
      const double middle = best;
      look_at(std::max(begin_, middle - step)), look_at(std::min(end_, middle + step));
    }
    return best;
  }

  /// How far apart two of the range can be at tau.
  double width_at(double tau) const {
    return ((ways_.most[0] - ways_.least[0]) +
            tau * ((ways_.most[1] - ways_.least[1]) + 0.5 * tau * (ways_.most[2] - ways_.least[2])))
        .sum();
  }

  const Encounter<D>& met_;
  const ChangedWays<D>& ways_;
  double begin_, end_;
  bool bends_;
  mutable std::uint64_t parts_ = 0;
};

}  // namespace foresee
