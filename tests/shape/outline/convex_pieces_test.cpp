// Convex pieces, checked in rational numbers: they are convex, do not overlap, and their union is the
// outline.
#include "shape/outline/convex_pieces.h"

#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <utility>

#include "contact/case_count.h"
#include "shape/outline/outline_judge.h"
#include "shape/outline/outline_rotation.h"
#include "shape/outline/test_outlines.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

using testing_by_hand::scaled_count;

using Edge = std::pair<Corner, Corner>;

struct EdgeOrder {
  bool operator()(const Edge& a, const Edge& b) const {
    return std::tuple(a.first.x, a.first.y, a.second.x, a.second.y) <
           std::tuple(b.first.x, b.first.y, b.second.x, b.second.y);
  }
};

bool is_convex(const RationalRing& ring) {
  int bends = 0, reversals = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RationalPoint &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
    const int side = side_of(a, b, c);
    if (side < 0) return false;
    bends += side;
    const auto rightwards = [](const auto& p, const auto& q) {
      return p.x < q.x || (p.x == q.x && p.y < q.y);
    };
    reversals += rightwards(a, b) != rightwards(b, c);
  }
  return bends >= 3 && reversals == 2;
}

/// Whether some edge of `a` has all of `b` to its right.
bool parted_by_edge(const RationalRing& a, const RationalRing& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::all_of(b.begin(), b.end(), [&](const RationalPoint& corner) {
          return side_of(a[i], a[(i + 1) % a.size()], corner) <= 0;
        }))
      return true;
  return false;
}

std::vector<RationalRing> rings_of(const ConvexPieces& pieces) {
  std::vector<RationalRing> rings;
  for (std::size_t p = 0; p < pieces.count(); ++p) rings.push_back(exact(pieces.corners(p)));
  return rings;
}

/// Convex, of the outline's area all in all, and none over another.
void expect_tiling(const ConvexPieces& pieces, const Outline& outline) {
  Rational area = 0;
  const std::vector<RationalRing> rings = rings_of(pieces);
  for (const RationalRing& ring : rings) {
    EXPECT_TRUE(is_convex(ring));
    area += twice_area(ring);
  }
  EXPECT_EQ(area, twice_area(outline)) << write_outline(outline);
  for (std::size_t i = 0; i < rings.size() && rings.size() < 60; ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_TRUE(parted_by_edge(rings[i], rings[j]) || parted_by_edge(rings[j], rings[i]));
}

/// Every inner edge is one of two pieces, and every other lies on the outline.
void expect_edges(const ConvexPieces& pieces, const Outline& outline) {
  std::map<Edge, int, EdgeOrder> inner;
  for (std::size_t p = 0; p < pieces.count(); ++p) {
    const auto corners = pieces.corners(p);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const RationalPoint middle{(Rational(a.x) + b.x) / 2, (Rational(a.y) + b.y) / 2};
      EXPECT_EQ(where(middle, outline), pieces.inner(p)[i] ? Where::inside : Where::boundary)
          << write_outline(outline);
      if (pieces.inner(p)[i]) ++inner[{a, b}], --inner[{b, a}];
    }
  }
  for (const auto& [edge, balance] : inner) EXPECT_EQ(balance, 0);
}

void expect_points(const ConvexPieces& pieces, const Outline& outline, std::mt19937_64& random) {
  const std::vector<RationalRing> rings = rings_of(pieces);
  const Extents<2> around = outline.extents();
  for (int i = 0; i < 10; ++i) {
    const auto coordinate = [&](int axis) {
      return Rational(around.lower[axis]) +
             (Rational(around.upper[axis]) - around.lower[axis]) * static_cast<int>(random() % 25) / 24;
    };
    const RationalPoint point{coordinate(0), coordinate(1)};
    const bool in_piece = std::any_of(rings.begin(), rings.end(), [&](const RationalRing& ring) {
      return where(point, ring) != Where::outside;
    });
    EXPECT_EQ(in_piece, where(point, outline) != Where::outside) << write_outline(outline);
  }
}

void expect_tree(const ConvexPieces& pieces) {
  const BoxTree<2>& tree = pieces.tree();
  ASSERT_EQ(tree.items(), pieces.count());
  for (std::size_t p = 0; p < pieces.count(); ++p)
    for (const Corner& corner : pieces.corners(p)) {
      const Vec<2> at{corner.x, corner.y};
      EXPECT_TRUE((pieces.bounds(p).lower <= at).all() && (at <= pieces.bounds(p).upper).all());
    }
}

