// Reference implementation of the paper's grid: pairs that share a cell, each once, and bounded memory.
#include "index/paper_grid/paper_grid.h"

#include <numeric>

#include "index/candidate_pairs.h"
#include "sanitized.h"
#include "stopping_interrupt.h"

namespace foresee {
namespace {

using testing::all_scene_kinds;
using testing::drain;
using testing::in_order;
using testing::name_of;
using testing::never;
using testing::random_scene;
using testing::StopAt;
using testing::varied_layouts;
using testing::within_order;

template <int D>
std::vector<Box<D>> boxes_of(const testing::RandomScene& scene) {
  return swept_boxes<D>(scene.bodies(), scene.horizon(), Vec<D>::constant(scene.within / 2), never);
}

/// Steps 2 to 4 without entries: a pair shares a cell if the cells of both overlap on every axis.
template <int D>
struct PlainCells {
  explicit PlainCells(std::span<const Box<D>> boxes, double times = 1) {
    Vec<D> sum = Vec<D>::zero();
    double count = 0;
    from = Vec<D>::constant(std::numeric_limits<double>::infinity());
    for (const Box<D>& box : boxes)
      if (!box.is_empty()) sum += box.upper - box.lower, ++count, from = from.min(box.lower);
    size = sum / count * times;
  }
  bool share(const Box<D>& a, const Box<D>& b) const {
    if (a.is_empty() || b.is_empty()) return false;
    const auto cell = [&](const Vec<D>& x) {
      Vec<D> cells = (x - from) * (1 / size);
      for (int j = 0; j < D; ++j) cells[j] = std::floor(cells[j]);
      return cells;
    };
    return (cell(a.lower) <= cell(b.upper)).all() && (cell(b.lower) <= cell(a.upper)).all();
  }
  Vec<D> from, size;
};

template <int D>
std::vector<Pair> pairs_that_share(std::span<const Box<D>> boxes, const PlainCells<D>& cells) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (cells.share(boxes[i], boxes[j])) pairs.push_back({i, j});
  return pairs;
}

template <int D>
void expect_pairs_that_share_a_cell(std::size_t count, std::uint64_t seed) {
  const auto scene = random_scene(
      {.layout = {.axes = D, .law = Law::accelerated, .shape = Shape::box}, .count = count, .seed = seed});
  const std::vector<Box<D>> boxes = boxes_of<D>(scene);
  const PlainCells<D> cells{std::span<const Box<D>>(boxes)};
  PaperGrid<D> grid(boxes, never);
  EXPECT_TRUE((grid.figures().cell == cells.size).all());
  EXPECT_EQ(grid.figures().doubled, 1);
  const auto wanted = pairs_that_share<D>(boxes, cells);
  EXPECT_EQ(within_order(drain(grid)), wanted);
  EXPECT_GT(wanted.size(), count);
}

TEST(PaperGrid, FindsExactlyThePairsThatShareACell) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    expect_pairs_that_share_a_cell<1>(200, seed);
    expect_pairs_that_share_a_cell<2>(300, seed);
    expect_pairs_that_share_a_cell<3>(400, seed);
  }
}

TEST(PaperGrid, CellsAreTheMeanIntervals) {
  const std::vector<Box<2>> boxes = {{{0, 0}, {1, 4}}, {{10, 20}, {13, 26}}};  // lengths 1 and 3, 4 and 6
  const PaperGrid<2> grid(boxes, never);
  EXPECT_EQ(grid.figures().cell[0], 2);
  EXPECT_EQ(grid.figures().cell[1], 5);
}

TEST(PaperGrid, CountsEntriesAndCells) {
  // Cells of 2: the first box meets cells 0 and 1, the second cell 1 alone.
  const std::vector<Box<1>> boxes = {{Vec<1>(0.0), Vec<1>(3.0)}, {Vec<1>(2.5), Vec<1>(3.5)}};
  PaperGrid<1> grid(boxes, never);
  EXPECT_EQ(grid.figures().entries, 3u);
  EXPECT_EQ(grid.figures().cells, 2u);
  EXPECT_EQ(drain(grid), (std::vector<Pair>{{0, 1}}));
}

