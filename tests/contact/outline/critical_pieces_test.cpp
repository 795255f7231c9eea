// The pieces that the exact stage takes.
#include "contact/outline/critical_pieces.h"

#include <gtest/gtest.h>

#include "contact/pair_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

TEST(CriticalPieces, HaveStripsAndDiscsOnlyWhereTheyAreGrown) {
  const Object disc = object(2, Shape::ball);
  const std::vector<double> row = disc.row();
  const foresee::Setup setup{{disc.layout, row.data(), 1},
                             {disc.layout, row.data(), 1},
                             {0, 10},
                             PairRule(disc.layout, disc.layout)};
  ObjectPieces a, b;
  a.take_box(1, 1), b.take_point();
  const PiecePair pair{0, 0};
  EXPECT_EQ(critical_pieces(setup, a, b, {&pair, 1}, false).set.pieces().size(), 1u);
  EXPECT_EQ(critical_pieces(setup, a, b, {&pair, 1}, true).set.pieces().size(), 9u);
}

}  // namespace
}  // namespace foresee