void expect_cut(const Outline& outline, std::mt19937_64& random) {
  const ConvexPieces pieces = convex_pieces(outline);
  expect_tiling(pieces, outline);
  expect_edges(pieces, outline);
  expect_points(pieces, outline, random);
  expect_tree(pieces);
}

TEST(ConvexPieces, AConvexOutlineIsOnePieceInEitherDirection) {
  for (const char* text : {"POLYGON((0 0, 4 0, 4 4, 0 4, 0 0))", "POLYGON((0 0, 0 4, 4 4, 4 0, 2 0, 0 0))"}) {
    const ConvexPieces pieces = convex_pieces(read_outline(text));
    ASSERT_EQ(pieces.count(), 1u);
    EXPECT_TRUE(is_convex(exact(pieces.corners(0))));
    for (const auto inner : pieces.inner(0)) EXPECT_EQ(inner, 0);
  }
}

TEST(ConvexPieces, AnAngleIsTwoPiecesWithACutBetween) {
  const ConvexPieces pieces = convex_pieces(read_outline("POLYGON((0 0, 4 0, 4 1, 1 1, 1 4, 0 4, 0 0))"));
  ASSERT_EQ(pieces.count(), 2u);
  EXPECT_EQ(std::count(pieces.inner(0).begin(), pieces.inner(0).end(), 1), 1);
  EXPECT_EQ(std::count(pieces.inner(1).begin(), pieces.inner(1).end(), 1), 1);
}

TEST(ConvexPieces, AreTheOutlineOfRingsOnAGrid) {
  std::mt19937_64 random(11);
  const int cases = scaled_count(600);
  int holes = 0;
  for (int cut = 0; cut < cases;) {
    const Outline outline = random_rings(random);
    if (flaw_of(outline)) continue;
    expect_cut(outline, random);
    ++cut, holes += outline.rings() > outline.parts();
  }
  EXPECT_GT(holes, cases / 10);
}

TEST(ConvexPieces, AreTheOutlineOfCells) {
  std::mt19937_64 random(12);
  for (int cut = 0; cut < scaled_count(60);) {
    const Outline outline = random_cells(random);
    if (flaw_of(outline)) continue;
    expect_cut(outline, random);
    ++cut;
  }
}

TEST(ConvexPieces, AreTheOutlineAnUlpApartAtAllScales) {
  std::mt19937_64 random(13);
  for (int cut = 0; cut < scaled_count(300);) {
    const Outline outline = shaken(scaled(moved(random_rings(random),
                                                [](const Corner& c) {
                                                  return Corner{c.x / 3, c.y + 0.7};
                                                }),
                                          static_cast<int>(random() % 500) - 300),
                                   random);
    if (flaw_of(outline)) continue;
    expect_cut(outline, random);
    ++cut;
  }
}

TEST(ConvexPieces, AreTheOutlineOfCombsSpiralsStarsAndChains) {
  std::mt19937_64 random(14);
  for (const Outline& outline : {comb(9), spiral(5), random_star(random, 50), chain_of_holes(6)}) {
    expect_cut(outline, random);
    for (int i = 0; i < 3; ++i)
      if (const Outline close = shaken(outline, random); !flaw_of(close)) expect_cut(close, random);
  }
}

TEST(ConvexPieces, AreTheOutlineOfAThousandCorners) {
  std::mt19937_64 random(19);
  for (const Outline& outline : {comb(500), spiral(125), random_star(random, 1000), chain_of_holes(250)})
    expect_tiling(convex_pieces(outline), outline);
}

/// Whether the ring of the piece, where its corner i is the end of the other's edge, turns right at that
/// corner when it goes on along the other.
bool bends_in(std::span<const Corner> piece, std::size_t i, std::span<const Corner> other, std::size_t edge) {
  const Corner &before = piece[(i + piece.size() - 1) % piece.size()],
               &after = other[(edge + 2) % other.size()];
  return side_of(exact(before), exact(piece[i]), exact(after)) < 0;
}

