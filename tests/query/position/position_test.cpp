#include <gtest/gtest.h>

#include "base/error.h"
#include "query/position/positions.h"

namespace foresee {
namespace {

std::shared_ptr<Scene> scene_of(const Layout& layout, std::vector<std::int64_t> ids,
                                std::vector<double> rows) {
  auto scene = std::make_shared<Scene>();
  *scene = {"ships", layout, std::move(ids), std::move(rows)};
  return scene;
}

const Layout lifetimes{.axes = 1, .law = Law::uniform, .has_t = true, .has_until = true};

TEST(Positions, GiveEveryObjectThatExistsAtTheTime) {
  const auto scene = scene_of(lifetimes, {7, 8, 9},
                              {0, 1, 2, 10,     // gone after 10
                               0, 1, 3, 100,    //
                               50, 0, 0, 90});  // not yet there at 12
  Positions positions(scene, 12);
  const auto row = positions.next();
  ASSERT_TRUE(row);
  EXPECT_EQ(row->id, 8);
  EXPECT_EQ(row->x[0], 37);
  EXPECT_EQ(row->v[0], 3);
  EXPECT_FALSE(positions.next());
  EXPECT_FALSE(positions.next());
}

TEST(Positions, IncludeBothEndsOfALife) {
  const auto scene = scene_of(lifetimes, {7}, {0, 1, 2, 10});
  EXPECT_TRUE(Positions(scene, 0).next());
  EXPECT_TRUE(Positions(scene, 10).next());
  EXPECT_FALSE(Positions(scene, 10.5).next());
  EXPECT_FALSE(Positions(scene, -0.5).next());
}

TEST(Positions, FollowAccelerationOnEveryAxis) {
  const Layout layout{.axes = 3, .law = Law::accelerated};
  const auto row = Positions(scene_of(layout, {1}, {1, 2, 3, 10, 20, 30, 2, -2, 4}), 3).next();
  ASSERT_TRUE(row);
  EXPECT_EQ(row->x, (std::array<double, 3>{1 + 30 + 9, 2 + 60 - 9, 3 + 90 + 18}));
  EXPECT_EQ(row->v, (std::array<double, 3>{16, 14, 42}));
}

TEST(Positions, RefuseATimeThatIsNotFinite) {
  const auto scene = scene_of(lifetimes, {}, {});
  EXPECT_THROW(Positions(scene, std::numeric_limits<double>::infinity()), Error);
  EXPECT_FALSE(Positions(scene, 1).next());
}

}  // namespace
}  // namespace foresee
