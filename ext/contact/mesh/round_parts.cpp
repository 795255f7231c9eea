#include "contact/mesh/round_parts.h"

namespace foresee {

RoundPart RoundParts::face_of_triangle(bool of_a, const SpaceCorner& seen_from) const {
  const SpacePiece& triangle = one(of_a);
  const Run &u = triangle.runs()[0], &v = triangle.runs()[1];
  RoundPart part{.round = condition(of_a, Kind::slab, 1, {.factors = 2, .u = u, .v = v}, *u.from, seen_from)};
  // The normal times an edge points inwards.
  for (const Run& run : triangle.runs())
    add(part,
        condition(of_a, Kind::plane, -1, {.factors = 3, .u = u, .v = v, .w = run}, *run.from, seen_from));
  return part;
}

RoundPart RoundParts::face_of_box(bool of_a, int i, const SpaceCorner& seen_from) const {
  const SpacePiece& box = one(of_a);
  const SpaceCorner &lower = box.corner(0), &upper = box.corner(7);
  const auto across = [&box](int axis) {
    return SpaceAxis{.factors = 1, .u = box.runs()[static_cast<std::size_t>(axis)]};
  };
  RoundPart part{.round = condition(of_a, Kind::slab, 1, across(i % 3), i < 3 ? lower : upper, seen_from)};
  for (const int axis : {(i + 1) % 3, (i + 2) % 3}) {
    add(part, condition(of_a, Kind::plane, -1, across(axis), lower, seen_from));
    add(part, condition(of_a, Kind::plane, 1, across(axis), upper, seen_from));
  }
  return part;
}

RoundPart RoundParts::edge(bool of_a, int i, const SpaceCorner& seen_from) const {
  const SpacePiece& piece = one(of_a);
  const auto [from, to] = piece.edge(i);
  const SpaceAxis along{.factors = 1, .u = piece.run_of_edge(i)};
  RoundPart part{.round = condition(of_a, Kind::tube, 1, along, piece.corner(from), seen_from)};
  add(part, condition(of_a, Kind::plane, -1, along, piece.corner(from), seen_from));
  add(part, condition(of_a, Kind::plane, 1, along, piece.corner(to), seen_from));
  return part;
}

/// With n = u x v, d - (p - q) is so far along u as it is along v x n, in lengths of n, and so far against v
/// as it is along n x u.
RoundPart RoundParts::edges(int i, int k) const {
  const auto [p_from, p_to] = a_.edge(i);
  const auto [q_from, q_to] = b_.edge(k);
  const Run &u = a_.run_of_edge(i), &v = b_.run_of_edge(k);
  const SpaceCorner &p = a_.corner(p_from), &p_end = a_.corner(p_to);
  const SpaceCorner &q = b_.corner(q_from), &q_end = b_.corner(q_to);
  const SpaceAxis beside_a{.factors = 3, .u = u, .v = v, .w = v},
      beside_b{.factors = 3, .u = u, .v = v, .w = u};
  RoundPart part{.round = {Kind::slab, 1, {.factors = 2, .u = u, .v = v}, &p, &q}};
  add(part, {Kind::plane, 1, beside_a, &p, &q});
  add(part, {Kind::plane, -1, beside_a, &p_end, &q});
  add(part, {Kind::plane, 1, beside_b, &p, &q});
  add(part, {Kind::plane, -1, beside_b, &p, &q_end});
  return part;
}

}  // namespace foresee
