// The clearance certificate by hand, and its planes between straight paths and convex sets.
#include "contact/clearance/separation.h"

#include <gtest/gtest.h>

#include "contact/clearance/blocked_range_end.h"
#include "contact/clearance/straight_approach.h"
#include "scenes.h"

namespace foresee {
namespace {

ClearanceVerdict verdict_of(const Encounter<2>& encounter, const TrajectoryFamily<2>& family) {
  return certify_clearance<2>(encounter, family).verdict;
}

using testing::Random;

TEST(StraightApproach, FindsTheNearestApproachAndAPlane) {
  Random random(6);
  int apart = 0;
  for (int i = 0; i < 4000; ++i) {
    GrowingExtents<3> extents{
        {{random.in(0, 2), random.in(0, 2), random.in(0, 2)}, random.in(0, 2), i % 2 ? 3 : 2}};
    if (i % 5 == 0) extents.half = Vec<3>::zero();
    if (i % 7 == 0) extents.radius = 0, extents.round_axes = 3;
    if (i % 3 == 0) {
      extents.grows = true;
      extents.growth = {{random.in(0, 0.2), 0, random.in(0, 0.2)}, random.in(0, 0.4), extents.round_axes};
    }
    const Vec<3> x{random.in(-9, 9), random.in(-9, 9), random.in(-9, 9)},
        v{random.in(-2, 2), random.in(-2, 2), random.in(-2, 2)};
    const double begin = random.in(0, 2), end = begin + random.in(0, 9);
    const auto near = straight_approach<3>(extents, x, v, begin, end);
    Vec<3> ignored;
    double min_gap = HUGE_VAL;
    for (int j = 0; j <= 1000; ++j) {
      const double tau = begin + (end - begin) * j / 1000;
      min_gap = std::min(min_gap, signed_distance<3>(extents.after(tau), x + tau * v, ignored));
    }
    EXPECT_LE(near.gap, min_gap + 0.05 * std::abs(min_gap) + 1e-9);
    if (min_gap <= 0.01) continue;
    ++apart;
    for (const double tau : {begin, end})
      EXPECT_GT((near.normal * (x + tau * v)).sum(), extents.after(tau).support(near.normal)) << i;
  }
  EXPECT_GT(apart, 1000);
}

struct Meeting {
  OwnMotion base;
  Encounter<2> encounter;

  Meeting() {
    base.v = {0, 10, 0};
    encounter = {{0, 1000}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {{{0, 0}, 20, 2}}, 0, 200};
  }
  ClearanceVerdict turn(double p, double q) const {
    return verdict_of(encounter, trajectory_family<2>(*changes_by(Manoeuvre::turn, base), p, q));
  }
};

TEST(Separation, DistinguishesClearBlockedAndOpen) {
  const Meeting stone;  // 1000 ahead, of radius 20: asin(0.02) is 1.146 degrees
  EXPECT_EQ(stone.turn(1.146, 180), ClearanceVerdict::clear);
  EXPECT_EQ(stone.turn(-180, -1.146), ClearanceVerdict::clear);
  EXPECT_EQ(stone.turn(-1.1459, 1.1459), ClearanceVerdict::blocked);
  EXPECT_EQ(stone.turn(1, 2), ClearanceVerdict::undecided);
  const auto gap = [&](double k) {
    return gap_of<2>(stone.encounter, *changes_by(Manoeuvre::turn, stone.base), k);
  };
  EXPECT_NEAR(*end_between(gap, 0, 9, 1e-11), 1.1459919983885926, 1e-10);
  EXPECT_FALSE(end_between(gap, 2, 9, 1e-11));
  // Touching at the change, the two separate if it turns away by more than a right angle.
  const auto separating = [&](double k) {
    return opening_rate_of<2>(stone.encounter, *changes_by(Manoeuvre::turn, stone.base), k);
  };
  EXPECT_NEAR(*end_between(separating, 0, 100, 1e-11), 90, 1e-10);
  EXPECT_FALSE(end_between(separating, 0, 89, 1e-11));
}

TEST(Separation, ProvesAWholeRangeBesideOneThatTouches) {
  const Meeting stone;
  const auto speeds = trajectory_family<2>(*changes_by(Manoeuvre::speed, stone.base), -10, -5.1000001);
  EXPECT_EQ(verdict_of(stone.encounter, speeds), ClearanceVerdict::clear);  // 980 in 200 s
  EXPECT_EQ(
      verdict_of(stone.encounter, trajectory_family<2>(*changes_by(Manoeuvre::speed, stone.base), -5, 10)),
      ClearanceVerdict::blocked);
}

/// Two ships, of which the own one turns with its course.
struct TurningShips {
  std::vector<Corner> own{{-4, -10}, {4, -10}, {4, 6}, {0, 10}, {-4, 6}}, other{{-3, -7}, {9, -2}, {-5, 20}};
  PieceSum sum{ConvexPiece{own, own.data(), nullptr}, ConvexPiece{other, other.data(), nullptr}};
  Encounter<2> encounter;
  TrajectoryEstimate<2> motion;

