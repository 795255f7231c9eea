#include "shape/mesh/test_meshes.h"

namespace foresee {

std::string fan(const std::string& word, std::size_t triangles) {
  std::string text = word;
  for (std::size_t i = 0; i < triangles; ++i) {
    const std::string here = std::to_string(i) + " 1 0", next = std::to_string(i + 1) + " 1 0";
    text += (i == 0 ? "(((0 0 5, " : ", ((0 0 5, ") + here + ", " + next + ", 0 0 5))";
  }
  return text + ")";
}

}  // namespace foresee
