#include "contact/minkowski/contact_set.h"

#include <algorithm>

namespace foresee {
namespace {

/// Its number.
template <class T>
int appended(std::vector<T>& list, const T& value) {
  list.push_back(value);
  return static_cast<int>(list.size()) - 1;
}

Primitive primitive_of(ConstraintKind kind, std::span<const AxisPart> parts, const Size& size) {
  Primitive primitive{.kind = kind, .count = static_cast<int>(parts.size()), .size = size};
  std::copy(parts.begin(), parts.end(), primitive.parts);
  return primitive;
}

int degree_of(const Size& size) {
  return size.moves() ? 1 : 0;
}

}  // namespace

int ContactSet::add(const Length& length) {
  if (length.varies) varying_.push_back(static_cast<int>(lengths_.size()));
  return appended(lengths_, length);
}

int ContactSet::add(const Primitive& primitive) {
  return appended(primitives_, primitive);
}

int ContactSet::bound(int axis, int sign, const Size& size) {
  const AxisPart part{.axis = axis, .sign = sign};
  return add(primitive_of(ConstraintKind::half_space, {&part, 1}, size));
}

int ContactSet::ball(std::span<const AxisPart> centre, const Size& radius) {
  return add(primitive_of(ConstraintKind::ball, centre, radius));
}

int ContactSet::degree() const {
  int degree = 0;
  for (const Primitive& primitive : primitives_) {
    degree = std::max(degree, degree_of(primitive.size));
    for (const AxisPart& part : primitive.parts) degree = std::max(degree, degree_of(part.at));
  }
  return degree;
}

ContactSet::Arrays ContactSet::arrays() const {
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  return {lengths_.data(), count(lengths_), primitives_.data(), count(primitives_), pieces_.data(),
          count(pieces_),  members_.data(), hull_.data(),       count(hull_)};
}

}  // namespace foresee
