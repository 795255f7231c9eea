// What the pair kinds of a window share: its faces as numbers to compute with, and the window grown by R.
//
// Coordinates run from the window's reference: a finite lower face is at 0, an upper one at the exact width.
#pragma once

#include "contact/certified.h"
#include "contact/window_contact.h"

namespace foresee {

template <class T, int D>
struct WindowShape {
  bool has_lower[D], has_upper[D];
  T upper[D];

  explicit WindowShape(const WindowFaces& faces) {
    for (int j = 0; j < D; ++j) {
      const auto axis = static_cast<std::size_t>(j);
      has_lower[j] = faces.has_lower(j), has_upper[j] = faces.has_upper(j);
      upper[j] = has_lower[j] && has_upper[j]
                     ? Exactly<T>::difference_of(faces.upper[axis], faces.lower[axis])
                     : T{};
    }
  }
};

/// Between the faces of one axis, moved apart by `grown` on both sides.
template <class T, int D, class Visitor>
auto visit_between(const WindowShape<T, D>& s, int axis, const T& grown, Visitor& v) {
  const auto lower = [&] { return v.face(axis, Face::lower, T(-grown)); };
  const auto upper = [&] { return v.face(axis, Face::upper, T(s.upper[axis] + grown)); };
  if (!s.has_lower[axis]) return s.has_upper[axis] ? upper() : v.always();
  if (!s.has_upper[axis]) return lower();
  const auto above = lower();
  return v.all(above, upper());
}

/// The first N axes, grown by `radius` along one of them.
template <int N, class T, int D, class Visitor>
auto visit_grown_along(const WindowShape<T, D>& s, int axis, const T& radius, Visitor& v) {
  auto met = visit_between(s, axis, radius, v);
  for (int j = 0; j < N; ++j)
    if (j != axis) met = v.all(met, visit_between(s, j, T{}, v));
  return met;
}

/// Around the corner (in three axes: edge) at which faces of the given axes meet; bit i of `signs`: the upper
/// face of axes[i]. False where one of the faces is missing.
template <class T, int D, std::size_t N>
bool window_corner(const WindowShape<T, D>& s, const int (&axes)[N], unsigned signs,
                   std::array<Centre<T>, N>& centre) {
  for (std::size_t i = 0; i < N; ++i) {
    const bool upper = (signs >> i & 1) != 0;
    if (!(upper ? s.has_upper : s.has_lower)[axes[i]]) return false;
    centre[i] = {axes[i], upper ? s.upper[axes[i]] : T{}, upper ? 1 : -1};
  }
  return true;
}

/// The window over the axes x and y, grown by R in the Euclidean sense, as rounded_box.h does for boxes.
template <class T, int D, class Visitor>
auto visit_rounded_window_2(const WindowShape<T, D>& s, const T& radius, Visitor& v) {
  auto met = v.any(visit_grown_along<2>(s, 0, radius, v), visit_grown_along<2>(s, 1, radius, v));
  std::array<Centre<T>, 2> centre;
  for (unsigned signs = 0; signs < 4; ++signs)
    if (window_corner(s, {0, 1}, signs, centre)) met = v.any(met, v.ball(centre, radius));
  return met;
}

template <class T, class Visitor>
auto visit_rounded_window_3(const WindowShape<T, 3>& s, const T& radius, Visitor& v) {
  auto met = v.any(visit_grown_along<3>(s, 0, radius, v), visit_grown_along<3>(s, 1, radius, v));
  met = v.any(met, visit_grown_along<3>(s, 2, radius, v));
  std::array<Centre<T>, 2> edge;
  for (int along = 0; along < 3; ++along)
    for (unsigned signs = 0; signs < 4; ++signs)
      if (window_corner(s, {along == 0 ? 1 : 0, along == 2 ? 1 : 2}, signs, edge))
        met = v.any(met, v.all(visit_between(s, along, T{}, v), v.ball(edge, radius)));
  std::array<Centre<T>, 3> corner;
  for (unsigned signs = 0; signs < 8; ++signs)
    if (window_corner(s, {0, 1, 2}, signs, corner)) met = v.any(met, v.ball(corner, radius));
  return met;
}

}  // namespace foresee
