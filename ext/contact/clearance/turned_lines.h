// The verdict on a range of turns for a sum that rotates with them, by the line along each path.
//
//   verdict_by_lines<2>(encounter, family, begin, end)       // clear: a proof; no value: other proofs may know more
//
// How far a pair of corners is left of the path of turn k, times the speed, is A + B cos k + C sin k. So is the time at
// which the path passes it, times the square of the speed. Each is the sum of a wave of the own corner and one of the
// other. If all pairs are on one side for each turn of the range, all turns are clear, however wide the range is.
// Cost: linear in the corners of both, some 20 ns each.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/clearance/separating_plane.h"
#include "contact/clearance/separation.h"

namespace foresee {

inline double dot(const Vec<2>& a, const Vec<2>& b) {
  return a[0] * b[0] + a[1] * b[1];
}
inline double cross(const Vec<2>& a, const Vec<2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// mean + cosine cos k + sine sin k.
struct Wave {
  double mean, cosine, sine;

  double at(const SineCosine<double>& k) const { return mean + cosine * k.cosine + sine * k.sine; }
  /// The minimum for |k| up to a half width, below 90 degrees.
  double min_within(const SineCosine<double>& half) const {
    const bool dips = cosine < 0 && std::abs(sine) * half.cosine < -cosine * half.sine;
    return dips ? -(-*this).peak() : std::min(at({-half.sine, half.cosine}), at(half));
  }
  Wave operator+(const Wave& o) const { return {mean + o.mean, cosine + o.cosine, sine + o.sine}; }
  Wave operator-() const { return {-mean, -cosine, -sine}; }
  Wave minus(const Wave& other, double times) const {
    return {mean - times * other.mean, cosine - times * other.cosine, sine - times * other.sine};
  }
  /// With k counted from another angle.
  Wave from(const SineCosine<double>& k) const {
    return {mean, cosine * k.cosine + sine * k.sine, sine * k.cosine - cosine * k.sine};
  }
  double peak() const { return mean + std::sqrt(cosine * cosine + sine * sine); }
  /// Requires: these are less than 180 degrees apart.
  bool peaks_between(const SineCosine<double>& first, const SineCosine<double>& last) const {
    return first.cosine * sine - first.sine * cosine > 0 && last.cosine * sine - last.sine * cosine < 0;
  }
  Wave plus(double more) const { return {mean + more, cosine, sine}; }
  /// Where it is nearest to 0, if it has one sign.
  SineCosine<double> nearest() const {
    const double size = std::copysign(std::sqrt(cosine * cosine + sine * sine), -mean);
    return {sine / size, cosine / size};
  }
  /// Where it falls through 0, as k increases (1) or decreases (-1).
  std::optional<SineCosine<double>> falls(int direction) const {
    const double square = cosine * cosine + sine * sine, size = std::sqrt(square);
    if (!(std::abs(mean) < size)) return std::nullopt;
    const double along = -mean, aside = direction * std::sqrt((size - mean) * (size + mean));
    return SineCosine<double>{(along * sine + aside * cosine) / square,
                              (along * cosine - aside * sine) / square};
  }
};

/// The ranges of some waves at both ends, and of their cosines. `bottom` and `top` have the lowest and the highest
/// value in the middle.
struct WavesOfCorners {
  static constexpr double inf = std::numeric_limits<double>::infinity();

  void add(const SineCosine<double>& half, const Wave& wave) {
    const double numbers[] = {wave.at({-half.sine, half.cosine}), wave.at(half), wave.cosine};
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], numbers[i]);
      high[i] = std::max(high[i], numbers[i]);
    }
    const double middle = wave.mean + wave.cosine;
    if (middle < lowest) lowest = middle, bottom = wave;
    if (middle > highest) highest = middle, top = wave;
  }

  double low[3]{inf, inf, inf}, high[3]{-inf, -inf, -inf}, lowest = inf, highest = -inf;
  Wave bottom{}, top{};
};

