#include "shape/form.h"

#include "shape/mesh/cut_mesh.h"
#include "shape/mesh/mesh_text.h"
#include "shape/outline/cut_outline.h"
#include "shape/outline/wkt.h"

namespace foresee {

std::shared_ptr<const Form> read_form(Shape shape, std::string_view text) {
  if (shape == Shape::mesh) {
    Mesh mesh = read_mesh(text);
    check_mesh(mesh);
    return std::make_shared<const CutMesh>(std::move(mesh));
  }
  Outline outline = read_outline(text);
  check_outline(outline);
  return std::make_shared<const CutOutline>(std::move(outline));
}

}  // namespace foresee
