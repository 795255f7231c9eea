// Hostile outlines as text: numbers on a small grid and of any size, rings that cross and touch, and texts
// that are cut, doubled and spoilt. A message or an outline will do; what is an outline must read back the
// same, be cut into pieces of its area, and lie turned as an outline or be refused. A crash or a hang will
// not do.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/shown.h"
#include "bytes.h"
#include "numbers/dyadic.h"
#include "shape/outline/convex_pieces.h"
#include "shape/outline/orientation.h"
#include "shape/outline/turn.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt_reader.h"
#include "shape/outline/wkt_writer.h"

namespace foresee::testing {
namespace {

void require(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s: %s\n", what, text.c_str());
  std::abort();
}

std::string number(FuzzBytes& bytes) {
  switch (bytes.in_range(0, 9)) {
    case 0: {
      const auto bits = bytes.any<std::uint64_t>();
      double any;
      std::memcpy(&any, &bits, sizeof any);
      return base::shown(any);
    }
    case 1: {
      const int exponent = bytes.in_range(-300, 200);
      return base::shown(std::ldexp(bytes.in_range(-9, 9), exponent));
    }
    case 2: {
      const double whole = bytes.in_range(0, 5);
      return base::shown(std::nextafter(whole, bytes.flag() ? 9 : -9));
    }
    default:
      return std::to_string(bytes.in_range(0, 5));
  }
}

std::string ring(FuzzBytes& bytes) {
  const std::string first = number(bytes) + ' ' + number(bytes);
  std::string text = '(' + first;
  for (int n = bytes.in_range(2, 5); n > 0; --n) {
    const std::string x = number(bytes);
    text += ", " + x + ' ' + number(bytes);
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

/// A few characters changed, cut out or doubled.
void spoil(std::string& text, FuzzBytes& bytes) {
  for (int n = bytes.in_range(1, 4); n > 0 && !text.empty(); --n) {
    const std::size_t at = bytes.in_range<std::size_t>(0, text.size() - 1), length = bytes.in_range(0, 8);
    const int kind = bytes.in_range(0, 3);
    if (kind == 0) text[at] = static_cast<char>(bytes.any<std::uint8_t>());
    if (kind == 1) text[at] = "()., -+e19nP"[bytes.in_range(0, 11)];
    if (kind == 2) text.erase(at, length);
    if (kind == 3) text.insert(at, text.substr(at, length));
  }
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
    for (std::size_t r = outline.part_begin(p); r < outline.part_begin(p + 1); ++r) {
      const Dyadic area = twice_area(outline.ring(r)), size = area.sign() < 0 ? -area : area;
      twice = r == outline.part_begin(p) ? twice + size : twice - size;
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

void run(FuzzBytes& bytes) {
  std::string text = fuzz_text(bytes);
  const bool spoilt = bytes.in_range(0, 3) == 0;
  if (spoilt) spoil(text, bytes);
  const double heading = bytes.flag() ? bytes.in_range(-24, 24) * 15 : bytes.in_range(-36000, 36000) / 100.0;
  try {
    const Outline outline = read_outline(text);
    require(read_outline(write_outline(outline)) == outline, "does not read back the same", text);
    check_outline(outline);
    const ConvexPieces pieces = convex_pieces(outline);
    require_tiling(pieces, outline, text);
    const Outline lies = turned(outline, heading);
    check_turned(outline, lies, heading);
    require_tiling(turned_pieces(pieces, lies), lies, text);
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
