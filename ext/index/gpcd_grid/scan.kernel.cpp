// The scan kernel (base/simd.h): separating-axis test of beams, one source for all vector widths
// (scan_vectors.h).
//
// The time test
// -------------
// Relative to the row, a lane's beam is a point that moves along a segment, and the row is a box with the sum
// of both extents. The two touch only if the segment meets the box. A segment and a box are disjoint exactly
// if they are separated along an axis, or along the cross product of an axis and the segment (separating axis
// theorem). Let m be the middle of the segment, d half of it and r the half extents of the box, all
// doubled. Then they are disjoint if
//
//   |m_i| > r_i + |d_i|     or     |m_i d_j - m_j d_i| > r_i |d_j| + r_j |d_i|
//
// for some axes i, j. This needs no division and no case for d = 0, and NaN keeps the pair. The first
// condition implies the comparison of the swept boxes (except for NaN), so that comparison is omitted. If
// objects exist for a part of the horizon only, the segment is cut to the time at which both exist.
//
// No pair is lost to rounding. All terms are sums of at most three products of at most three factors, and a
// pair that touches has |m_i| <= r_i + |d_i|. Let w be the travel of both. Then the error of each side is
// less than 2^-21 (r_i + |w_i|)(|d_j|) plus the same with i and j exchanged. r is already padded by 2^-20 of
// these terms (float_lanes.kernel.cpp). There, travel below 2^-40 is 0 and r is at least 2^-40, so products
// do not underflow. Numbers beyond 2^60 are NaN, so products do not overflow.
//
// Every operation is one of IEEE 754 and none is contracted, so all instruction sets keep the same pairs.
#include "base/simd.h"
#include "index/gpcd_grid/scan_vectors.h"

namespace foresee::gpcd {
namespace {

enum class Time { none, horizon, life };

/// The compared columns in registers: boxes if nothing moves, beams otherwise.
template <class V, int D, Time time>
struct Beams {
  using F = typename V::Floats;
  F lower[D], upper[D], centre[D], travel[D], extent[D], begin, end;