  explicit TurningShips(Random& random) {
    encounter.x = {random.in(-400, 400), random.in(-400, 400)};
    encounter.v = {random.in(-9, 9), random.in(-9, 9)};
    if (random.below(4) == 0) encounter.v = Vec<2>::zero();
    encounter.a = Vec<2>::zero(), encounter.ex = Vec<2>::zero(), encounter.ev = Vec<2>::zero();
    encounter.extents = {{{0, 0}, random.below(2) ? 0 : random.in(0, 60), 2, &sum}};
    encounter.begin = random.below(2) ? 0 : random.in(0, 20), encounter.end = 60;
    encounter.turning = &sum;
    motion = {{0, 0}, {random.in(-9, 9), random.in(-9, 9)}, {0, 0}, 0, 100};
  }

  double gap_at(double k) {
    sum.turn(k);
    const Turned v = quick_turned(motion.v[0], motion.v[1], k);
    return straight_approach<2>(encounter.extents, encounter.x, encounter.v - Vec<2>(v.x, v.y),
                                encounter.begin, encounter.end)
        .gap;
  }
};

TEST(TouchingTurns, TouchAndMostlyEndWhereTouchingEnds) {
  Random random(7);
  int found = 0, ended = 0;
  for (int i = 0; i < 4000; ++i) {
    TurningShips ships(random);
    for (const TouchingTurns& turns : touching_turns<2>(ships.encounter, ships.motion)) {
      const double width = turns.to - turns.from;
      ASSERT_GE(width, 0);
      ASSERT_LT(width, 360);
      for (int j = 0; j <= 20; ++j) ASSERT_LE(ships.gap_at(turns.from + width * j / 20), 1e-9) << i;
      for (const double k : {turns.from - 1e-7, turns.to + 1e-7}) ++found, ended += ships.gap_at(k) > 0;
    }
    // Whatever touches also touches the disc around all poses.
    ships.encounter.extents.radius += ships.sum.size();
    for (double k = -180; k < 180; k += 10) {
      const TurnsBetween around{quick_sine_cosine(k - 3), quick_sine_cosine(k + 2)};
      EXPECT_TRUE(ships.gap_at(k) > -ships.sum.size() ||
                  disc_may_touch<2>(ships.encounter, ships.motion, around));
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(ended, found * 2 / 3);
}

TEST(Separation, CertifiesNothingThatIsNotFinite) {
  Meeting far;
  far.encounter.x[0] = HUGE_VAL;
  EXPECT_EQ(far.turn(0, 1), ClearanceVerdict::blocked);
  far.encounter.x[0] = std::nan("");
  EXPECT_EQ(far.turn(0, 1), ClearanceVerdict::blocked);
}

TEST(SeparationIncrease, NeedsADistanceThatNeverShrinks) {
  Meeting beside;
  beside.encounter.x = {15, 0};
  const auto separating = [&](double p, double q) {
    return certify_separation_increases<2>(
               beside.encounter, trajectory_family<2>(*changes_by(Manoeuvre::turn, beside.base), p, q))
        .verdict;
  };
  EXPECT_EQ(separating(-179, -1), ClearanceVerdict::clear);
  EXPECT_EQ(separating(1, 179), ClearanceVerdict::blocked);
  EXPECT_EQ(separating(-1, 1), ClearanceVerdict::undecided);
}

}  // namespace
}  // namespace foresee
