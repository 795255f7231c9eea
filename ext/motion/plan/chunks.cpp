// Error analysis of the half extents
// ----------------------------------
// On one axis a leg is away from the middle of the box by f(s) = X + V s + a s^2 / 2 for the time s in [0, S] since
// its own t, with X = x - (bx + bv (t - bt)) and V = v - bv. Let u = 2^-53.
//  - X: t - bt, the product, and two sums are rounded: off by at most 4u (|x| + |bx| + |bv| (t - bt)).
//  - V is off by at most u |V|. This moves f by at most u |V| S.
// swept_axis() bounds the range of f from the rounded X and V, with S = until - t rounded, and covers the rounding of
// its own operations and of S (swept_box.cpp). `pad` is 16u times the sum of all magnitudes above, more than twice
// what X and V lose, so that it covers its own rounding, and 2^-1020 (S + 4) for underflow.
#include "motion/plan/chunks.h"

#include <algorithm>
#include <cmath>

#include "base/float_environment.h"
#include "motion/swept_box.h"

namespace foresee {
namespace {

/// The position at the end of a leg, up to rounding. Requires: the leg ends.
double end_of(const Leg& leg, std::size_t axis) {
  const double s = leg.until - leg.t;
  return leg.x[axis] + s * (leg.v[axis] + leg.a[axis] * s * 0.5);
}

/// The largest of the distances on the three axes.
double distance(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  double far = 0;
  for (std::size_t j = 0; j < 3; ++j) far = std::max(far, std::abs(to[j] - from[j]));
  return far;
}

std::array<double, 3> end_of(const Leg& leg) {
  return {end_of(leg, 0), end_of(leg, 1), end_of(leg, 2)};
}

/// The range of a leg around the middle of a box, on one axis.
Ends range_around(const ChunkBox& box, const Leg& leg, std::size_t axis) {
  constexpr double u = 0x1p-53;
  const double x = leg.x[axis], bx = box.x[axis], bv = box.v[axis], since = leg.t - box.t;
  const double v = leg.v[axis] - bv, a = leg.a[axis];
  // A leg without end on the path of the box itself is never away from it.
  const bool on_path = v == 0 && a == 0;
  const double s = on_path ? 0 : leg.until - leg.t;
  const LifeInterval life{0, s, s, false};
  const double offset = x - (bx + bv * since);
  if (leg.t == box.t && x == bx && on_path) return {0, 0};
  const double pad =
      16 * u * (std::abs(x) + std::abs(bx) + std::abs(bv) * since + std::abs(v) * s) + (s + 4) * 0x1p-1020;
  const Ends range = swept_axis(offset, v, a, life, pad, pad);
  return std::isnan(range.lower + range.upper) ? Ends{-no_end, no_end} : range;
}

Ends hull(const Ends& a, const Ends& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// Range of all legs around the middle of the box.
Ends range_around(const ChunkBox& box, std::span<const Leg> legs, std::size_t axis) {
  Ends all = range_around(box, legs[0], axis);
  for (const Leg& leg : legs.subspan(1)) all = hull(all, range_around(box, leg, axis));
  return all;
}

/// A box rests on an axis unless it is more than this many times as wide as one that follows the chord. Boxes of many
/// velocities spread apart in a node, away from its reference time. With 4 a window over random walks that start apart
/// reads four fifths of the nodes that it reads with 0, and finds 1.4 times as many chunks.
constexpr double rest_factor = 4;

/// The velocity of the chord; that of the leg, if it is the only one.
double chord_velocity(std::span<const Leg> legs, std::size_t axis) {
  const Leg &first = legs.front(), &last = legs.back();
  const double s = last.until - first.t;
  if ((legs.size() == 1 && first.a[axis] == 0) || !std::isfinite(s)) return last.v[axis];
  const double v = s > 0 ? (end_of(last, axis) - first.x[axis]) / s : 0;
  return std::isfinite(v) ? v : 0;
}

/// Appends `count` legs as chunks of equally many, up to one.
void append_run(std::size_t first, std::size_t count, std::vector<ChunkRange>& chunks) {
  const std::size_t parts = (count + legs_per_chunk - 1) / legs_per_chunk;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = count * part / parts, end = count * (part + 1) / parts;
    chunks.push_back({first + begin, end - begin});
  }
}

}  // namespace

std::vector<ChunkRange> cut_into_chunks(std::span<const Leg> legs) {
  const FloatEnvironment environment;
  std::vector<ChunkRange> chunks;
  std::size_t first = 0;            // of the current run
  double length = 0, duration = 0;  // of its last legs together, as many as a chunk may have
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    const bool starts = i > first && (leg.until == no_end || leg.t - legs[i - 1].until > duration ||
                                      distance(end_of(legs[i - 1]), leg.x) > length);
    if (starts) {
      append_run(first, i - first, chunks);
      first = i;
    }
    if ((i - first) % legs_per_chunk == 0) length = duration = 0;
    if (leg.until == no_end) continue;  // the last one
    length += distance(leg.x, end_of(leg));
    duration += leg.until - leg.t;
  }
  append_run(first, legs.size() - first, chunks);
  return chunks;
}

ChunkBox chunk_box(std::span<const Leg> legs, int axes) {
  const FloatEnvironment environment;
  ChunkBox box{.t = legs.front().t, .until = legs.back().until, .x = legs.front().x};
  for (std::size_t j = 0; j < static_cast<std::size_t>(axes); ++j) {
    Ends around = range_around(box, legs, j);
    box.v[j] = chord_velocity(legs, j);
    const Ends around_chord = range_around(box, legs, j);
    if (around.upper - around.lower <= rest_factor * (around_chord.upper - around_chord.lower))
      box.v[j] = 0;
    else
      around = around_chord;
    // The box is moved into the middle of the legs.
    const double middle = 0.5 * around.lower + 0.5 * around.upper;
    if (std::isfinite(middle) && std::isfinite(box.x[j] + middle)) box.x[j] += middle;
  }
  box.half = half_extents_around(box, legs, axes);
  return box;
}

std::array<double, 3> half_extents_around(const ChunkBox& box, std::span<const Leg> legs, int axes) {
  const FloatEnvironment environment;
  std::array<double, 3> half{};
  for (std::size_t j = 0; j < static_cast<std::size_t>(axes); ++j) {
    const Ends range = range_around(box, legs, j);
    half[j] = std::max(-range.lower, range.upper);
  }
  return half;
}

}  // namespace foresee
