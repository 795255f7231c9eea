// The cache of extents rotates a form once for many rows.
#include "shape/extents_cache.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

struct Counted final : Form {
  Shape shape() const override { return Shape::outline; }
  std::size_t corners() const override { return 3; }
  std::string text() const override { return ""; }
  Extents<3> extents(double heading) const override {
    ++turned;
    Extents<3> around = Extents<3>::none();
    around.lower[0] = heading;
    return around;
  }
  mutable int turned = 0;
};

TEST(ExtentsCache, TurnAFormOnceForAllRowsOfAHeading) {
  const Counted one, other;
  ExtentsCache known;
  for (int row = 0; row < 1000; ++row) {
    EXPECT_EQ(known.of(1, one, row % 10).lower[0], row % 10);
    EXPECT_EQ(known.of(2, other, row % 10).lower[0], row % 10);
  }
  EXPECT_EQ(one.turned, 10);
  EXPECT_EQ(other.turned, 10);
}

TEST(ExtentsCache, OfMoreHeadingsThanAreKeptAreComputedAgain) {
  const Counted form;
  ExtentsCache known;
  for (int round = 0; round < 2; ++round)
    for (int row = 0; row < 70'000; ++row) ASSERT_EQ(known.of(1, form, row / 1024.0).lower[0], row / 1024.0);
  EXPECT_GT(form.turned, 70'000);
}

}  // namespace
}  // namespace foresee
