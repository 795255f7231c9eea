#include "contact/minkowski/contact_set.h"

#include <algorithm>
#include <bit>

#include "contact/setup.h"

namespace foresee {
namespace {

/// One face of a box: its position, its bound, and its bound moved outward by the radius.
struct BoxSide {
  bool there = false;
  Size at;
  int bound = -1, grown = -1;
};

/// A box inflated by a radius in the Euclidean sense, as the union of simpler sets. These are the box inflated
/// along one axis, for every axis, a ball around every corner and, on three axes, a cylinder around every edge.
/// A face may be missing, for example of a window without x1.
class RoundedBox {
 public:
  RoundedBox(ContactSet& set, std::span<const Faces> faces, const Size& radius, std::vector<int> also)
      : set_(set), faces_(faces), radius_(radius), also_(std::move(also)) {
    for (const Faces& f : faces) {
      sides_.push_back(side(f.axis, -1, f.has_below, f.below));
      sides_.push_back(side(f.axis, 1, f.has_above, f.above));
    }
  }

  void add_pieces() {
    const auto subsets = 1U << faces_.size();
    for (unsigned along = 1; along < subsets; along <<= 1) add_grown_along(along);
    for (int corners = 2; corners <= static_cast<int>(faces_.size()); ++corners)
      for (unsigned round = 1; round < subsets; ++round)
        if (std::popcount(round) == corners) add_rounded_over(round);
  }

 private:
  BoxSide side(int axis, int sign, bool there, const Size& at) {
    if (!there) return {};
    return {true, at, set_.bound(axis, sign, at), set_.bound(axis, sign, set_.sum(at, radius_))};
  }

  static bool has(unsigned axes, std::size_t i) { return (axes >> i & 1) != 0; }
  const BoxSide& side(std::size_t i, bool upper) const { return sides_[2 * i + (upper ? 1 : 0)]; }

  /// The bounds of the faces across the axes that are not in `other`.
  std::vector<int> straight(unsigned other) const {
    std::vector<int> bounds = also_;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (const bool upper : {false, true})
        if (!has(other, i) && side(i, upper).there) bounds.push_back(side(i, upper).bound);
    return bounds;
  }

  void add_grown_along(unsigned axis) {
    Conditions piece{.all = straight(axis)};
    const auto i = static_cast<std::size_t>(std::countr_zero(axis));
    for (const bool upper : {false, true})
      if (side(i, upper).there) piece.all.push_back(side(i, upper).grown);
    set_.add_piece(piece);
  }

  /// Adds a piece around every corner (on three axes also edge) of the faces across the axes `round`.
  void add_rounded_over(unsigned round) {
    for (unsigned signs = 0; signs < 1U << faces_.size(); ++signs)
      if ((signs & ~round) == 0) add_corner(round, signs);
  }

  void add_corner(unsigned round, unsigned signs) {
    Conditions piece{.all = straight(round)};
    std::vector<AxisPart> centre;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!has(round, i)) continue;
      const bool upper = has(signs, i);
      const BoxSide& face = side(i, upper);
      if (!face.there) return;
      centre.push_back({.axis = faces_[i].axis, .sign = upper ? 1 : -1, .at = face.at});
      piece.around.push_back(face.grown);
      piece.beyond.push_back(face.bound);
    }
    piece.ball = set_.ball(centre, radius_);
    piece.all.push_back(piece.ball);
    set_.add_piece(piece);
  }

  ContactSet& set_;
  std::span<const Faces> faces_;
  Size radius_;
  std::vector<int> also_;
  std::vector<BoxSide> sides_;  ///< below and above of each axis
};

/// The faces on an axis, bounds on the other centre, before sizes move them outward: those of the setup's window, or
/// both at the origin.
Faces faces_of(ContactSet& set, const Setup& setup, int axis) {
  if (!setup.window) return {.axis = axis};
  // Coordinates are relative to the window's reference: a finite lower face is at 0, an upper one at the
  // exact width.
  const WindowFaces& window = *setup.window;
  const auto j = static_cast<std::size_t>(axis);
  const bool below = window.has_lower(axis), above = window.has_upper(axis);
  int width = no_length;
  if (below && above) width = set.difference(set.given(window.upper[j]), set.given(window.lower[j]));
  return {.axis = axis, .above = {width}, .has_below = below, .has_above = above};
}

