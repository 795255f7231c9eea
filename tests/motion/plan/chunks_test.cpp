// The moving box of a chunk contains its legs at every time, by exact arithmetic; the rules by which chunks end.
#include "motion/plan/chunks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/plan/random_legs.h"

namespace foresee {
namespace {

/// Whether |X + V s + a s^2 / 2| <= half for all s of [0, S], or all s >= 0 for an infinite S.
bool is_within(const Dyadic& x, const Dyadic& v, const Dyadic& a, const Dyadic& half, const Leg& leg) {
  const auto within = [&](const Dyadic& value) { return value <= half && -value <= half; };
  if (!within(x)) return false;
  if (!std::isfinite(leg.until)) return v.sign() == 0 && a.sign() == 0;
  const Dyadic s = Dyadic(leg.until) - Dyadic(leg.t);
  if (!within(x + s * (v + half_of(s * a)))) return false;
  if (a.sign() == 0 || (-v).sign() != a.sign()) return true;
  const Dyadic size = a.sign() > 0 ? a : -a, turn = a.sign() > 0 ? -v : v;  // it turns at turn / size
  if (turn >= s * size) return true;
  const Dyadic far = x * size.scaled(1) - (a.sign() > 0 ? v * v : -(v * v));  // its place there, times 2 |a|
  return far <= half * size.scaled(1) && -far <= half * size.scaled(1);
}

::testing::AssertionResult contains(const ChunkBox& box, const Leg& leg, std::size_t axis) {
  if (box.half[axis] == no_end) return ::testing::AssertionSuccess();
  const Dyadic since = Dyadic(leg.t) - Dyadic(box.t), bv(box.v[axis]);
  const Dyadic x = Dyadic(leg.x[axis]) - (Dyadic(box.x[axis]) + bv * since), v = Dyadic(leg.v[axis]) - bv;
  if (is_within(x, v, Dyadic(leg.a[axis]), Dyadic(box.half[axis]), leg)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << std::hexfloat << "box " << box.t << ": " << box.x[axis] << " + " << box.v[axis] << " +- "
         << box.half[axis] << ", leg " << leg.t << " to " << leg.until << ": " << leg.x[axis] << ", "
         << leg.v[axis] << ", " << leg.a[axis];
}

TEST(Chunks, ContainTheirLegs) {
  judge::Inputs inputs(11);
  int bounded = 0, boxes = 0;
  for (int i = judge::cases(3000); i > 0; --i) {
    const bool wild = inputs.one_in(3);
    const std::vector<Leg> legs = testing::random_legs(inputs, inputs.between(1, 40), inputs.one_in(2), wild);
    std::size_t next = 0;
    for (const ChunkRange& range : cut_into_chunks(legs)) {
      ASSERT_EQ(range.first, next);
      ASSERT_GE(range.count, 1u);
      ASSERT_LE(range.count, legs_per_chunk);
      next += range.count;
      const auto own = std::span(legs).subspan(range.first, range.count);
      const ChunkBox box = chunk_box(own, 3);
      ASSERT_EQ(box.t, own.front().t);
      ASSERT_EQ(box.until, own.back().until);
      for (std::size_t j = 0; j < 3; ++j) {
        ASSERT_TRUE(std::isfinite(box.x[j]) && std::isfinite(box.v[j]) && box.half[j] >= 0);
        bounded += box.half[j] != no_end, ++boxes;
        for (const Leg& leg : own) ASSERT_TRUE(contains(box, leg, j));
      }
    }
    ASSERT_EQ(next, legs.size());
  }
  EXPECT_GT(bounded, boxes * 8 / 10);
}

/// A box is not much larger than its legs need.
TEST(Chunks, AreTight) {
  const std::vector<Leg> straight = {{0, 10, {0, 0}, {1, 0}, {}}, {10, 20, {10, 0}, {1, 0}, {}}};
  const ChunkBox along = chunk_box(straight, 2);
  EXPECT_NEAR(along.v[0], 1, 1e-12);
  EXPECT_LT(along.half[0], 1e-12);
  const std::vector<Leg> bent = {{0, 10, {0, 0}, {1, 1}, {}}, {10, 20, {10, 10}, {1, -1}, {}}};
  const ChunkBox around = chunk_box(bent, 2);
  EXPECT_LT(around.half[0], 1e-12);
  EXPECT_NEAR(around.half[1], 5, 1e-12);  // the chord is moved into the middle of the legs
  EXPECT_NEAR(around.x[1], 5, 1e-12);
  const std::vector<Leg> back = {{0, 10, {0, 0}, {1, 1}, {}}, {10, 16, {10, 10}, {-1, 1}, {}}};
  const ChunkBox resting = chunk_box(back, 2);
  EXPECT_EQ(resting.v[0], 0);  // its chord would make it 7.5 wide instead of 10
  EXPECT_NEAR(resting.half[0], 5, 1e-12);
  EXPECT_NEAR(resting.v[1], 1, 1e-12);
}

TEST(Chunks, OfOneLegAreItsPath) {
  const std::vector<Leg> legs = {{3, no_end, {1, 2, 3}, {4, 5, 6}, {}}};
  const ChunkBox box = chunk_box(legs, 3);
  EXPECT_EQ(box.x, legs[0].x);
  EXPECT_EQ(box.v, legs[0].v);
  EXPECT_EQ(box.half, (std::array<double, 3>{}));
  const std::vector<Leg> bent = {{3, no_end, {1, 2, 3}, {4, 5, 6}, {0, 1, 0}}};
  EXPECT_EQ(chunk_box(bent, 3).half, (std::array<double, 3>{0, no_end, 0}));
}

std::vector<std::size_t> counts(const std::vector<Leg>& legs) {
  std::vector<std::size_t> counts;
  for (const ChunkRange& range : cut_into_chunks(legs)) counts.push_back(range.count);
  return counts;
}

TEST(Chunks, AreOfEquallyManyLegsBetweenJumpsAndGapsAndBeforeALegWithoutEnd) {
  std::vector<Leg> legs;
  for (int i = 0; i < 40; ++i) legs.push_back({10.0 * i, 10.0 * i + 10, {10.0 * i}, {1}, {}});
  EXPECT_EQ(counts(legs), (std::vector<std::size_t>{13, 13, 14}));
  std::vector<Leg> jump = legs;
  for (std::size_t i = 5; i < 40; ++i) jump[i].x[1] = 51;  // 50 long so far
  EXPECT_EQ(counts(jump), (std::vector<std::size_t>{5, 11, 12, 12}));
  for (std::size_t i = 5; i < 40; ++i) jump[i].x[1] = 49;
  EXPECT_EQ(counts(jump), (std::vector<std::size_t>{13, 13, 14}));
  std::vector<Leg> gap = legs;
  for (std::size_t i = 5; i < 40; ++i) gap[i].t += 51, gap[i].until += 51;
  EXPECT_EQ(counts(gap), (std::vector<std::size_t>{5, 11, 12, 12}));
  std::vector<Leg> endless = legs;
  endless.resize(6);
  endless[5].until = no_end;
  EXPECT_EQ(counts(endless), (std::vector<std::size_t>{5, 1}));
  std::vector<Leg> late = legs;
  for (std::size_t i = 32; i < 40; ++i) late[i].x[1] = 161;  // its last 16 legs are 160 long
  EXPECT_EQ(counts(late), (std::vector<std::size_t>{16, 16, 8}));
}

}  // namespace
}  // namespace foresee
