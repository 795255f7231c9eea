// Proof that a plane separates an object from all changed motions of another during an interval of time.
//
// It is the proof of every clear range (separation.h); all rounding errors are included.
#pragma once

#include "contact/clearance/trajectory_family.h"
#include "numbers/double_double.h"

namespace foresee {

/// A larger gap is not lost to underflow.
inline constexpr double min_gap = 0x1p-960;
/// The squares of shorter normals would underflow.
inline constexpr double min_normal = 0x1p-400;

/// c0 + c1 tau + c2 tau^2 > 0 throughout [begin, end]; false if doubles cannot decide it.
inline bool surely_positive(double c0, double c1, double c2, double begin, double end) {
  const auto above = [&](double tau) {
    const double size = std::abs(c0) + tau * (std::abs(c1) + tau * std::abs(c2));
    return c0 + tau * (c1 + tau * c2) > 8 * unit_roundoff * size + min_gap;
  };
  if (!above(begin) || !above(end)) return false;
  if (!(c2 > 0) || !(c1 < 0) || -c1 <= 2 * c2 * begin || -c1 >= 2 * c2 * end) return true;
  const double dip = c1 * (c1 / (4 * c2));
  return c0 - dip > 8 * unit_roundoff * (std::abs(c0) + dip) + min_gap;
}

/// Lower bound of n (other) - n (own) over all of `own`.
template <int D>
double min_of(const Vec<D>& n, const Vec<D>& other, const Vec<D>& error, const VectorSet<D>& own) {
  const double along = (n * other).sum(), support = own.support(n);
  return along - support -
         ((n.abs() * (error + 8 * unit_roundoff * other.abs())).sum() +
          4 * unit_roundoff * std::abs(support));
}

/// How much farther than at both ends of the range corners reach in between, as from + rate tau + bend tau^2.
struct ExtraReach {
  double from, rate, bend;
};

/// An own corner c of a range of turns is in R(k) w, w = v tau + a tau^2 / 2 + c: on an arc of radius |w|. Along n that
/// is at most the farther end, and the height of the arc. Without a it is at most the farther end alone once
/// v tau outweighs c, so that R(k) w turns away from n throughout, or towards n.
template <int D>
ExtraReach extra_reach_of_arc(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                              const Vec<D>& n, double begin, double end) {
  const double chord = encounter.rotation_chord, size = std::abs(n[0]) + std::abs(n[D > 1]);
  const double height = 0.5 * chord * chord * size * (1 + 0x1p-48);
  const VectorSet<D>&velocity = family.all.velocity, &acceleration = family.all.acceleration;
  const double reach = encounter.turning->own_reach();
  ExtraReach all{height * reach, height * velocity.radius, 0.5 * height * acceleration.radius};
  if (acceleration.is_arc) return all;
  const auto across = [&](const Vec<D>& v) { return n[0] * v[D > 1] - n[D > 1] * v[0]; };
  const double first = across(family.first.v), last = across(family.last.v);
  if ((first > 0) != (last > 0)) return all;
  const double slowest =
      std::min(std::abs(first), std::abs(last)) - size * (velocity.pad.sum() + 0x1p-47 * velocity.radius);
  const double until = size * reach * (1 + 0x1p-40) / slowest;
  if (!(slowest > 0) || until <= begin) return slowest > 0 ? ExtraReach{0, 0, 0} : all;
  if (!(2 * (until - begin) < end - begin)) return all;
  const double rate = (all.from + until * all.rate) / (end - until) * (1 + 0x1p-40);
  return {rate * end, -rate, 0};
}

/// plane_proves() for a sum that rotates with the motions, by one normal for each end of the range.
template <int D>
bool planes_prove_of_turns(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                           const std::array<Vec<D>, 2>& normals, const ExtraReach& extra, double begin,
                           double end) {
  const MotionSet<D>& all = family.all;
  const auto one = [](const Vec<D>& centre, const VectorSet<D>& of) {
    return VectorSet<D>{.centre = centre, .pad = of.pad};
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec<D>& n = normals[i];
    const TrajectoryEstimate<D>& own = i == 0 ? family.first : family.last;
    const double along = encounter.turning->support(n[0], n[D > 1], family.rotations->ends[i]);
    const double growth = encounter.extents.grows ? encounter.extents.growth.support(n) : 0;
    const double reach = encounter.extents.support_with(n, along) + extra.from;
    const double c0 = min_of<D>(n, encounter.x, encounter.ex, all.place) - reach;
    const double v = min_of<D>(n, encounter.v, encounter.ev, one(own.v, all.velocity));
    const double c1 =
        v - growth - extra.rate - 4 * unit_roundoff * (std::abs(v) + growth + std::abs(extra.rate));
    const double c2 = 0.5 * min_of<D>(n, encounter.a, Vec<D>::zero(), one(own.a, all.acceleration)) -
                      extra.bend * (1 + 0x1p-48);
    if (!surely_positive(c0 - 4 * unit_roundoff * (std::abs(c0) + std::abs(reach)), c1, c2, begin, end))
      return false;
  }
  return true;
}

/// A plane that turns with the own outline, as along an edge of it: its normal is n in the present pose of the sum.
/// The corners of the other piece then rotate about the position of the start, by as much in the other direction.
/// Rotated normals have an error, by which own and other corners reach farther.
template <int D>
bool turning_plane_proves(const Encounter<D>& encounter, const TrajectoryFamily<D>& family, const Vec<D>& n,
                          double begin, double end) {
  if (encounter.extents.grows || (family.upper[0] != 0).any() || (family.lower[0] != 0).any()) return false;
  const double chord = encounter.rotation_chord, size = std::abs(n[0]) + std::abs(n[D > 1]);
  const double height = (0.5 * chord * chord + 0x1p-46) * size * (1 + 0x1p-48);
  const auto far = [&](const Vec<D>& vector) {
    return height * ((std::abs(vector[0]) + std::abs(vector[D > 1])) * (1 + 0x1p-48));
  };
  const auto own = [&](const VectorSet<D>& set) { return 0x1p-46 * size * set.radius; };
  const ExtraReach extra{far(encounter.x.abs() + encounter.ex) +
                             height * (encounter.turning->size() + std::abs(encounter.extents.radius)),
                         far(encounter.v.abs() + encounter.ev) + own(family.all.velocity),
                         0.5 * (far(encounter.a) + own(family.all.acceleration))};
  const SineCosine<double>& pose = encounter.turning->pose();
  std::array<Vec<D>, 2> normals{n, n};
  for (std::size_t i = 0; i < 2; ++i) {
    const SineCosine<double>& at = family.rotations->ends[i];
    const double cosine = at.cosine * pose.cosine + at.sine * pose.sine,
                 sine = at.sine * pose.cosine - at.cosine * pose.sine;
    normals[i][0] = n[0] * cosine + n[D > 1] * sine;
    normals[i][D > 1] = n[D > 1] * cosine - n[0] * sine;
  }
  return planes_prove_of_turns<D>(encounter, family, normals, extra, begin, end);
}

/// Whether a plane of normal n separates the two throughout [begin, end], for every change: a proof.
template <int D>
bool plane_proves(const Encounter<D>& encounter, const TrajectoryFamily<D>& family, const Vec<D>& n,
                  double begin, double end) {
  if (!(n.abs().largest() >= min_normal)) return false;
  if (D > 1 && encounter.turning)
    return planes_prove_of_turns<D>(encounter, family, {n, n},
                                    extra_reach_of_arc<D>(encounter, family, n, begin, end), begin, end);
  const MotionSet<D>& all = family.all;
  double inflation = 0;  // in x and y
  if constexpr (D > 1)
    if (encounter.inflation > 0)
      inflation = encounter.inflation * (std::abs(n[0]) + std::abs(n[1])) * (1 + 0x1p-50);
  const double reach = encounter.extents.support(n) + inflation,
               growth = encounter.extents.grows ? encounter.extents.growth.support(n) : 0;
  const double c0 = min_of<D>(n, encounter.x, encounter.ex, all.place) - reach;
  const double v = min_of<D>(n, encounter.v, encounter.ev, all.velocity);
  const double c1 = growth == 0 ? v : v - growth - 4 * unit_roundoff * (std::abs(v) + growth);
  const double c2 = 0.5 * min_of<D>(n, encounter.a, Vec<D>::zero(), all.acceleration);
  return surely_positive(c0 - 4 * unit_roundoff * (std::abs(c0) + std::abs(reach)), c1, c2, begin, end);
}

/// Near touching, a plane may fail only because the rounding of velocities crosses it at a late time. A plane tilted
/// by that error along v, the velocity of the other object relative to one motion, then separates the two.
template <int D>
bool tilted_plane_proves(const Encounter<D>& encounter, const TrajectoryFamily<D>& family, const Vec<D>& n,
                         const Vec<D>& v, double begin, double end) {
  const double square = (v * v).sum();
  if (!(square > 0)) return false;
  const Vec<D> unsure = family.all.velocity.pad + encounter.ev + 0x1p-50 * encounter.v.abs();
  const Vec<D> tilted = n + (2 * (n.abs() * unsure).sum() / square) * v;
  return plane_proves<D>(encounter, family, tilted, begin, end);
}

/// Whether two planes separate a sum that rotates: one until the nearest approach at tau and one after it. `v`: the
/// velocity of the other object relative to one motion, across n. Far from the nearest approach a plane tilted along v
/// gives the room that the rotation needs there; near it the rotation is outweighed by the turn of the velocity.
template <int D>
bool two_planes_prove(const Encounter<D>& encounter, const TrajectoryFamily<D>& family, const Vec<D>& n,
                      const Vec<D>& v, double tau, double begin, double end) {
  const double square = (v * v).sum();
  if (!(begin < tau && tau < end && square > 0) || !plane_proves<D>(encounter, family, n, tau, end))
    return false;
  const double chord = encounter.rotation_chord,
               room = 2.5 * encounter.turning->own_reach() * chord * (1 + chord);
  return plane_proves<D>(encounter, family, Vec<D>(n - (room / (square * (tau - begin))) * v), begin, tau);
}

}  // namespace foresee
