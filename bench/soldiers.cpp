#include "soldiers.h"

#include <array>
#include <cmath>
#include <numbers>

#include "scenes.h"
#include "shape/mesh/shared_mesh.h"

namespace foresee::bench {
namespace {

using testing::Random;

constexpr std::size_t rings = 10, sides = 12, kinds = 16;

/// From the feet to the head: half of the width, arms held out, and of the depth.
constexpr std::array<double, rings> widths{0.9, 0.7, 0.6, 0.8, 0.9, 1.1, 2.2, 1.2, 0.5, 0.7};
constexpr std::array<double, rings> depths{0.8, 0.6, 0.5, 0.5, 0.6, 0.7, 0.7, 0.6, 0.5, 0.7};

/// Rings of corners one above the other, each slightly displaced, with a corner below and one above.
Mesh soldier(Random& random) {
  std::vector<SpaceCorner> places{{0, 0, -2.5}};
  for (std::size_t ring = 0; ring < rings; ++ring)
    for (std::size_t side = 0; side < sides; ++side) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(side) / sides;
      const double size = random.in(0.9, 1.1), z = (static_cast<double>(ring) + 0.5) / rings * 5 - 2.5;
      places.push_back({size * widths[ring] * std::cos(angle), size * depths[ring] * std::sin(angle), z});
    }
  places.push_back({0, 0, 2.5});
  std::vector<SpaceCorner> corners;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t place : {a, b, c}) corners.push_back(places[place]);
  };
  const auto at = [](std::size_t ring, std::size_t side) { return 1 + ring * sides + side % sides; };
  for (std::size_t side = 0; side < sides; ++side) {
    add(0, at(0, side + 1), at(0, side));
    for (std::size_t ring = 0; ring + 1 < rings; ++ring) {
      add(at(ring, side), at(ring, side + 1), at(ring + 1, side));
      add(at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side));
    }
    add(at(rings - 1, side), at(rings - 1, side + 1), places.size() - 1);
  }
  return welded(Mesh::Kind::solid, std::move(corners));
}

class Barracks final : public FormSource {
 public:
  Barracks() {
    Random random(240);
    for (std::size_t i = 0; i < kinds; ++i) {
      Mesh mesh = soldier(random);
      check_mesh(mesh);
      soldiers_.push_back(std::make_shared<const SharedMesh>(std::move(mesh)));
    }
  }
  std::shared_ptr<const Form> form(std::int64_t number) override {
    return soldiers_[static_cast<std::size_t>(number) - 1];
  }

 private:
  std::vector<std::shared_ptr<const SharedMesh>> soldiers_;
};

/// The same motions with meshes in place of boxes.
std::shared_ptr<Scene> soldiers_of(const Workload& boxes, FormSource& source) {
  auto scene = std::make_shared<Scene>();
  scene->name = "soldiers", scene->layout = boxes.layout;
  scene->layout.shape = Shape::mesh, scene->layout.has_heading = true;
  const Offsets from = row_offsets(boxes.layout), to = row_offsets(scene->layout);
  scene->rows.resize(boxes.count * static_cast<std::size_t>(to.size));
  Random random(boxes.count);
  for (std::size_t i = 0; i < boxes.count; ++i) {
    const double* box = boxes.rows.data() + i * static_cast<std::size_t>(from.size);
    double* row = scene->rows.data() + i * static_cast<std::size_t>(to.size);
    std::copy(box, box + from.half, row);  // the motion precedes the size
    row[to.outline] = 1 + static_cast<double>(i % kinds);
    row[to.heading] = std::floor(random.in(0, 360));
    const Extents<3> around =
        source.form(static_cast<std::int64_t>(row[to.outline]))->extents(row[to.heading]);
    std::copy_n(around.lower.data(), 3, row + to.bounds);
    std::copy_n(around.upper.data(), 3, row + to.bounds + 3);
    scene->ids.push_back(static_cast<std::int64_t>(i));
  }
  return scene;
}

}  // namespace

std::vector<ExplainRow> explain_soldiers(const PaperScene& paper, Interrupt& interrupt) {
  static Barracks barracks;
  const auto scene = soldiers_of(paper_workload(paper, "paper"), barracks);
  scene->take_forms(&barracks, interrupt);
  return explain_join({.a = scene, .h = paper.h, .method = JoinMethod::gpcd, .wants = {true, false, false}},
                      interrupt);
}

}  // namespace foresee::bench
