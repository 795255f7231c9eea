#include "contact/set/minkowski_sum.h"

#include <bit>

#include "shape/shapes.h"

namespace foresee {
namespace {

bool is_box(const Bodies& bodies) {
  return bodies.layout.shape == Shape::box;
}

/// The numbers of both rows at two places, and the growth since their t.
Size grown_size(ContactSet& set, const Setup& setup, int place_a, int place_b, int growth_a, int growth_b) {
  const int grown = set.growth(growth_a, growth_b, setup.a.at.t, setup.b.at.t, setup.horizon.now);
  return {set.sum(set.in_both(place_a, place_b), grown), set.in_both(growth_a, growth_b)};
}

/// The combined size of balls and cylinders; a box adds 0.
Size round_size(ContactSet& set, const Setup& setup, int Offsets::*place, int axis, double limit) {
  const Length growth = growth_of_both(setup, axis);
  const Size size = grown_size(set, setup, setup.a.at.*place, setup.b.at.*place, growth.a, growth.b);
  return set.sum(size, {set.given(limit)});
}

/// One face of a box: its position, its bound, and its bound moved outward by the radius.
struct Side {
  bool there = false;
  Size at;
  int bound = -1, grown = -1;
};

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
  Side side(int axis, int sign, bool there, const Size& at) {
    if (!there) return {};
    return {true, at, set_.bound(axis, sign, at), set_.bound(axis, sign, set_.sum(at, radius_))};
  }

  static bool has(unsigned axes, std::size_t i) { return (axes >> i & 1) != 0; }
  const Side& side(std::size_t i, bool upper) const { return sides_[2 * i + (upper ? 1 : 0)]; }

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
      const Side& face = side(i, upper);
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
  std::vector<Side> sides_;  ///< below and above of each axis
};

}  // namespace

Length growth_of_both(const Setup& setup, int axis) {
  const auto growth = [axis](const Bodies& bodies) {
    return is_box(bodies) ? Offsets::absent : growth_place(bodies.layout.shape, bodies.at, axis);
  };
  return {Length::From::growth, growth(setup.a), growth(setup.b), setup.horizon.now, true,
          setup.a.at.t,         setup.b.at.t};
}

Size radius_of_both(ContactSet& set, const Setup& setup, double limit) {
  return round_size(set, setup, &Offsets::r, 0, limit);
}

Size height_of_both(ContactSet& set, const Setup& setup, double limit) {
  return round_size(set, setup, &Offsets::hz, 2, limit);
}

Size half_of_both(ContactSet& set, const Setup& setup, int axis) {
  const auto half = [axis](const Bodies& bodies) {
    return bodies.at.half == Offsets::absent ? Offsets::absent : bodies.at.half + axis;
  };
  const auto growth = [axis](const Bodies& bodies) {
    return is_box(bodies) ? growth_place(bodies.layout.shape, bodies.at, axis) : Offsets::absent;
  };
  return grown_size(set, setup, half(setup.a), half(setup.b), growth(setup.a), growth(setup.b));
}

std::vector<Faces> faces_of_boxes(ContactSet& set, const Setup& setup) {
  std::vector<Faces> faces;
  for (int axis = 0; axis < setup.a.layout.axes; ++axis) {
    const Size half = half_of_both(set, setup, axis);
    faces.push_back({.axis = axis, .below = half, .above = half});
  }
  return faces;
}

std::vector<Faces> faces_of_window(ContactSet& set, const Setup& setup) {
  // Coordinates are relative to the window's reference: a finite lower face is at 0, an upper one at the
  // exact width.
  const WindowFaces& window = *setup.window;
  std::vector<Faces> faces;
  for (int axis = 0; axis < setup.a.layout.axes; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    const bool below = window.has_lower(axis), above = window.has_upper(axis);
    int width = no_length;
    if (below && above) width = set.difference(set.given(window.upper[j]), set.given(window.lower[j]));
    faces.push_back({.axis = axis, .above = {width}, .has_below = below, .has_above = above});
  }
  return faces;
}

Faces grown_faces(ContactSet& set, Faces faces, const Size& length) {
  faces.below = set.sum(faces.below, length), faces.above = set.sum(faces.above, length);
  return faces;
}

std::vector<int> between(ContactSet& set, std::span<const Faces> faces) {
  std::vector<int> bounds;
  for (const Faces& f : faces) {
    if (f.has_below) bounds.push_back(set.bound(f.axis, -1, f.below));
    if (f.has_above) bounds.push_back(set.bound(f.axis, 1, f.above));
  }
  return bounds;
}

void add_box(ContactSet& set, std::span<const Faces> faces) {
  for (const Faces& f : faces) set.enclose(f);
  set.add_piece({.all = between(set, faces)});
}

void add_rounded_box(ContactSet& set, std::span<const Faces> faces, const Size& radius,
                     const Faces* along_z) {
  for (const Faces& f : faces) set.enclose(grown_faces(set, f, radius));
  std::vector<int> also;
  if (along_z) {
    also = between(set, {along_z, 1});
    set.enclose(*along_z);
  }
  RoundedBox(set, faces, radius, std::move(also)).add_pieces();
}

void add_ball(ContactSet& set, int axes, const Size& radius, const Faces* along_z) {
  Conditions piece;
  if (along_z) {
    piece.all = between(set, {along_z, 1});
    set.enclose(*along_z);
  }
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

}  // namespace foresee
