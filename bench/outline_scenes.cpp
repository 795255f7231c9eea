#include "outline_scenes.h"

#include <cmath>
#include <random>

#include "motion/swept_box.h"
#include "shape/outline/convex_pieces.h"

namespace foresee::bench {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /// Position and velocity of an object.
  void add_motion(OutlineFleet& fleet, double place, double speed) {
    for (const double limit : {place, place, speed, speed}) fleet.rows.push_back(number(-limit, limit));
  }

  /// A hull along a random course: bow and stern, and corners on both sides, some of which lie inward.
  Outline ship() {
    const int sides = static_cast<int>(number(1, 4.999));
    const double length = number(30, 150), beam = length * number(0.06, 0.09), turn = number(0, 6.283);
    std::vector<Corner> hull{{-beam, -length}, {beam, -length}};
    for (int i = 1; i <= sides; ++i) hull.push_back({beam * number(0.7, 1), length * (1.6 * i / sides - 1)});
    hull.push_back({0, length});
    for (int i = sides; i > 0; --i) hull.push_back({-beam * number(0.7, 1), length * (1.6 * i / sides - 1)});
    Outline outline;
    outline.begin_part();
    for (const Corner& c : hull)
      outline.add({c.x * std::cos(turn) + c.y * std::sin(turn), c.y * std::cos(turn) - c.x * std::sin(turn)});
    return outline;
  }

  Outline star(int corners) {
    Outline outline;
    outline.begin_part();
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * 3.14159265358979 * i / corners, r = number(50, 100);
      outline.add({r * std::cos(angle), r * std::sin(angle)});
    }
    return outline;
  }

 private:
  std::mt19937_64 random_;
};

void add(OutlineFleet& fleet, const Outline& outline) {
  fleet.outlines.push_back(outline);
  fleet.cut.push_back(convex_pieces(outline));
}

}  // namespace

OutlineScene ships(std::size_t count) {
  OutlineScene scene{"ships of 5 to 11 corners, 600 s", {}, {}, 600};
  Draw draw(1);
  for (OutlineFleet* fleet : {&scene.a, &scene.b})
    for (std::size_t i = 0; i < count; ++i) {
      draw.add_motion(*fleet, 6000, 9);
      add(*fleet, draw.ship());
    }
  return scene;
}

OutlineScene stars(std::size_t count) {
  OutlineScene scene{"stars of 100 corners, 60 s", {}, {}, 60};
  Draw draw(2);
  for (OutlineFleet* fleet : {&scene.a, &scene.b})
    for (std::size_t i = 0; i < count; ++i) {
      draw.add_motion(*fleet, 150, 3);
      add(*fleet, draw.star(100));
    }
  return scene;
}

OutlineScene points_and_a_star(std::size_t count) {
  OutlineScene scene{"points and a star of 100 corners, 60 s", {}, {}, 60};
  Draw draw(3);
  scene.a.rows = {0, 0, 1, 1};
  add(scene.a, draw.star(100));
  for (std::size_t i = 0; i < count; ++i) draw.add_motion(scene.b, 300, 9);
  return scene;
}

std::vector<Pair> candidates(const OutlineScene& scene, std::size_t max_pairs) {
  const auto swept = [&scene](const OutlineFleet& fleet, std::size_t i) {
    const Extents<2> extents = fleet.outlines.empty() ? Extents<2>::none() : fleet.outlines[i].extents();
    return swept_box<2>(motion_of<2>(fleet.bodies(), i), {0, scene.h},
                        grown<2>(extents, Vec<2>::constant(scene.within / 2)));
  };
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < scene.a.bodies().count; ++i) {
    const Box<2> box = swept(scene.a, i);
    for (std::uint32_t j = 0; j < scene.b.bodies().count && pairs.size() < max_pairs; ++j)
      if (box.meets(swept(scene.b, j))) pairs.push_back({i, j});
  }
  return pairs;
}

}  // namespace foresee::bench
