#include "shape/shared_form.h"

#include "shape/mesh/mesh_text.h"
#include "shape/mesh/shared_mesh.h"
#include "shape/outline/shared_outline.h"
#include "shape/outline/wkt.h"

namespace foresee {

std::shared_ptr<const Form> read_form(Shape shape, std::string_view text) {
  if (shape == Shape::mesh) {
    Mesh mesh = read_mesh(text);
    check_mesh(mesh);
    return std::make_shared<const SharedMesh>(std::move(mesh));
  }
  Outline outline = read_outline(text);
  check_outline(outline);
  return std::make_shared<const SharedOutline>(std::move(outline));
}

}  // namespace foresee
