#include "shape/mesh/mesh_text.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/number_text.h"
#include "base/text/wkt_lexer.h"
#include "shape/mesh/mesh.h"

namespace foresee {

namespace {

constexpr const char* all_words = "TIN Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z";

/// The first word of a text of this kind.
const char* word_of(Mesh::Kind kind) {
  switch (kind) {
    case Mesh::Kind::surface:
      return "TIN";
    case Mesh::Kind::solid:
      return "POLYHEDRALSURFACE";
    case Mesh::Kind::parts:
      return "MULTIPOLYGON";
  }
  return "";
}

class MeshReader : WktLexer {
 public:
  using WktLexer::WktLexer;

  Mesh mesh() {
    skip_srid();
    const Mesh::Kind kind = this->kind();
    faces();
    must_end();
    return welded(kind, std::move(corners_));
  }

 private:
  Mesh::Kind kind() {
    for (const auto kind : {Mesh::Kind::surface, Mesh::Kind::solid, Mesh::Kind::parts}) {
      const std::string word = word_of(kind);
      if (!take_word(word)) continue;
      refuse_empty();
      if (!take_word("Z")) refuse_numbers(word);
      refuse_empty();
      return kind;
    }
    if (next_is("POLYGON"))
      fail(std::string("POLYGON is a flat outline, which needs hz: declare hz in the table, or write ") +
           all_words);
    expected(all_words);
  }

  void refuse_empty() {
    if (next_is("EMPTY")) fail("EMPTY is no mesh: write NULL for a point");
  }

  /// "TIN ((...))", "TIN ZM ((...))"
  [[noreturn]] void refuse_numbers(const std::string& word) {
    const std::string why = "corners of a mesh have three numbers: write " + word + " Z";
    fail(word == "MULTIPOLYGON" && !next_is("M") && !next_is("ZM")
             ? why + ", or declare hz in the table for flat outlines"
             : why);
  }

  void faces() {
    must_take('(');
    do {
      if (corners_.size() == 3 * max_triangles) refuse_triangles();
      face();
    } while (take(','));
    must_take(')');
  }

  /// "((0 0 3, 4 0 3, 0 5 4, 0 0 3))"
  void face() {
    must_take('(');
    must_take('(');
    std::size_t count = 0;
    SpaceCorner first{}, last{};
    do {
      last = corner();
      if (count == 0) first = last;
      if (++count <= 3) corners_.push_back(last);
    } while (take(','));
    if (!take(')')) refuse_corner_end();
    const bool closed = count > 1 && first == last;
    if (!closed && count > 2)
      fail_face(count, "is not closed: write the first corner (" + shown(first) + ") again at its end");
    if (count != 4) {
      const std::size_t corners = closed ? count - 1 : count;
      fail_face(count, "has " + std::to_string(corners) + (corners == 1 ? " corner" : " corners") +
                           ": write triangles, of three corners each");
    }
    if (take(',')) fail_face(count, "has a second ring: write triangles, of one ring each");
    must_take(')');
  }

  SpaceCorner corner() {
    const double x = number();
    const double y = coordinate();
    return {x, y, coordinate()};
  }

  /// The second or third coordinate.
  double coordinate() {
    const std::string_view left = rest();
    if (left.starts_with(',') || left.starts_with(')')) fail("corners of a mesh have three numbers: x y z");
    return number();
  }

  [[noreturn]] void refuse_corner_end() {
    if (next_is_number()) fail("a fourth number: corners of a mesh have three: leave m out");
    expected(", or )");
  }

  /// Throws for the face that has just been read, which has `written` corners.
  [[noreturn]] void fail_face(std::size_t written, const std::string& what) const {
    const std::size_t kept = std::min<std::size_t>(written, 3);
    throw Error("face " + std::to_string((corners_.size() - kept) / 3 + 1) + ' ' + what);
  }

  /// Throws after the maximum number of triangles: counts the others by their parentheses, two per face.
  [[noreturn]] void refuse_triangles() {
    const std::string_view left = rest();
    const auto others = static_cast<std::size_t>(std::count(left.begin(), left.end(), '(')) / 2;
    throw Error(std::to_string(max_triangles + std::max<std::size_t>(others, 1)) + " triangles; at most " +
                std::to_string(max_triangles) + ": simplify the mesh");
  }

  std::vector<SpaceCorner> corners_;  ///< three per triangle
};

}  // namespace

Mesh read_mesh(std::string_view text) {
  const FloatEnvironment environment;
  return MeshReader(text).mesh();
}

std::string shown(const SpaceCorner& corner) {
  return shown(corner.x) + ' ' + shown(corner.y) + ' ' + shown(corner.z);
}

std::string write_mesh(const Mesh& mesh) {
  const FloatEnvironment environment;
  std::vector<std::string> corners;  // formatted once: each is in some six triangles
  corners.reserve(mesh.corners().size());
  for (const SpaceCorner& corner : mesh.corners()) corners.push_back(shown(corner));
  std::string text = word_of(mesh.kind()) + std::string(" Z");
  for (const Triangle& triangle : mesh.triangles()) {
    text += text.ends_with('Z') ? "(((" : ", ((";
    for (const std::uint32_t corner : triangle) text += corners[corner] + ", ";
    text += corners[triangle[0]] + "))";
  }
  return text + ')';
}

}  // namespace foresee
