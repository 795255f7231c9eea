// The grid over swept boxes of every layout and kind of scene, compared with all pairs and, independently,
// with Boost.Geometry's R-tree.
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>

#include "index/candidate_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/resting_bodies.h"

namespace foresee::testing {
namespace {

template <int D>
std::vector<Box<D>> boxes_of(const RandomScene& scene, double h) {
  return swept_boxes<D>(scene.bodies(), {scene.now, h}, Vec<D>::constant(scene.within / 2), never);
}

template <int D>
void expect_grid_agrees(const RandomScene& scene, const RandomScene& other, double h) {
  const RestingBodies<D> left(boxes_of<D>(scene, h)), right(boxes_of<D>(other, h));
  const std::vector<Box<D>> a = left.boxes(never), b = right.boxes(never);
  const std::vector<Pair> within = pairs_that_meet<D>(a), between = pairs_that_meet<D>(a, b);
  const MovingBoxes<D> second = right.side();
  // Because boxes are rounded outward, boxes on a lattice that just miss each other may meet; otherwise few
  // do.
  expect_all_once(within_order(drain(*make_gpcd_grid<D>(left.side(), nullptr, never))), within,
                  within.size() / 10 + 20);
  expect_all_once(in_order(drain(*make_gpcd_grid<D>(left.side(), &second, never))), between,
                  between.size() / 10 + 20);
}

void expect_grid_agrees(const RandomScene& scene, const RandomScene& other, double h) {
  SCOPED_TRACE(name_of(scene.layout));
  if (scene.layout.axes == 1) expect_grid_agrees<1>(scene, other, h);
  if (scene.layout.axes == 2) expect_grid_agrees<2>(scene, other, h);
  if (scene.layout.axes == 3) expect_grid_agrees<3>(scene, other, h);
}

class GpcdGridScenes : public ::testing::TestWithParam<SceneKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, GpcdGridScenes, ::testing::ValuesIn(all_scene_kinds), [](const auto& info) {
  std::string name = name_of(info.param);
  std::erase(name, ' ');
  return name;
});

TEST_P(GpcdGridScenes, AgreesWithAllPairsForEveryLayout) {
  for (const Layout& layout : varied_layouts())
    expect_grid_agrees(random_scene({layout, GetParam(), 150, 1}), random_scene({layout, GetParam(), 90, 2}),
                       3);
}

TEST_P(GpcdGridScenes, AgreesForEverySeed) {
  for (std::uint64_t seed = 10; seed < 20; ++seed)
    for (int axes = 1; axes <= 3; ++axes) {
      const Layout layout{axes, Law::accelerated, Shape::box, true, true};
      expect_grid_agrees(random_scene({layout, GetParam(), 500, seed}),
                         random_scene({layout, GetParam(), 200, seed + 100}), 3);
    }
}

TEST_P(GpcdGridScenes, AgreesForHorizonsOfAnyLength) {
  for (double h : {0.0, 1e-300, 100.0, 1e6, 1e150, 1e300})
    for (int axes = 1; axes <= 3; ++axes) {
      const Layout layout{axes, Law::accelerated, Shape::ball, false, false};
      const RandomScene scene = random_scene({layout, GetParam(), 120, 5});
      SCOPED_TRACE(h);
      const std::size_t all_pairs_count = scene.size() * (scene.size() - 1) / 2;
      auto agrees = [&]<int D>(std::integral_constant<int, D>) {
        const RestingBodies<D> all(boxes_of<D>(scene, h));
        expect_all_once(within_order(drain(*make_gpcd_grid<D>(all.side(), nullptr, never))),
                        pairs_that_meet<D>(all.boxes(never)), all_pairs_count);
      };
      if (axes == 1) agrees(std::integral_constant<int, 1>());
      if (axes == 2) agrees(std::integral_constant<int, 2>());
      if (axes == 3) agrees(std::integral_constant<int, 3>());
    }
}

namespace bg = boost::geometry;

template <int D>
using BoostPoint = bg::model::point<double, D, bg::cs::cartesian>;
template <int D>
using BoostBox = bg::model::box<BoostPoint<D>>;

template <int D>
BoostPoint<D> boost_point(const Vec<D>& x) {
  BoostPoint<D> point;
  bg::set<0>(point, x[0]);
  if constexpr (D > 1) bg::set<1>(point, x[1]);
  if constexpr (D > 2) bg::set<2>(point, x[2]);
  return point;
}

/// Self-join of an R-tree of the boxes: an independent index of another kind.
template <int D>
std::vector<Pair> pairs_by_rtree(const std::vector<Box<D>>& boxes) {
  using Value = std::pair<BoostBox<D>, std::uint32_t>;
  std::vector<Value> values;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].is_empty())
      values.push_back({BoostBox<D>(boost_point<D>(boxes[i].lower), boost_point<D>(boxes[i].upper)), i});
  const bg::index::rtree<Value, bg::index::rstar<16>> tree(values);
  std::vector<Pair> pairs;
  for (const Value& value : values)
    for (auto hit = tree.qbegin(bg::index::intersects(value.first)); hit != tree.qend(); ++hit)
      if (value.second < hit->second) pairs.push_back({value.second, hit->second});
  return in_order(pairs);
}

template <int D>
void expect_nothing_lost(SceneKind kind) {
  const std::size_t count = kind == SceneKind::one_spot ? 700 : 5000;
  const Layout layout{D, Law::accelerated, Shape::box, true, true};
  const RestingBodies<D> bodies(boxes_of<D>(random_scene({layout, kind, count, 42}), 3));
  const std::vector<Pair> found = within_order(drain(*make_gpcd_grid<D>(bodies.side(), nullptr, never)));
  const std::vector<Pair> judged = pairs_by_rtree<D>(bodies.boxes(never));
  expect_all_once(found, judged, judged.size() / 10 + 20);
}

TEST_P(GpcdGridScenes, LosesNoPairOfBoostsRTree) {
  expect_nothing_lost<1>(GetParam());
  expect_nothing_lost<2>(GetParam());
  expect_nothing_lost<3>(GetParam());
}

}  // namespace
}  // namespace foresee::testing
