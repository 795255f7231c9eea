#include "shape/mesh/mesh_writer.h"

#include "base/float_environment.h"
#include "base/shown.h"

namespace foresee {

std::string shown(const SpaceCorner& corner) {
  return shown(corner.x) + ' ' + shown(corner.y) + ' ' + shown(corner.z);
}

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

std::string write_mesh(const Mesh& mesh) {
  const FloatEnvironment environment;
  std::vector<std::string> corners;  // each is in some six triangles
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