/// At most four times the minimal number of pieces, as Hertel and Mehlhorn prove if no cut can be removed.
TEST(ConvexPieces, NoCutCouldBeSpared) {
  std::mt19937_64 random(15);
  for (const Outline& outline : {random_star(random, 100), comb(30), spiral(6), chain_of_holes(9)}) {
    const ConvexPieces pieces = convex_pieces(outline);
    std::map<Edge, std::pair<std::size_t, std::size_t>, EdgeOrder> cuts;
    const auto for_cuts = [&](auto&& use) {
      for (std::size_t p = 0; p < pieces.count(); ++p)
        for (std::size_t i = 0; i < pieces.corners(p).size(); ++i)
          if (pieces.inner(p)[i])
            use(p, i, pieces.corners(p)[i], pieces.corners(p)[(i + 1) % pieces.corners(p).size()]);
    };
    for_cuts([&](std::size_t p, std::size_t i, const Corner& a, const Corner& b) { cuts[{a, b}] = {p, i}; });
    for_cuts([&](std::size_t p, std::size_t i, const Corner& a, const Corner& b) {
      const auto [other, j] = cuts.at({b, a});
      EXPECT_TRUE(bends_in(pieces.corners(p), i, pieces.corners(other), j) ||
                  bends_in(pieces.corners(other), j, pieces.corners(p), i));
    });
  }
}

TEST(ConvexPieces, OfATurnedOutlineAreCutAlike) {
  std::mt19937_64 random(16);
  for (int i = 0; i < 20; ++i) {
    const Outline outline = random_star(random, 30);
    const ConvexPieces pieces = convex_pieces(outline);
    for (const double heading : {0.0, 37.5, 90.0, 211.0}) {
      const Outline posed = turned(outline, heading);
      const ConvexPieces rotated = turned_pieces(pieces, posed);
      EXPECT_EQ(rotated.cut(), pieces.cut());
      expect_tiling(rotated, posed);
    }
  }
}

TEST(ConvexPieces, OfATurnedOutlineAreCutAgainWhereRoundingBrokeOne) {
  // The middle of the lower edge lies on it, but not after most turns.
  const Outline outline = read_outline("POLYGON((0 0, 1 0, 3 0, 3 7, 2 3, 0 9, 0 0))");
  const ConvexPieces pieces = convex_pieces(outline);
  std::mt19937_64 random(17);
  int cut_again = 0;
  for (int heading = 1; heading < 90; ++heading) {
    const Outline posed = turned(outline, heading);
    const ConvexPieces rotated = turned_pieces(pieces, posed);
    expect_tiling(rotated, posed);
    expect_edges(rotated, posed);
    cut_again += rotated.cut() != pieces.cut();
  }
  EXPECT_GT(cut_again, 10);
}

TEST(ConvexPieces, OfATurnedOutlineAreCutAgainWhereCornersBecameOne) {
  const Outline outline = read_outline("POLYGON((0 0, 100 0, 100 1e-30, 1 1, 0 100, 0 0))");
  const Outline posed = turned(outline, 20);
  ASSERT_LT(posed.corners().size(), outline.corners().size());
  expect_tiling(turned_pieces(convex_pieces(outline), posed), posed);
}

TEST(ConvexPieces, OfATurnedOutlineAreCutAgainWhereRoundingTurnedAHoleInsideOut) {
  // The hole is so flat that a rotation may reverse its direction.
  const Outline outline = read_outline(
      "POLYGON((0 0, 5 0, 5 5, 0 5, 0 0), "
      "(4 1, 3.9999999999999996 1, 1.0000000000000002 1.0000000000000002, 4 1))");
  const ConvexPieces pieces = convex_pieces(outline);
  int cut_again = 0;
  for (double heading = 0.25; heading < 90; heading += 0.25) {
    const Outline posed = turned(outline, heading);
    if (flaw_of(posed)) continue;
    const ConvexPieces rotated = turned_pieces(pieces, posed);
    expect_tiling(rotated, posed);
    cut_again += rotated.cut() != pieces.cut();
  }
  EXPECT_GT(cut_again, 5);
}

TEST(ConvexPieces, OfTheMaximumOfCornersTakeNoLongerThanOthers) {
  std::mt19937_64 random(18);
  const Outline slanted = moved(comb(32767), [](const Corner& c) {
    return Corner{c.x * 1000 + c.y, c.x * 1000 - c.y};
  });
  for (const Outline& outline :
       {random_star(random, 65536), comb(32767), slanted, spiral(8192), chain_of_holes(16382)}) {
    const auto begin = std::chrono::steady_clock::now();
    const ConvexPieces pieces = convex_pieces(outline);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    EXPECT_GT(pieces.count(), 10000u);
  }
}

}  // namespace
}  // namespace foresee
