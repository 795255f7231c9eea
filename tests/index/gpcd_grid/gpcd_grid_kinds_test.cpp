// Kinds in the production grid: its candidates are those of the same grid without kinds, filtered. That holds
// for every set of vector instructions, with giants and cores, within one side and between two.
#include <algorithm>
#include <iterator>

#include "every_simd.h"
#include "index/candidate_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"

namespace foresee::testing {
namespace {

std::vector<Kinds> kinds_of(const RandomScene& scene) {
  std::vector<Kinds> kinds;
  const Bodies bodies = scene.bodies();
  for (std::size_t i = 0; i < bodies.count; ++i) kinds.push_back(foresee::kinds_of(bodies.row(i), bodies.at));
  return kinds;
}

template <int D>
MovingBoxes<D> side(const RandomScene& scene, const Kinds* kinds) {
  return {scene.bodies(), scene.horizon(), Vec<D>::constant(0.5), kinds};
}

template <int D>
void expect_filtered(const RandomScene& a, const RandomScene* b) {
  const std::vector<Kinds> kinds_a = kinds_of(a), kinds_b = b ? kinds_of(*b) : kinds_a;
  const auto pairs = [&](bool with_kinds) {
    const MovingBoxes<D> first = side<D>(a, with_kinds ? kinds_a.data() : nullptr);
    if (!b) return drain(*make_gpcd_grid<D>(first, nullptr, never));
    const MovingBoxes<D> second = side<D>(*b, with_kinds ? kinds_b.data() : nullptr);
    return drain(*make_gpcd_grid<D>(first, &second, never));
  };
  const std::vector<Pair> all = pairs(false);
  std::vector<Pair> expected;
  std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
               [&](const Pair& pair) { return may_meet(kinds_a[pair.a], kinds_b[pair.b]); });
  EXPECT_TRUE(all.empty() || expected.size() < all.size());
  for_every_simd([&](Simd) { EXPECT_TRUE(pairs(true) == expected); });
}

class GpcdGridKinds : public ::testing::TestWithParam<SceneKind> {};
INSTANTIATE_TEST_SUITE_P(Scenes, GpcdGridKinds, ::testing::ValuesIn(all_scene_kinds), [](const auto& info) {
  std::string name = name_of(info.param);
  std::erase(name, ' ');
  return name;
});

TEST_P(GpcdGridKinds, AreThoseOfTheGridWithoutKindsFiltered) {
  for (const bool moves : {false, true})
    for (const bool ends : {false, true})
      for (int axes = 1; axes <= 3; ++axes) {
        const Layout layout{.axes = axes,
                            .law = moves ? Law::uniform : Law::rest,
                            .shape = Shape::ball,
                            .has_until = ends,
                            .has_category = true,
                            .has_mask = true};
        SCOPED_TRACE(name_of(layout));
        const RandomScene a = random_scene({.layout = layout, .kind = GetParam(), .count = 500, .seed = 8});
        const RandomScene b = random_scene({.layout = layout, .kind = GetParam(), .count = 300, .seed = 9});
        for (const RandomScene* other : {static_cast<const RandomScene*>(nullptr), &b}) {
          if (axes == 1) expect_filtered<1>(a, other);
          if (axes == 2) expect_filtered<2>(a, other);
          if (axes == 3) expect_filtered<3>(a, other);
        }
      }
}

}  // namespace
}  // namespace foresee::testing
