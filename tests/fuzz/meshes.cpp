// Hostile meshes as text. The triangles have corners on a small grid and of any size; surfaces are closed,
// open or present twice; texts are cut, doubled and corrupted. The result must be a message or a mesh. A mesh
// must read back the same, be stored and read the same, and be connected in a tree. Its rotated form must be
// a mesh or be refused. A crash or a hang is a failure.
#include <array>
#include <vector>

#include "base/error.h"
#include "format/form_blob.h"
#include "shape/mesh/mesh.h"
#include "shape/mesh/mesh_text.h"
#include "shape/mesh/triangle_tree.h"
#include "wkt.h"

namespace foresee::testing {
namespace {

std::string corner(FuzzBytes& bytes) {
  const std::string x = fuzz_coordinate(bytes), y = fuzz_coordinate(bytes);
  return x + ' ' + y + ' ' + fuzz_coordinate(bytes);
}

/// A face of three or four of the corners.
std::string face(FuzzBytes& bytes, const std::vector<std::string>& corners) {
  std::string text, first;
  for (int n = bytes.in_range(0, 30) == 0 ? 4 : 3; n > 0; --n) {
    const std::string& next = corners[bytes.in_range<std::size_t>(0, corners.size() - 1)];
    if (first.empty()) first = next;
    text += next + ", ";
  }
  return "((" + text + first + "))";
}

/// The faces of a tetrahedron.
std::string closed(const std::vector<std::string>& corners) {
  constexpr std::array<std::array<std::size_t, 3>, 4> faces{{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  std::string text;
  for (const auto& [a, b, c] : faces)
    text += (text.empty() ? "((" : ", ((") + corners[a] + ", " + corners[b] + ", " + corners[c] + ", " +
            corners[a] + "))";
  return text;
}

std::string fuzz_text(FuzzBytes& bytes) {
  constexpr std::array words{"TIN Z", "POLYHEDRALSURFACE Z", "MULTIPOLYGON Z"};
  std::string text = words[bytes.in_range<std::size_t>(0, 2)];
  std::vector<std::string> corners;
  for (int n = bytes.in_range(4, 8); n > 0; --n) corners.push_back(corner(bytes));
  text += '(';
  const bool solid = bytes.flag();
  if (solid) text += closed(corners);
  for (int n = bytes.in_range(solid ? 0 : 1, 5); n > 0; --n)
    text += (text.ends_with('(') ? "" : ", ") + face(bytes, corners);
  return text + ')';
}

void require_whole(const TriangleTree& tree, const Mesh& mesh, const std::string& text) {
  std::size_t corners = 0;
  for (std::size_t t = 0; t < tree.count(); ++t)
    for (int i = 0; i < 3; ++i) corners += tree.owns_corner(t, i);
  require(tree.count() == mesh.triangles().size() && corners == mesh.corners().size(), "the tree lost some",
          text);
}

void run(FuzzBytes& bytes) {
  std::string text = fuzz_text(bytes);
  if (bytes.in_range(0, 3) == 0) spoil(text, bytes);
  const double heading = bytes.flag() ? bytes.in_range(-24, 24) * 15 : bytes.in_range(-36000, 36000) / 100.0;
  try {
    const Mesh mesh = read_mesh(text);
    require(read_mesh(write_mesh(mesh)) == mesh, "does not read back the same", text);
    check_mesh(mesh);
    Mesh stored;
    require(!decode_mesh(encode_mesh(mesh), stored) && stored == mesh, "is not stored the same", text);
    const TriangleTree tree(mesh);
    require_whole(tree, mesh, text);
    const Mesh rotated = turned(mesh, heading);
    check_turned(mesh, rotated, heading);
    require_whole(TriangleTree(tree, rotated), rotated, text);
  } catch (const Error& error) {
    require(std::strlen(error.what()) < 600, "a long message", text);
  }
}

}  // namespace
}  // namespace foresee::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foresee::testing::FuzzBytes bytes({data, size});
  foresee::testing::run(bytes);
  return 0;
}
