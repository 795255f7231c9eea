#include <algorithm>
#include <cmath>
#include <optional>

#include "format/form_blob.h"
#include "format/node_format.h"
#include "shape/mesh/mesh.h"

namespace foresee {
namespace {

/// Counts of a blob, and the offsets that follow from them.
struct MeshCounts {
  std::uint32_t triangles, corners;

  std::size_t corners_at() const { return form_header_size + sizeof(Triangle) * triangles; }
  std::size_t size() const { return corners_at() + sizeof(SpaceCorner) * corners + form_checksum_size; }
};

MeshCounts mesh_counts_of(const std::byte* blob) {
  const std::byte* const at = blob + form_counts_at;
  return {load_number<std::uint32_t>(at), load_number<std::uint32_t>(at + 4)};
}

FormKind kind_of_mesh(Mesh::Kind kind) {
  switch (kind) {
    case Mesh::Kind::surface:
      return FormKind::surface;
    case Mesh::Kind::solid:
      return FormKind::solid;
    case Mesh::Kind::parts:
      break;
  }
  return FormKind::parts;
}

/// Nothing if the kind is not one of a mesh.
std::optional<Mesh::Kind> mesh_kind_of(FormKind kind) {
  for (const auto known : {Mesh::Kind::surface, Mesh::Kind::solid, Mesh::Kind::parts})
    if (kind_of_mesh(known) == kind) return known;
  return std::nullopt;
}

/// Appends three corners per triangle, in the order of the blob.
const char* read_triangles(const std::byte* blob, const MeshCounts& counts,
                           std::vector<SpaceCorner>& corners) {
  for (std::size_t i = 0; i < std::size_t{3} * counts.triangles; ++i) {
    const auto number = load_number<std::uint32_t>(blob + form_header_size + 4 * i);
    if (number >= counts.corners) return "a triangle has a corner that does not exist";
    const auto at = load_number<SpaceCorner>(blob + counts.corners_at() + sizeof(SpaceCorner) * number);
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z)) return "a corner is not finite";
    corners.push_back(at);
  }
  return nullptr;
}

}  // namespace

std::vector<std::byte> encode_mesh(const Mesh& mesh) {
  const MeshCounts counts{static_cast<std::uint32_t>(mesh.triangles().size()),
                          static_cast<std::uint32_t>(mesh.corners().size())};
  std::vector<std::byte> blob = form_blob_of(kind_of_mesh(mesh.kind()), counts.size());
  store_number(blob.data() + form_counts_at, counts.triangles);
  store_number(blob.data() + form_counts_at + 4, counts.corners);
  std::byte* at = blob.data() + form_header_size;
  for (const Triangle& triangle : mesh.triangles()) {
    store_number(at, triangle);
    at += sizeof triangle;
  }
  for (const SpaceCorner& corner : mesh.corners()) {
    store_number(at, corner);
    at += sizeof corner;
  }
  seal_form(blob);
  return blob;
}

const char* decode_mesh(std::span<const std::byte> blob, Mesh& mesh) {
  mesh = {};
  if (const char* fault = form_frame_fault(blob)) return fault;
  const auto kind = mesh_kind_of(form_kind_of(blob));
  if (!kind) return "its format or kind is not known";
  const MeshCounts counts = mesh_counts_of(blob.data());
  if (counts.triangles == 0 || counts.triangles > max_triangles || counts.corners > 3 * counts.triangles)
    return "its counts are wrong";
  if (blob.size() != counts.size()) return "its size does not fit its counts";
  std::vector<SpaceCorner> corners;
  if (const char* fault = read_triangles(blob.data(), counts, corners)) return fault;
  mesh = welded(*kind, std::move(corners));
  // A blob that would be encoded differently is rejected, not normalized: foresee did not write it.
  const std::vector<std::byte> normal = encode_mesh(mesh);
  if (!std::equal(normal.begin(), normal.end(), blob.begin(), blob.end()))
    return "its corners are not those of its triangles";
  return is_sound(mesh) ? nullptr : "a triangle has no area, or its surface is not closed";
}

}  // namespace foresee
