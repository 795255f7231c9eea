// Memory that a grid keeps between queries: it grows on demand and shrinks to the need of the last query.
#include "index/gpcd_grid/work_space.h"

#include <gtest/gtest.h>

#include "index/candidate_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"

namespace foresee::testing {
namespace {

TEST(WorkSpace, KeepsWhatTheNextQueryNeeds) {
  Buffer<std::uint64_t> buffer;
  const std::uint64_t* first = buffer.room(100000);
  buffer.trim();
  EXPECT_EQ(buffer.room(100000), first);
  EXPECT_EQ(buffer.room(40000), first);
}

TEST(WorkSpace, GivesBackWhatTheLastQueryHadNoUseFor) {
  Buffer<std::uint64_t> buffer;
  buffer.room(100000);
  buffer.trim();
  buffer.room(30000);
  buffer.trim();
  EXPECT_GE(buffer.bytes(), 100000 * sizeof(std::uint64_t));
  buffer.room(10000);
  buffer.trim();
  EXPECT_EQ(buffer.bytes(), 0u);
}

TEST(WorkSpace, OfAGridFollowsTheScene) {
  NeverInterrupt never;
  const auto space = std::make_shared<GridSpace>();
  const auto join = [&](std::size_t count) {
    const RandomScene scene = random_scene({.layout = {.axes = 2, .law = Law::uniform}, .count = count});
    const MovingBoxes<2> boxes{scene.bodies(), scene.horizon(), Vec<2>::constant(0.5)};
    const auto kept = drain(*make_gpcd_grid<2>(boxes, nullptr, never, space));
    EXPECT_EQ(within_order(kept), within_order(drain(*make_gpcd_grid<2>(boxes, nullptr, never)))) << count;
    space->trim();
    return space->bytes();
  };
  const std::size_t large = join(30000);
  EXPECT_LE(large, 30000u * 128);
  EXPECT_EQ(join(30000), large);
  EXPECT_LT(join(1000), large / 4);
  EXPECT_EQ(join(30000), large);
}

}  // namespace
}  // namespace foresee::testing
