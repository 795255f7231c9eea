// Hostile outlines as text: numbers on a small grid and of any size, rings that cross and touch, and texts
// that are cut, doubled and corrupted. The result must be a message or an outline. An outline must read back
// the same and be cut into pieces of its area. Its rotated form must be an outline or be refused. A crash or
// a hang is a failure.
#include <cstring>
#include <string>

#include "base/error.h"
#include "geography/zone.h"
#include "numbers/dyadic.h"
#include "shape/outline/convex_pieces.h"
#include "shape/outline/outline.h"
#include "shape/outline/outline_rotation.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"
#include "wkt.h"

namespace foresee::testing {
namespace {

std::string ring(FuzzBytes& bytes) {
  const std::string first = fuzz_coordinate(bytes) + ' ' + fuzz_coordinate(bytes);
  std::string text = '(' + first;
  for (int n = bytes.in_range(2, 5); n > 0; --n) {
    const std::string x = fuzz_coordinate(bytes);
    text += ", " + x + ' ' + fuzz_coordinate(bytes);
  }
  return text + ", " + first + ')';
}

std::string part(FuzzBytes& bytes) {
  std::string text = bytes.flag() ? "((0 0, 5 0, 5 5, 0 5, 0 0), " : "(";
  text += ring(bytes);
  for (int n = bytes.in_range(0, 2); n > 0; --n) text += ", " + ring(bytes);
  return text + ')';
}

std::string fuzz_text(FuzzBytes& bytes) {
  if (bytes.flag()) return "POLYGON" + part(bytes);
  std::string text = "MULTIPOLYGON(" + part(bytes);
  for (int n = bytes.in_range(0, 2); n > 0; --n) text += ", " + part(bytes);
  return text + ')';
}

Dyadic twice_area(std::span<const Corner> ring) {
  Dyadic twice;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice = twice + (Dyadic(a.x) * Dyadic(b.y) - Dyadic(a.y) * Dyadic(b.x));
  }
  return twice;
}

Dyadic twice_area(const Outline& outline) {
  Dyadic twice;
  for (std::size_t p = 0; p < outline.parts(); ++p)
    for (std::size_t r = outline.part_start(p); r < outline.part_start(p + 1); ++r) {
      const Dyadic area = twice_area(outline.ring(r)), size = area.sign() < 0 ? -area : area;
      twice = r == outline.part_start(p) ? twice + size : twice - size;
    }
  return twice;
}

void require_tiling(const ConvexPieces& pieces, const Outline& outline, const std::string& text) {
  Dyadic twice;
  for (std::size_t p = 0; p < pieces.count(); ++p) {
    require(convex_direction(pieces.corners(p)) == 1, "a piece is not convex", text);
    twice = twice + twice_area(pieces.corners(p));
  }
  require(twice == twice_area(outline), "the pieces are not the outline", text);
}

/// The same text as a zone in longitude and latitude.
void run_zone(const std::string& text) {
  NeverInterrupt never;
  try {
    const Zone zone = read_zone(text, {2, 179}, never);
    require(read_zone(write_outline(zone.degrees), {2, 179}, never).plane == zone.plane,
            "does not read back the same", text);
    require(!flaw_of(zone.plane), "is not valid on the plane", text);
  } catch (const Error&) {
  }
}

void run(FuzzBytes& bytes) {
  std::string text = fuzz_text(bytes);
  const bool spoilt = bytes.in_range(0, 3) == 0;
  if (spoilt) spoil(text, bytes);
  const double heading = bytes.flag() ? bytes.in_range(-24, 24) * 15 : bytes.in_range(-36000, 36000) / 100.0;
  run_zone(text);
  try {
    const Outline outline = read_outline(text);
    require(read_outline(write_outline(outline)) == outline, "does not read back the same", text);
    check_outline(outline);
    const ConvexPieces pieces = convex_pieces(outline);
    require_tiling(pieces, outline, text);
    const Outline rotated = turned(outline, heading);
    check_turned(outline, edge_touch_of(outline), rotated, heading);
    require_tiling(turned_pieces(pieces, rotated), rotated, text);
  } catch (const Error& error) {
    require(std::strlen(error.what()) < 400, "a long message", text);
  }
}

}  // namespace
}  // namespace foresee::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foresee::testing::FuzzBytes bytes({data, size});
  foresee::testing::run(bytes);
  return 0;
}
