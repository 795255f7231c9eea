#include "contact/set/combined_sizes.h"

#include "shape/shapes.h"

namespace foresee {
namespace {

bool is_box(const Bodies& bodies) {
  return bodies.layout.shape == Shape::box;
}

/// What both rows have at two places, and what has grown since their t.
Size grown_size(ContactSet& set, const Setup& setup, int place_a, int place_b, int growth_a, int growth_b) {
  const int grown = set.growth(growth_a, growth_b, setup.a.at.t, setup.b.at.t, setup.horizon.now);
  return {set.sum(set.in_both(place_a, place_b), grown), set.in_both(growth_a, growth_b)};
}

/// Of what is round, boxes having none.
Size round_size(ContactSet& set, const Setup& setup, int Offsets::*place, int axis, double limit) {
  const Length growth = growth_of_both(setup, axis);
  const Size size = grown_size(set, setup, setup.a.at.*place, setup.b.at.*place, growth.a, growth.b);
  return set.sum(size, {set.given(limit)});
}

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

}  // namespace foresee