/// A size of the rule, with its growth, as lengths of a set: r_a + r_b + limit, and both growths. A shape of size
/// r at its t has size r + growth (s - t) at time s. For a pair that is an exact linear function of time, too,
/// whose two reference times may differ. If no table declares a growth, then sizes are constant.
Size size_of_both(ContactSet& set, const Setup& setup, const PairSize& size) {
  const PairRule& rule = setup.rule;
  const int grown = set.growth(size.growth_a, size.growth_b, rule.t_a, rule.t_b, setup.horizon.now);
  return set.sum({set.sum(set.in_both(size.a, size.b), grown), set.in_both(size.growth_a, size.growth_b)},
                 {set.given(size.limit)});
}

/// Faces moved outward by a length.
Faces grown_faces(ContactSet& set, Faces faces, const Size& length) {
  faces.below = set.sum(faces.below, length), faces.above = set.sum(faces.above, length);
  return faces;
}

/// The primitives of the faces.
std::vector<int> between(ContactSet& set, std::span<const Faces> faces) {
  std::vector<int> bounds;
  for (const Faces& f : faces) {
    if (f.has_below) bounds.push_back(set.bound(f.axis, -1, f.below));
    if (f.has_above) bounds.push_back(set.bound(f.axis, 1, f.above));
  }
  return bounds;
}

/// Adds the piece and the hull between the faces.
void add_box(ContactSet& set, std::span<const Faces> faces) {
  for (const Faces& f : faces) set.enclose(f);
  set.add_piece({.all = between(set, faces)});
}

/// Adds pieces and hull of the box between the faces, inflated by `radius` on the axes of the faces. Every
/// piece is also within the bounds `also`. Requires: two or three axes.
void add_rounded_box(ContactSet& set, std::span<const Faces> faces, const Size& radius,
                     std::vector<int> also) {
  for (const Faces& f : faces) set.enclose(grown_faces(set, f, radius));
  RoundedBox(set, faces, radius, std::move(also)).add_pieces();
}

/// Adds the piece and the hull |x| <= radius over the first `axes` axes, within the bounds `also`.
void add_ball(ContactSet& set, int axes, const Size& radius, std::vector<int> also) {
  Conditions piece{.all = std::move(also)};
  std::vector<AxisPart> centre;
  for (int axis = 0; axis < axes; ++axis) {
    centre.push_back({.axis = axis});
    const Faces around{.axis = axis, .below = radius, .above = radius};
    set.enclose(around);
    for (const int bound : between(set, {&around, 1})) piece.around.push_back(bound);
  }
  piece.ball = set.ball(centre, radius);
  piece.all.push_back(piece.ball);
  set.add_piece(piece);
}

}  // namespace

int ContactSet::add(const Length& length) {
  if (length.varies) varying_.push_back(static_cast<int>(lengths_.size()));
  lengths_.push_back(length);
  return static_cast<int>(lengths_.size()) - 1;
}

int ContactSet::add(const Primitive& primitive) {
  primitives_.push_back(primitive);
  return static_cast<int>(primitives_.size()) - 1;
}

int ContactSet::bound(int axis, int sign, const Size& size) {
  return add(Primitive{ConstraintKind::half_space, 1, {{.axis = axis, .sign = sign}}, size});
}

int ContactSet::ball(std::span<const AxisPart> centre, const Size& radius) {
  Primitive ball{.kind = ConstraintKind::ball, .count = static_cast<int>(centre.size()), .size = radius};
  std::copy(centre.begin(), centre.end(), ball.parts);
  return add(ball);
}

int ContactSet::degree() const {
  for (const Primitive& primitive : primitives_) {
    if (primitive.size.moves()) return 1;
    for (const AxisPart& part : primitive.parts)
      if (part.at.moves()) return 1;
  }
  return 0;
}

ContactSet::Arrays ContactSet::arrays() const {
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  return {lengths_.data(), count(lengths_), primitives_.data(), count(primitives_), pieces_.data(),
          count(pieces_),  members_.data(), hull_.data(),       count(hull_)};
}

ContactSet contact_set(const Setup& setup) {
  const PairRule& rule = setup.rule;
  ContactSet set;
  const Size radius = size_of_both(set, setup, rule.radius);
  std::vector<Faces> faces;
  for (int axis = 0; axis < setup.a.layout.axes; ++axis)
    faces.push_back(
        grown_faces(set, faces_of(set, setup, axis), size_of_both(set, setup, rule.extent[axis])));
  if (rule.distance == Distance::per_axis) {
    add_box(set, faces);
    return set;
  }
  std::vector<int> along_z;
  if (rule.distance == Distance::upright) {
    along_z = between(set, {&faces.back(), 1});
    set.enclose(faces.back());
    faces.pop_back();
  }
  if (setup.window || rule.has_extent(0))
    add_rounded_box(set, faces, radius, std::move(along_z));
  else
    add_ball(set, static_cast<int>(faces.size()), radius, std::move(along_z));
  return set;
}

}  // namespace foresee
