// The loops of BoxKernel: a kernel (base/simd.h).
//
// The end of a contact that box_lanes_kernel.h has found comes by the same method with the direction
// reversed. The earliest time at which a face is left is approximated, and certified by signs shortly before
// and after it. Until shortly before, the gap of every face is inside at the three Bernstein coefficients of
// the interval; shortly after, the gap of that face is outside. Error bounds are those of box_lanes_kernel.h.
#include "contact/boxes/box_lanes_kernel.h"

namespace foresee {
namespace {

/// The gap between a centre and a face, half - side x(t), in the time s after `from`: gap + slope s + bend
/// s^2.
struct FaceGap {
  double gap, slope, bend;
};

template <int D, int Degree>
void settle_ends_here(const BoxLanes<D, Degree>& __restrict lanes, EndLanes& __restrict ends) {
  for (int l = 0; l < lanes_width; ++l) {
    const double from = ends.from[l], end = lanes.end[l];
    const auto magnitude = [&lanes, l](int j, double s) {
      return place_at<Degree>(absolute(lanes.x[j][l]) + lanes.half[j][l], absolute(lanes.v[j][l]),
                              absolute(lanes.a[j][l]), s);
    };
    const auto error = [&lanes, l](int j, double s, double size) {
      return error_bound(lanes.ex[j][l] + s * lanes.ev[j][l], size);
    };
    const auto face = [&lanes, l, from](int j, double side) {
      const double bend = Degree < 2 ? 0 : lanes.a[j][l], turn = Degree < 2 ? 0 : from * bend;
      const double place = place_at<Degree>(lanes.x[j][l], lanes.v[j][l], bend, from);
      return FaceGap{lanes.half[j][l] - side * place, -side * (lanes.v[j][l] + 2 * turn), -side * bend};
    };

    // Faces are numbered: 2 j is the upper one on axis j, 2 j + 1 the lower one.
    double time = never, chosen = 0, chosen_axis = 0, chosen_side = 1, all = 0;
#pragma GCC unroll 6
    for (int number = 0; number < 2 * D; ++number) {
      const int j = number / 2;
      const double side = number % 2 == 0 ? 1 : -1;
      const FaceGap f = face(j, side);
      const double exit = from + first_root<Degree>(f.gap, f.slope, f.bend);
      const bool sooner = exit < time;
      time = sooner ? exit : time;
      chosen = sooner ? number : chosen;
      chosen_axis = sooner ? j : chosen_axis;
      chosen_side = sooner ? side : chosen_side;
      all += magnitude(j, end) + lanes.ex[j][l] + end * lanes.ev[j][l];
    }

    const double before = lesser(greater(time * (1 - near), from), end);
    const double after = lesser(time * (1 + near), end), stretch = before - from;
    double inside_before = never, outside_after = -never;
#pragma GCC unroll 6
    for (int number = 0; number < 2 * D; ++number) {
      const int j = number / 2;
      const double side = number % 2 == 0 ? 1 : -1;
      const double size = magnitude(j, after), lost = error(j, after, size);
      const FaceGap f = face(j, side);
      const double last = place_at<Degree>(f.gap, f.slope, f.bend, stretch);
      const double lowest = lesser(lesser(f.gap, f.gap + 0.5 * stretch * f.slope), last) - lost;
      // Between `before` and `after` an axis moves by less than 2^-32 of its magnitudes.
      const double moves = 0x1p-31 * size + lost;
      const double place = place_at<Degree>(lanes.x[j][l], lanes.v[j][l], lanes.a[j][l], after);
      const double outside = side * place - lanes.half[j][l] - lost;
      const bool leaves = chosen == number;
      inside_before = lesser(inside_before, lesser(lowest, last - lost - (leaves ? 0 : moves)));
      outside_after = leaves ? outside : outside_after;
    }
    const double fits = huge - all, inside = lesser(inside_before, fits), end_inside = end * (1 - 0x1p-50);
    ends.lasts[l] = before < end ? -1 : inside;
    ends.leaves[l] = before < end && after < end_inside ? lesser(outside_after, inside) : -1;
    ends.time[l] = time, ends.room[l] = after - before, ends.axis[l] = chosen_axis,
    ends.side[l] = chosen_side;
  }
}

}  // namespace

template <int D, int Degree, Simd simd>
const BoxKernel<D, Degree>& box_kernel() {
  static constexpr BoxKernel<D, Degree> kernel{settle_here<D, Degree>,
                                               settle_rows_here<D, Degree>,
                                               take_crossings<D, Degree, BoxLanes<D, Degree>>,
                                               find_crossings<CrossingDirection::entering, Degree>,
                                               settle_ends_here<D, Degree>,
                                               take_crossings<D, Degree, EndLanes>,
                                               find_crossings<CrossingDirection::leaving, Degree>};
  return kernel;
}

template const BoxKernel<1, 1>& box_kernel<1, 1, Simd::FORESEE_SIMD>();
template const BoxKernel<1, 2>& box_kernel<1, 2, Simd::FORESEE_SIMD>();
template const BoxKernel<2, 1>& box_kernel<2, 1, Simd::FORESEE_SIMD>();
template const BoxKernel<2, 2>& box_kernel<2, 2, Simd::FORESEE_SIMD>();
template const BoxKernel<3, 1>& box_kernel<3, 1, Simd::FORESEE_SIMD>();
template const BoxKernel<3, 2>& box_kernel<3, 2, Simd::FORESEE_SIMD>();

}  // namespace foresee
