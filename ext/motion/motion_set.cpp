#include "motion/motion_set.h"

#include <limits>

namespace foresee {
namespace {

/// Relative error of stored numbers: eight units in the last place cover four beside the stored number, its
/// rounding, and the roundings of these lines.
constexpr double pad_of_stored = 0x1p-49;
/// The same for turned vectors, relative to the length: covers the error of sine and cosine too.
constexpr double pad_of_turned = 0x1p-47;

template <int D>
Vec<D> vector_of(const std::array<double, 3>& values) {
  return Eigen::Map<const Vec<D>>(values.data());
}

/// Covers the underflow of a number that is not 0.
constexpr double lost = 8 * std::numeric_limits<double>::denorm_min();

template <int D>
VectorSet<D> stored(const Vec<D>& vector) {
  const Vec<D> size = vector.abs();
  return {.centre = vector, .pad = (size > 0).select(size * pad_of_stored + lost, Vec<D>::Zero())};
}

/// The length of a vector whose squares may under- or overflow, up to some units in the last place.
double length_of(double x, double y) {
  const double largest = std::max(std::abs(x), std::abs(y));
  if (largest == 0) return 0;
  return largest * std::sqrt((x / largest) * (x / largest) + (y / largest) * (y / largest)) + lost;
}

/// `vector` turned by any angle of [middle - half, middle + half], in degrees.
template <int D>
VectorSet<D> turned(const Vec<D>& vector, double middle, double half) {
  VectorSet<D> set = stored<D>(vector);
  if constexpr (D > 1) {
    const double length = length_of(vector[0], vector[1]);
    const SineCosine<double> at = quick_sine_cosine(middle);
    const SineCosine<double> wide =
        half == 0 ? SineCosine<double>{0, 1} : quick_sine_cosine(std::min(half, 180.0));
    set.centre[0] = vector[0] * at.cosine + vector[1] * at.sine;
    set.centre[1] = vector[1] * at.cosine - vector[0] * at.sine;
    set.pad[0] = set.pad[1] = length == 0 ? 0 : pad_of_turned * length + lost;
    set.turns = true;
    set.sine = wide.sine, set.cosine = wide.cosine, set.whole_circle = half >= 180;
    set.radius = length * (1 + 0x1p-49);
  }
  return set;
}

/// `vector` + s `course` for all |s - middle| <= half.
template <int D>
VectorSet<D> added(const Vec<D>& vector, const Vec<D>& course, double middle, double half) {
  VectorSet<D> set;
  set.centre = vector + middle * course;
  set.along = half * course;
  set.pad = pad_of_stored * (vector.abs() + (std::abs(middle) + half) * course.abs());
  return set;
}

/// `vector` times ((m + k) / m)^2 for all k of [p, q].
template <int D>
VectorSet<D> scaled_by_square(const Vec<D>& vector, double m, double p, double q) {
  const double first = (m + p) / m, last = (m + q) / m;
  const double high = std::max(first * first, last * last);
  const double low = first <= 0 && last >= 0 ? 0 : std::min(first * first, last * last);
  VectorSet<D> set =
      added<D>(Vec<D>::Zero(), vector, low + 0.5 * (high - low), 0.5 * (high - low) + 0x1p-48 * high);
  set.pad += (vector == 0).select(Vec<D>::Zero(), Vec<D>::Constant(lost));
  return set;
}

/// The rounding of the stored sum t + k, and of `later` and its sums.
double rounding_of_delay(const OwnMotion& base, double furthest, double later) {
  return 0x1p-52 * (std::abs(base.t) + furthest + 2 * later);
}

template <int D>
void delay(MotionSet<D>& set, const OwnMotion& base, double p, double q, double later) {
  p += later, q += later;
  const double middle = p + 0.5 * (q - p);
  const Vec<D> v = vector_of<D>(base.v), a = vector_of<D>(base.a);
  const double furthest = std::max(std::abs(p), std::abs(q));
  const double rounding = rounding_of_delay(base, furthest, later);
  const double half = std::max(middle - p, q - middle) * (1 + 0x1p-50) + rounding;
  set.place.centre = -middle * (v - (0.5 * middle) * a);
  set.place.along = half * (v - middle * a);
  set.place.pad = 0.5 * half * half * a.abs() +
                  pad_of_stored * (furthest * (v.abs() + furthest * a.abs()) + half * v.abs());
  set.velocity = added<D>(v, -a, middle, half);
  set.begin = std::max(0.0, p - rounding);
  set.end += q + rounding;
  if (base.until < std::numeric_limits<double>::infinity())
    set.end += 0x1p-52 * (std::abs(base.until) + furthest + later);
}

}  // namespace

double min_change(const OwnMotion& base, const Change& change, double p, double q) {
  const double furthest = std::max(std::abs(p), std::abs(q));
  switch (change.manoeuvre) {
    case Manoeuvre::turn:
      return 0x1p-41;
    case Manoeuvre::speed:
      return 2 * pad_of_stored * (change.speed + furthest);
    case Manoeuvre::climb:
      return 2 * pad_of_stored * (std::abs(base.v[2]) + furthest);
    case Manoeuvre::accelerate:
      return 2 * pad_of_stored * (std::abs(base.a[0]) + std::abs(base.a[1]) + std::abs(base.a[2]) + furthest);
    case Manoeuvre::delay:
      return 2 * rounding_of_delay(base, furthest, change.later);
  }
  return 0;
}

template <int D>
MotionSet<D> motions_between(const OwnMotion& base, const Change& change, double p, double q) {
  const double middle = p + 0.5 * (q - p);
  const double half = std::max(middle - p, q - middle) * (1 + 0x1p-50);
  const Vec<D> v = vector_of<D>(base.v), a = vector_of<D>(base.a);
  MotionSet<D> set;
  set.velocity = stored<D>(v), set.acceleration.centre = a;
  set.end = (base.until - base.t) * (1 + 0x1p-50);
  switch (change.manoeuvre) {
    case Manoeuvre::turn:
      set.velocity = turned<D>(v, middle, half);
      if ((a != 0).any()) {
        set.acceleration = turned<D>(a, middle, half);
        set.acceleration.pad += pad_of_stored * a.abs();
      }
      break;
    case Manoeuvre::speed:
      set.velocity = added<D>(v, v / change.speed, middle, half);
      if (change.scales_bend && (a != 0).any()) set.acceleration = scaled_by_square<D>(a, change.speed, p, q);
      break;
    case Manoeuvre::climb: {
      Vec<D> up = Vec<D>::Zero();
      up[D - 1] = 1;
      set.velocity = added<D>(v, up, middle, half);
      break;
    }
    case Manoeuvre::accelerate:
      set.acceleration = added<D>(a, v / change.speed, middle, half);
      break;
    case Manoeuvre::delay:
      delay<D>(set, base, p, q, change.later);
      break;
  }
  return set;
}

template MotionSet<1> motions_between<1>(const OwnMotion&, const Change&, double, double);
template MotionSet<2> motions_between<2>(const OwnMotion&, const Change&, double, double);
template MotionSet<3> motions_between<3>(const OwnMotion&, const Change&, double, double);

}  // namespace foresee