  /// `load` returns the floats of one column.
  template <class Load>
  [[gnu::always_inline]] inline Beams(const LaneView<D>& view, Load load) {
    for (int k = 0; k < D; ++k) {
      if constexpr (time == Time::none)
        lower[k] = load(view.lower[k]), upper[k] = load(view.upper[k]);
      else
        centre[k] = load(view.centre[k]), travel[k] = load(view.travel[k]), extent[k] = load(view.extent[k]);
    }
    if constexpr (time == Time::life) begin = load(view.begin), end = load(view.end);
  }
};

/// Removes from `kept` the lanes whose boxes do not meet.
template <class V, int D>
[[gnu::always_inline]] inline void keep_in_space(const Beams<V, D, Time::none>& a,
                                                 const Beams<V, D, Time::none>& b, typename V::Mask& kept) {
  for (int k = 0; k < D; ++k) {
    kept = V::but_greater(kept, b.lower[k], a.upper[k]);
    kept = V::but_greater(kept, a.lower[k], b.upper[k]);
  }
}

/// Removes from `kept` the lanes whose beams meet at no time.
template <class V, int D, Time time>
[[gnu::always_inline]] inline void keep_in_time(const Beams<V, D, time>& a, const Beams<V, D, time>& b,
                                                typename V::Mask& kept) {
  using F = typename V::Floats;
  F middle[D], half[D], size[D], abs_half[D];
  F at = {}, part = {};
  if constexpr (time == Time::life) {
    const F begin = V::max(a.begin, b.begin), end = V::min(a.end, b.end);
    kept = V::but_greater(kept, begin, end);
    at = (begin + end) * 0.5f, part = (end - begin) * 0.5f;
  }
  for (int k = 0; k < D; ++k) {
    middle[k] = b.centre[k] - a.centre[k];
    half[k] = b.travel[k] - a.travel[k];
    if constexpr (time == Time::life) middle[k] = middle[k] + half[k] * at, half[k] = half[k] * part;
    size[k] = a.extent[k] + b.extent[k];
    abs_half[k] = V::abs(half[k]);
    kept = V::but_greater(kept, V::abs(middle[k]), size[k] + abs_half[k]);
  }
  for (int i = 0; i < D; ++i)
    for (int j = i + 1; j < D; ++j)
      kept = V::but_greater(kept, V::abs(middle[i] * half[j] - middle[j] * half[i]),
                            size[i] * abs_half[j] + size[j] * abs_half[i]);
}

/// Keeps the lanes that are inside the core of row i at the start of the horizon; none whose numbers are NaN.
/// The rounding error here is about 2^-22 of coordinate, extent and travel. It is less than the padding of
/// the lane (2^-20 of extent and travel; float_lanes.kernel.cpp) and of the core (2^-18 of the coordinates).
/// So a covered lane certainly touches, and its box starts before the core ends.
template <class V, int D, Time time>
[[gnu::always_inline]] inline void keep_covered(const LaneView<D>& rows, std::size_t i,
                                                const Beams<V, D, time>& lanes, typename V::Mask& kept) {
  for (int k = 0; k < D; ++k) {
    const float core_lower = rows.core_lower[k][i], core_upper = rows.core_upper[k][i];
    if constexpr (time == Time::none) {
      kept = V::and_greater(kept, lanes.lower[k], V::all(core_lower));
      kept = V::and_greater(kept, V::all(core_upper), lanes.upper[k]);
    } else {  // all numbers are doubled
      const auto centre = lanes.centre[k] - lanes.travel[k];
      kept = V::and_greater(kept, centre - lanes.extent[k], V::all(core_lower + core_lower));
      kept = V::and_greater(kept, V::all(core_upper + core_upper), centre + lanes.extent[k]);
    }
  }
}

/// The first lane that may reach row i. Rows that are not clipped are in ascending order, so the search
/// resumes at scan.passed_lanes.
template <int D>
std::size_t first_lane(Scan<D>& scan, std::size_t i) {
  const LaneView<D>& lanes = *scan.lanes;
  const float* from = scan.keep == Keep::covered ? scan.rows->core_lower[0] : scan.rows->from;
  const double row_lower = from ? from[i] : scan.rows->lower[0][i];
  const auto reach = static_cast<float>(row_lower - lanes.longest);
  // Rounded down. NaN if that is infinite: then no lane is skipped.
  const float min_end = reach - (__builtin_fabsf(reach) * 0x1p-22f + 0x1p-126f);
  const auto ends_before = [&](std::size_t lane) { return lanes.lower[0][lane] < min_end; };
  if (from) {
    std::size_t first = 0;
    for (std::size_t count = lanes.size; count > 0;) {
      const std::size_t half = count / 2;
      const bool later = ends_before(first + half);
      first = later ? first + half + 1 : first;
      count = later ? count - half - 1 : half;
    }
    return first;
  }
  while (scan.passed_lanes < lanes.size && ends_before(scan.passed_lanes)) ++scan.passed_lanes;
  return scan.passed_lanes;
}

/// Prefetches the object of a later row: early enough for memory, late enough for stripes of some hundred.
template <int D>
[[gnu::always_inline]] inline void prefetch_object(const LaneView<D>& rows, std::size_t i) {
  constexpr std::size_t ahead = 128, line = 64;
  const ObjectRows& objects = rows.objects;
  if (!objects.first || i + ahead >= rows.size) return;
  const char* const object = objects.first + rows.ids[i + ahead] * objects.bytes;
  for (std::size_t place = 0; place < objects.bytes; place += line) __builtin_prefetch(object + place);
  __builtin_prefetch(object + objects.bytes - 1);
}

/// The scan kernel: compares each row with the lanes that start before it ends.
template <class V, int D, Time time, Keep keep, bool has_kinds>
std::size_t run_rows(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  const LaneView<D>& rows = *scan.rows;
  const LaneView<D> lanes = *scan.lanes;  // a copy, so that writes to `out` cannot change its pointers
  const bool within = scan.rows == scan.lanes;
  std::size_t work = steps * lanes_max;
  Pair* const begin = out;
  Pair* const full = out + room - lanes_max;
  for (; scan.row < rows.size; ++scan.row, scan.started = false) {
    const std::size_t i = scan.row;
    const std::uint32_t id = rows.ids[i], classes = rows.classes[i] | sentinel;
    const std::uint32_t category = has_kinds ? rows.categories[i] : 0, mask = has_kinds ? rows.masks[i] : 0;
    const Beams<V, D, time> row(rows, [i](const float* column) { return V::all(column[i]); });
    prefetch_object(rows, i);
    const float upper = keep == Keep::covered ? rows.core_upper[0][i]
                        : rows.to             ? rows.to[i]
                                              : rows.upper[0][i];
    std::size_t lane = scan.started ? scan.lane : within ? i + 1 : first_lane(scan, i);
    for (;; lane += V::width, work -= V::width) {
      if (work < lanes_max || out > full) {
        steps = work / lanes_max, scan.lane = lane, scan.started = true;
        return static_cast<std::size_t>(out - begin);
      }
      if (lanes.lower[0][lane] > upper) break;
      const Beams<V, D, time> beams(lanes, [lane](const float* column) { return V::load(column + lane); });
      typename V::Mask kept = V::unshared(lanes.classes + lane, classes);
      if constexpr (has_kinds) {
        kept = V::sharing(kept, lanes.categories + lane, mask);
        kept = V::sharing(kept, lanes.masks + lane, category);
      }
      if constexpr (keep != Keep::covered) {
        if constexpr (time == Time::none)
          keep_in_space<V, D>(row, beams, kept);
        else
          keep_in_time<V, D, time>(row, beams, kept);
      }
      if constexpr (keep != Keep::all) {
        typename V::Mask covered = kept;
        keep_covered<V, D, time>(rows, i, beams, covered);
        kept = keep == Keep::covered ? covered : V::but(kept, covered);
      }
      out = V::emit(kept, id, lanes.ids + lane, out);
    }
    work -= lanes_max;
  }
  steps = work / lanes_max;
  return static_cast<std::size_t>(out - begin);
}

/// Runs the kernel for the columns that the lanes have, and the pairs to keep.
template <int D>
std::size_t run_scan(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  if (room < lanes_max) return 0;
  const auto run = [&]<Time time, bool has_kinds>() {
    if (scan.keep == Keep::covered)
      return run_rows<Vector, D, time, Keep::covered, has_kinds>(scan, out, room, steps);
    if (scan.keep == Keep::others)
      return run_rows<Vector, D, time, Keep::others, has_kinds>(scan, out, room, steps);
    return run_rows<Vector, D, time, Keep::all, has_kinds>(scan, out, room, steps);
  };
  const auto run_in = [&]<Time time>() {
    return scan.lanes->categories ? run.template operator()<time, true>()
                                  : run.template operator()<time, false>();
  };
  const std::size_t written = !scan.lanes->travel[0] ? run_in.template operator()<Time::none>()
                              : !scan.lanes->begin   ? run_in.template operator()<Time::horizon>()
                                                     : run_in.template operator()<Time::life>();
  if (scan.swap)
    for (std::size_t i = 0; i < written; ++i) out[i] = {out[i].b, out[i].a};
  return written;
}

}  // namespace

template <int D, Simd simd>
ScanKernel<D> scan_kernel() {
  return run_scan<D>;
}

template ScanKernel<1> scan_kernel<1, Simd::FORESEE_SIMD>();
template ScanKernel<2> scan_kernel<2, Simd::FORESEE_SIMD>();
template ScanKernel<3> scan_kernel<3, Simd::FORESEE_SIMD>();

}  // namespace foresee::gpcd
