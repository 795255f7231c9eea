#include "storage/format/form_blob.h"

#include "shape/mesh/cut_mesh.h"
#include "shape/outline/cut_outline.h"
#include "storage/format/mesh_blob.h"
#include "storage/format/outline_blob.h"

namespace foresee {

std::vector<std::byte> encode_form(const Form& form) {
  if (form.shape() == Shape::mesh) return encode_mesh(static_cast<const CutMesh&>(form).mesh());
  return encode_outline(static_cast<const CutOutline&>(form).outline());
}

const char* decode_form(std::span<const std::byte> blob, Shape shape, std::shared_ptr<const Form>& form) {
  form = nullptr;
  if (shape == Shape::mesh) {
    Mesh mesh;
    if (const char* fault = decode_mesh(blob, mesh)) return fault;
    form = std::make_shared<const CutMesh>(std::move(mesh));
  } else {
    Outline outline;
    if (const char* fault = decode_outline(blob, outline)) return fault;
    form = std::make_shared<const CutOutline>(std::move(outline));
  }
  return nullptr;
}

}  // namespace foresee
