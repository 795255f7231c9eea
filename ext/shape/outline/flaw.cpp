#include "shape/outline/flaw.h"

#include "base/shown.h"
#include "shape/outline/wkt_writer.h"

namespace foresee {

namespace {

std::size_t ring_of(const Outline& outline, std::uint32_t corner) {
  std::size_t ring = 0;
  while (outline.ring_begin(ring + 1) <= corner) ++ring;
  return ring;
}

/// "(0 0, 2 2)"
std::string shown_edge(const Outline& outline, std::uint32_t begin) {
  const std::size_t ring = ring_of(outline, begin);
  const bool last = begin + 1 == outline.ring_begin(ring + 1);
  const std::size_t end = last ? outline.ring_begin(ring) : begin + 1;
  return '(' + shown(outline.corners()[begin]) + ", " + shown(outline.corners()[end]) + ')';
}

/// "edges (0 0, 2 2) and (2 0, 0 2)"
std::string both_edges(const Flaw& flaw, const Outline& outline) {
  return "edges " + shown_edge(outline, flaw.a) + " and " + shown_edge(outline, flaw.b);
}

}  // namespace

std::string shown(const Flaw& flaw, const Outline& outline) {
  const auto ring = [&](std::uint32_t edge) { return name_of_ring(outline, ring_of(outline, edge)); };
  const std::string place = '(' + shown(flaw.place) + ')';
  switch (flaw.kind) {
    case Flaw::Kind::few_corners:
      return ring(flaw.a) + " has fewer than three corners";
    case Flaw::Kind::no_area:
      return ring(flaw.a) + " encloses no area: its corners lie on one line";
    case Flaw::Kind::cross:
      return both_edges(flaw, outline) + " cross";
    case Flaw::Kind::overlap:
      return both_edges(flaw, outline) + " overlap";
    case Flaw::Kind::self_touch:
      return ring(flaw.a) + " touches itself at " + place + ": write a ring for each loop";
    case Flaw::Kind::edge_touch:
      return both_edges(flaw, outline) + " touch at " + place + ": write it as a corner of both rings";
    case Flaw::Kind::hole_outside:
      return ring(flaw.a) + " is a hole but lies outside its part";
    case Flaw::Kind::hole_inside:
      return ring(flaw.a) + " is a hole but lies within " + ring(flaw.b);
    case Flaw::Kind::part_inside:
      return ring(flaw.a) + " lies within " + ring(flaw.b) + ": write parts that lie apart";
  }
  return {};
}

std::string shown_turned(const Flaw& flaw, const Outline& outline, double heading) {
  const std::string turned = "turned by " + shown(heading) + " degrees ";
  if (flaw.kind == Flaw::Kind::edge_touch)
    return turned + "its rings part at (" + shown(flaw.place) + "): write it as a corner of both rings";
  if (flaw.kind == Flaw::Kind::few_corners || flaw.kind == Flaw::Kind::no_area)
    return turned + name_of_ring(outline, ring_of(outline, flaw.a)) +
           " encloses no area: its corners are closer than a double tells";
  return turned + "its " + both_edges(flaw, outline) + " touch: they are closer than a double tells";
}

}  // namespace foresee
