#include "motion/motion_set.h"

namespace foresee {
namespace {

/// Relative error of turned vectors, relative to the length: covers the error of sine and cosine too.
constexpr double pad_of_turned = 0x1p-47;

/// The length of a vector whose squares may under- or overflow, up to some units in the last place.
double length_of(double x, double y) {
  const double largest = std::max(std::abs(x), std::abs(y));
  if (largest == 0) return 0;
  return largest * std::sqrt((x / largest) * (x / largest) + (y / largest) * (y / largest)) +
         lost_by_underflow;
}

}  // namespace

template <int D>
VectorSet<D> stored_vector(const Vec<D>& vector) {
  const Vec<D> size = vector.abs();
  return {.centre = vector,
          .pad = (size > 0).select(size * pad_of_stored + lost_by_underflow, Vec<D>::zero())};
}

template <int D>
VectorSet<D> turned_vectors(const Vec<D>& vector, double middle, double half) {
  VectorSet<D> set = stored_vector<D>(vector);
  if constexpr (D > 1) {
    const double length = length_of(vector[0], vector[1]);
    const SineCosine<double> at = quick_sine_cosine(middle);
    const SineCosine<double> wide =
        half == 0 ? SineCosine<double>{0, 1} : quick_sine_cosine(std::min(half, 180.0));
    set.centre[0] = vector[0] * at.cosine + vector[1] * at.sine;
    set.centre[1] = vector[1] * at.cosine - vector[0] * at.sine;
    set.pad[0] = set.pad[1] = length == 0 ? 0 : pad_of_turned * length + lost_by_underflow;
    set.is_arc = true;
    set.sine = wide.sine, set.cosine = wide.cosine, set.whole_circle = half >= 180;
    set.radius = length * (1 + 0x1p-49);
  }
  return set;
}

template <int D>
VectorSet<D> added_vectors(const Vec<D>& vector, const Vec<D>& course, double middle, double half) {
  VectorSet<D> set;
  set.centre = vector + middle * course;
  set.along = half * course;
  set.pad = pad_of_stored * (vector.abs() + (std::abs(middle) + half) * course.abs());
  return set;
}

template <int D>
VectorSet<D> vectors_scaled_by_square(const Vec<D>& vector, double m, double p, double q) {
  const double first = (m + p) / m, last = (m + q) / m;
  const double high = std::max(first * first, last * last);
  const double low = first <= 0 && last >= 0 ? 0 : std::min(first * first, last * last);
  VectorSet<D> set =
      added_vectors<D>(Vec<D>::zero(), vector, low + 0.5 * (high - low), 0.5 * (high - low) + 0x1p-48 * high);
  set.pad += (vector == 0).select(Vec<D>::zero(), Vec<D>::constant(lost_by_underflow));
  const double half = 0.5 * (last - first);
  set.bulge = half * half * std::sqrt((vector * vector).sum());
  return set;
}

template VectorSet<1> stored_vector<1>(const Vec<1>&);
template VectorSet<1> turned_vectors<1>(const Vec<1>&, double, double);
template VectorSet<1> added_vectors<1>(const Vec<1>&, const Vec<1>&, double, double);
template VectorSet<1> vectors_scaled_by_square<1>(const Vec<1>&, double, double, double);
template VectorSet<2> stored_vector<2>(const Vec<2>&);
template VectorSet<2> turned_vectors<2>(const Vec<2>&, double, double);
template VectorSet<2> added_vectors<2>(const Vec<2>&, const Vec<2>&, double, double);
template VectorSet<2> vectors_scaled_by_square<2>(const Vec<2>&, double, double, double);
template VectorSet<3> stored_vector<3>(const Vec<3>&);
template VectorSet<3> turned_vectors<3>(const Vec<3>&, double, double);
template VectorSet<3> added_vectors<3>(const Vec<3>&, const Vec<3>&, double, double);
template VectorSet<3> vectors_scaled_by_square<3>(const Vec<3>&, double, double, double);

}  // namespace foresee