template <int D>
class TurnedLines {
 public:
  TurnedLines(const Encounter<D>& encounter, const TrajectoryFamily<D>& family)
      : half_{family.all.velocity.sine, family.all.velocity.cosine}, radius_(encounter.extents.radius) {
    const Vec<2> own = family.all.velocity.centre.template first<2>(),
                 other = encounter.v.template first<2>(), x = encounter.x.template first<2>();
    for (const Corner& corner : encounter.turning->own_corners()) {
      const Vec<2> p{corner.x, corner.y};
      across_[0].add(half_, {cross(p, own), -cross(p, other), -dot(p, other)});
      along_[0].add(half_, {-dot(p, own), dot(p, other), cross(other, p)});
    }
    for (const Corner& corner : encounter.turning->other_corners()) {
      const Vec<2> w = x + Vec<2>(corner.x, corner.y);
      across_[1].add(half_, {cross(w, other), -cross(w, own), dot(w, own)});
      along_[1].add(half_, {-dot(w, other), dot(w, own), cross(w, own)});
    }
    const double fastest = std::sqrt(dot(own, own)) + std::sqrt(dot(other, other));
    slack_ = 0x1p-46 * fastest * fastest;
    square_.add(half_, {dot(own, own) + dot(other, other), -2 * dot(other, own), -2 * cross(other, own)});
  }

  /// Whether all pairs are left of all paths (1) or right of them (-1), by more than a margin.
  bool are_on_side(int side, double margin) const { return are_beyond(across_, side, 0, radius_, margin); }
  /// Whether all paths have not reached the pairs by then (1), or have left them before (-1).
  bool are_beyond(int side, double time, double margin) const {
    return are_beyond(along_, side, -side * time, radius_, margin);
  }
  /// Whether each path passes between two pairs, and all pairs between these times. Approximate.
  bool touch(double begin, double end) const {
    return (across_[0].top + across_[1].top).min_within(half_) > 0 &&
           (-(across_[0].bottom + across_[1].bottom)).min_within(half_) > 0 &&
           are_beyond(along_, 1, -begin, 0, 0) && are_beyond(along_, -1, end, 0, 0);
  }

 private:
  /// Whether the waves of all pairs, and `squares` times the square of the speed, are above the margin and the radius
  /// times the speed; -1: minus these waves.
  bool are_beyond(const WavesOfCorners (&of)[2], int sign, double squares, double radius,
                  double margin) const {
    double bound[3];
    for (int i = 0; i < 3; ++i)
      bound[i] = (sign > 0 ? of[0].low[i] + of[1].low[i] : -(of[0].high[i] + of[1].high[i])) +
                 squares * square_.low[i];
    if (radius > 0) {
      // Not below the radius times the speed, and equal at the end where they are nearer: a b <= (a a + b b) / 2.
      const double there = square_.low[bound[0] < bound[1] ? 0 : 1], times = radius / (2 * std::sqrt(there));
      for (int i = 0; i < 3; ++i) bound[i] -= times * (square_.low[i] + (i < 2 ? there + slack_ : 0));
    }
    // Between the ends a wave is below them by up to this share of its cosine.
    const double height = half_.sine * half_.sine / (1 + half_.cosine);
    const double lowest = std::min(bound[0], bound[1]) + std::min(0.0, bound[2]) * height;
    return lowest > margin && std::isfinite(bound[0] + bound[1]);
  }

  SineCosine<double> half_;
  double radius_, slack_;  ///< an upper bound of the rounding of the square
  WavesOfCorners across_[2], along_[2], square_;
};

/// Requires: paths that are not bent, and a sum that rotates, in the pose of the middle.
template <int D>
std::optional<ClearanceVerdict> verdict_by_lines(const Encounter<D>& encounter,
                                                 const TrajectoryFamily<D>& family, double begin,
                                                 double end) {
  const VectorSet<D>&velocity = family.all.velocity, &place = family.all.place;
  if (encounter.extents.grows || !velocity.is_arc || velocity.whole_circle || velocity.cosine < 0) return {};
  if ((place.centre != 0).any() || (place.along != 0).any()) return {};
  const TurnedLines<D> lines(encounter, family);
  const double fastest = velocity.radius + encounter.v.abs().sum();
  // Of place and velocity, of rotated corners, and of the sums above.
  const double far = encounter.x.abs().sum() + encounter.extents.radius;
  const double error = (encounter.ex + place.pad + end * (encounter.ev + velocity.pad)).sum() +
                       0x1p-44 * encounter.turning->size() + 0x1p-47 * far;
  const double margin = error * fastest * (1 + 0x1p-40) + min_gap, later = 0x1p-48 * end * fastest * fastest;
  if (lines.are_on_side(1, margin) || lines.are_on_side(-1, margin) ||
      lines.are_beyond(1, end, margin + later) || lines.are_beyond(-1, begin, margin + later))
    return ClearanceVerdict::clear;
  if (D == 2 && lines.touch(begin, end)) return ClearanceVerdict::blocked;
  return {};
}

}  // namespace foresee
