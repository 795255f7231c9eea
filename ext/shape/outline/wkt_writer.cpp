#include "shape/outline/wkt_writer.h"

#include "base/float_environment.h"
#include "base/shown.h"

namespace foresee {

namespace {

/// "(0 0, 2 0, 1 1, 0 0)"
void write_ring(std::span<const Corner> ring, std::string& text) {
  text += '(';
  for (const Corner& corner : ring) text += shown(corner) + ", ";
  text += shown(ring.front()) + ')';
}

/// "((0 0, 9 0, 5 9, 0 0), (4 1, 5 1, 5 2, 4 1))"
void write_part(const Outline& outline, std::size_t part, std::string& text) {
  for (std::size_t r = outline.part_begin(part); r < outline.part_begin(part + 1); ++r) {
    text += r == outline.part_begin(part) ? "(" : ", ";
    write_ring(outline.ring(r), text);
  }
  text += ')';
}

}  // namespace

std::string shown(const Corner& corner) {
  return shown(corner.x) + ' ' + shown(corner.y);
}

std::string name_of_ring(const Outline& outline, std::size_t ring) {
  std::size_t part = 0;
  while (outline.part_begin(part + 1) <= ring) ++part;
  const std::string name = "ring " + std::to_string(ring - outline.part_begin(part) + 1);
  return outline.parts() == 1 ? name : name + " of part " + std::to_string(part + 1);
}

std::string write_outline(const Outline& outline) {
  const FloatEnvironment environment;
  std::string text = outline.parts() == 1 ? "POLYGON" : "MULTIPOLYGON";
  for (std::size_t p = 0; p < outline.parts(); ++p) {
    if (outline.parts() > 1) text += p == 0 ? "(" : ", ";
    write_part(outline, p, text);
  }
  return outline.parts() == 1 ? text : text + ')';
}

}  // namespace foresee
