#include "shape/outline/outline.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "shape/outline/convex_pieces.h"
#include "shape/outline/outline_rotation.h"
#include "shape/outline/test_outlines.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"

#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#endif

namespace foresee {
namespace {

TEST(Outline, KnowsItsRingsAndParts) {
  const Outline outline =
      outline_of_parts({{{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}, {2, 1}, {1, 2}}}, {{{20, 0}, {29, 0}, {20, 9}}}});
  EXPECT_EQ(outline.parts(), 2u);
  EXPECT_EQ(outline.rings(), 3u);
  EXPECT_EQ(outline.part_start(0), 0u);
  EXPECT_EQ(outline.part_start(1), 2u);
  EXPECT_EQ(outline.part_start(2), 3u);
  EXPECT_EQ(outline.ring_start(1), 3u);
  EXPECT_EQ(outline.ring(1).front(), (Corner{1, 1}));
}

TEST(Outline, ExtentsNeedNotHoldThePosition) {
  const Extents<2> extents = outline_of({{{5, -7}, {9, -6}, {6, -2}}}).extents();
  EXPECT_TRUE((extents.lower == Vec<2>{5, -7}).all());
  EXPECT_TRUE((extents.upper == Vec<2>{9, -2}).all());
}

TEST(Outline, OfEqualContentIsEqual) {
  EXPECT_EQ(outline_of({{{0, 0}, {0, 0}, {1, -0.0}, {0, 1}, {0, 0}}}),
            outline_of({{{0, 0}, {1, 0}, {0, 1}}}));
  EXPECT_NE(outline_of({{{0, 0}, {1, 0}, {0, 1}}}), outline_of({{{1, 0}, {0, 1}, {0, 0}}}));
  EXPECT_NE(outline_of({{{0, 0}, {9, 0}, {0, 9}}, {{1, 1}, {2, 1}, {1, 2}}}),
            outline_of_parts({{{{0, 0}, {9, 0}, {0, 9}}}, {{{1, 1}, {2, 1}, {1, 2}}}}));
}

struct AllAbout {
  std::string text, turned_text;
  std::vector<Corner> corners;  ///< of the pieces

  friend bool operator==(const AllAbout&, const AllAbout&) = default;
};

/// Everything that is computed about an outline.
AllAbout all_about(const std::string& text) {
  const Outline outline = read_outline(text), posed = turned(outline, 37.3);
  check_outline(outline);
  check_turned(outline, edge_touch_of(outline), posed, 37.3);
  AllAbout all{write_outline(outline), write_outline(posed), {}};
  const ConvexPieces pieces = turned_pieces(convex_pieces(outline), posed);
  for (std::size_t p = 0; p < pieces.count(); ++p)
    all.corners.insert(all.corners.end(), pieces.corners(p).begin(), pieces.corners(p).end());
  return all;
}

TEST(Outline, IsTheSameInAnyFloatingPointEnvironment) {
  std::mt19937_64 random(61);
  for (const Outline& outline :
       {random_star(random, 100), scaled(random_star(random, 20), -1040), comb(20)}) {
    const std::string text = write_outline(outline);
    const AllAbout expected = all_about(text);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const AllAbout found = all_about(text);
      std::fesetround(FE_TONEAREST);
      EXPECT_TRUE(found == expected);
    }
#ifdef __SSE2_MATH__
    const unsigned control = _mm_getcsr();
    _mm_setcsr(control | 0x8040);  // subnormal numbers become 0
    const AllAbout found = all_about(text);
    _mm_setcsr(control);
    EXPECT_TRUE(found == expected);
#endif
  }
}

}  // namespace
}  // namespace foresee
