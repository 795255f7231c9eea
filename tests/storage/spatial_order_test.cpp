#include "storage/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace foresee {
namespace {

double path_length(const std::vector<double>& xy, const std::vector<std::uint32_t>& order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    length +=
        std::hypot(xy[2 * order[i]] - xy[2 * order[i - 1]], xy[2 * order[i] + 1] - xy[2 * order[i - 1] + 1]);
  return length;
}

TEST(SpatialOrder, VisitsEveryRowOnceForEveryNumberOfAxes) {
  std::mt19937 random(1);
  for (int axes = 1; axes <= 3; ++axes)
    for (std::size_t count : {0, 1, 2, 3, 1000}) {
      std::vector<double> records(count * static_cast<std::size_t>(axes));
      for (double& x : records) x = static_cast<double>(random());
      auto order = spatial_order({.axes = axes}, records.data(), count);
      std::sort(order.begin(), order.end());
      ASSERT_EQ(order.size(), count);
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(order[i], i);
    }
}

TEST(SpatialOrder, OneAxisIsSorted) {
  const std::vector<double> x{3, -1e308, 1e308, 0, -0.5};
  EXPECT_EQ(spatial_order({.axes = 1}, x.data(), x.size()), (std::vector<std::uint32_t>{1, 4, 3, 0, 2}));
}

TEST(SpatialOrder, KeepsNeighboursTogetherInSpiteOfOutliers) {
  std::mt19937 random(2);
  std::vector<double> xy(2 * 4000);
  for (double& x : xy) x = static_cast<double>(random() % 1000);
  xy[0] = 1e300;
  xy[3] = -1e300;
  auto order = spatial_order({.axes = 2}, xy.data(), 4000);
  std::erase_if(order, [](std::uint32_t row) { return row < 2; });
  std::vector<std::uint32_t> as_stored(order);
  std::sort(as_stored.begin(), as_stored.end());
  EXPECT_LT(path_length(xy, order), path_length(xy, as_stored) / 15);
}

}  // namespace
}  // namespace foresee
