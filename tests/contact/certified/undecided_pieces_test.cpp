// The constraints that the exact stage reads of two pieces in the plane.
#include <gtest/gtest.h>

#include "contact/certified/exact_union.h"
#include "contact/outline/flat_traits.h"
#include "contact/pair_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// Of a box and a point: the numbers of parts and of constraints.
template <int D>
std::pair<std::size_t, std::size_t> counts(Shape shape, bool grown) {
  const Object object = testing_by_hand::object(D, shape);
  const std::vector<double> row = object.row();
  const foresee::Setup setup{{object.layout, row.data(), 1},
                             {object.layout, row.data(), 1},
                             {0, 10},
                             PairRule(object.layout, object.layout)};
  ObjectPieces a, b;
  a.take_box(1, 1);
  b.take_point();
  const PiecePair pair{0, 0};
  const UndecidedPieces<FlatTraits<D, 1>> all(setup, row.data(), row.data(), a, b, {&pair, 1}, grown);
  EXPECT_EQ(all.ends().back(), all.pieces().size());
  return {all.pieces().size(), all.constraint_count()};
}

TEST(UndecidedPieces, HaveSlabsAndBallsOnlyWhereTheyAreGrown) {
  EXPECT_EQ(counts<2>(Shape::ball, false), std::make_pair(std::size_t{1}, std::size_t{4}));
  EXPECT_EQ(counts<2>(Shape::ball, true), std::make_pair(std::size_t{9}, std::size_t{20}));
}

TEST(UndecidedPieces, OfPrismsShareTheirTwoFacesAlongZ) {
  EXPECT_EQ(counts<3>(Shape::cylinder, false), std::make_pair(std::size_t{1}, std::size_t{6}));
  EXPECT_EQ(counts<3>(Shape::cylinder, true), std::make_pair(std::size_t{9}, std::size_t{22}));
}

}  // namespace
}  // namespace foresee