template <int D>
void expect_every_pair_that_meets(const testing::RandomScene& scene, const std::string& what) {
  SCOPED_TRACE(what);
  const std::vector<Box<D>> boxes = boxes_of<D>(scene);
  PaperGrid<D> grid(boxes, never);
  testing::expect_all_once(within_order(drain(grid)), testing::pairs_that_meet<D>(boxes),
                           boxes.size() * boxes.size());

  const std::span<const Box<D>> all(boxes), some = all.first(boxes.size() / 3),
                                            rest = all.subspan(some.size());
  PaperGrid<D> between(some, rest, never);
  testing::expect_all_once(in_order(drain(between)), testing::pairs_that_meet<D>(some, rest),
                           some.size() * rest.size());
}

TEST(PaperGrid, LosesNoPairThatMeetsInAnyScene) {
  for (const Layout& layout : varied_layouts())
    for (auto kind : all_scene_kinds) {
      const auto scene = random_scene({.layout = layout, .kind = kind, .count = 60, .seed = 4});
      const std::string what = name_of(layout) + ", " + name_of(kind);
      if (layout.axes == 1) expect_every_pair_that_meets<1>(scene, what);
      if (layout.axes == 2) expect_every_pair_that_meets<2>(scene, what);
      if (layout.axes == 3) expect_every_pair_that_meets<3>(scene, what);
    }
}

/// Unit boxes on a diagonal, and one that spans them all.
std::vector<Box<3>> diagonal_with_giant(std::size_t count) {
  std::vector<Box<3>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = 2 * static_cast<double>(i);
    boxes.push_back({Vec<3>::constant(at), Vec<3>::constant(at + 1)});
  }
  boxes.push_back({Vec<3>::zero(), Vec<3>::constant(2 * static_cast<double>(count))});
  return boxes;
}

TEST(PaperGrid, DoublesItsCellsBeforeAGiantFillsThem) {
  // With the paper's cells the giant alone would meet some 5000^3 / 3^3 cells.
  const std::vector<Box<3>> boxes = diagonal_with_giant(testing::sanitized ? 2000 : 5000);
  PaperGrid<3> grid(boxes, never);
  EXPECT_GT(grid.figures().doubled, 1);
  EXPECT_LE(grid.figures().entries, 64 * (boxes.size() + 1));
  const PlainCells<3> cells(std::span<const Box<3>>(boxes), grid.figures().doubled);
  EXPECT_EQ(grid.figures().cell[0], cells.size[0]);
  EXPECT_EQ(within_order(drain(grid)), pairs_that_share<3>(boxes, cells));
}

TEST(PaperGrid, AnswersWhereNoDoubleHoldsTheMean) {
  const double infinity = std::numeric_limits<double>::infinity(), large = 1.5e308;
  const std::vector<Box<2>> scenes[] = {
      {{{0, 0}, {1, 1}}, {{-infinity, 0}, {infinity, 1}}, {{5, 1}, {6, infinity}}, {{9, 9}, {9, 9}}},
      {{{-large, 0}, {large, 1}},
       {{-large, 0}, {0, 1}},
       {{large, 0}, {large, 1}},
       {{-large, 0}, {-large, 1}}},
      {{{0, 0}, {0, 0}}, {{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}, {{5e-324, 0}, {5e-324, 0}}}};
  for (const std::vector<Box<2>>& boxes : scenes) {
    PaperGrid<2> grid(boxes, never);
    testing::expect_all_once(within_order(drain(grid)), testing::pairs_that_meet<2>(boxes), 6);
  }
}

TEST(PaperGrid, HasNoPairsWithoutObjects) {
  const std::vector<Box<2>> none, one = {{{0, 0}, {1, 1}}}, gone = {Box<2>::empty(), Box<2>::empty()};
  PaperGrid<2> of_none(none, never), of_one(one, never), of_gone(gone, never), between(one, none, never);
  EXPECT_TRUE(drain(of_none).empty());
  EXPECT_TRUE(drain(of_one).empty());
  EXPECT_TRUE(drain(of_gone).empty());
  EXPECT_TRUE(drain(between).empty());
}

TEST(PaperGrid, CanBeInterruptedWhileItIsBuiltAndWhileItIsRead) {
  const std::vector<Box<2>> crowd(3000, Box<2>{{0, 0}, {1, 1}});
  for (int checks : {0, 1, 2, 4}) {
    StopAt early(checks);
    EXPECT_THROW(PaperGrid<2>(crowd, early), Interrupted) << checks;
  }
  StopAt later(1000);
  PaperGrid<2> grid(crowd, later);
  later.checks_left = 20;
  EXPECT_THROW(drain(grid), Interrupted);
}

}  // namespace
}  // namespace foresee
