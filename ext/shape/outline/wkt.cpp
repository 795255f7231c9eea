#include "shape/outline/wkt.h"

#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "base/text/wkt_lexer.h"

namespace foresee {

namespace {

class OutlineReader : WktLexer {
 public:
  OutlineReader(std::string_view text, WktUnit unit) : WktLexer(text), unit_(unit) {}

  Outline outline() {
    skip_srid(unit_);
    if (take_word("MULTIPOLYGON"))
      parts();
    else if (take_word("POLYGON"))
      part();
    else
      refuse_kind();
    must_end();
    return std::move(outline_);
  }

 private:
  [[noreturn]] void refuse_kind() {
    for (const char* mesh : {"TIN", "POLYHEDRALSURFACE"})
      if (unit_ == WktUnit::metres && next_is(mesh))
        fail(std::string(mesh) +
             " is a mesh, as tables with x, y, z and without hz have: leave hz out, or write POLYGON or "
             "MULTIPOLYGON");
    if (rest().starts_with('{'))
      fail(
          "expected POLYGON or MULTIPOLYGON, found JSON: read it with json_each and write its corners as "
          "text");
    expected("POLYGON or MULTIPOLYGON");
  }

  /// "POLYGON Z ((...))"
  void refuse_more_numbers() {
    for (const char* more : {"Z", "M", "ZM"})
      if (next_is(more))
        fail("corners of a flat outline have two numbers: leave " + std::string(token()) + " out");
  }

  void refuse_empty() {
    refuse_more_numbers();
    if (next_is("EMPTY"))
      fail(unit_ == WktUnit::degrees ? "EMPTY is no zone: leave it out"
                                     : "EMPTY is no outline: write NULL for a point");
  }

  void parts() {
    refuse_empty();
    must_take('(');
    do part();
    while (take(','));
    must_take(')');
  }

  void part() {
    refuse_empty();
    must_take('(');
    outline_.begin_part();
    ring();
    while (take(',')) {
      outline_.begin_hole();
      ring();
    }
    must_take(')');
  }

  void ring() {
    refuse_empty();
    must_take('(');
    for (;;) {
      const double x = number();
      outline_.add({x, number()});
      if (!take(',')) break;
      if (outline_.corners().size() > max_corners) refuse_corners(1);
    }
    if (!take(')')) refuse_corner_end();
    const std::size_t last = outline_.rings() - 1;
    if (outline_.close_ring() || outline_.ring(last).size() == 1) {
      if (outline_.corners().size() > max_corners) refuse_corners(0);
      return;
    }
    throw Error(name_of_ring(outline_, last) + " is not closed: write the first corner (" +
                shown(outline_.ring(last).front()) + ") again at its end");
  }

  [[noreturn]] void refuse_corner_end() {
    if (next_is_number()) fail("a third number: corners of a flat outline have two: leave z out");
    expected(", or )");
  }

  /// Throws after the maximum number of corners: counts the others by the commas before them, since rings are
  /// closed. `pending`: the number of corners whose comma has been read.
  [[noreturn]] void refuse_corners(std::size_t pending) {
    std::size_t corners = outline_.corners().size() + pending;
    bool closed = pending == 0;
    for (const char c : rest()) {
      if (c == ',') {
        ++corners;
        closed = false;
      } else if (c == ')' && !closed) {
        --corners;
        closed = true;
      }
    }
    throw Error(std::to_string(corners) + " corners; at most " + std::to_string(max_corners) +
                ": simplify the outline");
  }

  WktUnit unit_;
  Outline outline_;
};

/// "(0 0, 2 0, 1 1, 0 0)"
void write_ring(std::span<const Corner> ring, std::string& text) {
  text += '(';
  for (const Corner& corner : ring) text += shown(corner) + ", ";
  text += shown(ring.front()) + ')';
}

/// "((0 0, 9 0, 5 9, 0 0), (4 1, 5 1, 5 2, 4 1))"
void write_part(const Outline& outline, std::size_t part, std::string& text) {
  for (std::size_t r = outline.part_start(part); r < outline.part_start(part + 1); ++r) {
    text += r == outline.part_start(part) ? "(" : ", ";
    write_ring(outline.ring(r), text);
  }
  text += ')';
}

}  // namespace

Outline read_outline(std::string_view text, WktUnit unit) {
  const FloatEnvironment environment;
  return OutlineReader(text, unit).outline();
}

std::string shown(const Corner& corner) {
  return shown(corner.x) + ' ' + shown(corner.y);
}

std::string name_of_ring(const Outline& outline, std::size_t ring) {
  std::size_t part = 0;
  while (outline.part_start(part + 1) <= ring) ++part;
  const std::string name = "ring " + std::to_string(ring - outline.part_start(part) + 1);
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
