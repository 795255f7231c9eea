#include "query/position/tracks.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace foresee {
namespace {

std::shared_ptr<const Scene> moved(std::vector<std::int64_t> ids, std::vector<double> rows) {
  auto scene = std::make_shared<Scene>();
  const Layout layout{.axes = 1, .law = Law::uniform, .has_t = true, .has_until = true};
  *scene = {"ships", layout, std::move(ids), std::move(rows)};
  return scene;
}

struct TrackedRow {
  double t;
  std::int64_t id;
  double x;
  bool operator==(const TrackedRow&) const = default;
};

std::vector<TrackedRow> all_of(const std::shared_ptr<const Scene>& scene, const TrackTimes& lifetime) {
  NeverInterrupt never;
  Tracks tracks(scene, lifetime, never);
  std::vector<TrackedRow> rows;
  while (const auto row = tracks.next()) rows.push_back({row->t, row->at.id, row->at.x[0]});
  EXPECT_FALSE(tracks.next());
  return rows;
}

std::vector<double> times_of(const TrackTimes& lifetime) {
  std::vector<double> all;
  for (const auto& row : all_of(moved({1}, {-1e18, 0, 0, 1e18}), lifetime)) all.push_back(row.t);
  return all;
}

TEST(Tracks, ComeByTimeThenById) {
  const auto scene = moved({9, -3}, {0, 1, 2, 10,    // 9 is gone after 10
                                     5, 0, 1, 99});  // -3 starts at 5
  EXPECT_EQ(
      all_of(scene, {4, 11, 3}),
      (std::vector<TrackedRow>{{4, 9, 9}, {7, -3, 2}, {7, 9, 15}, {10, -3, 5}, {10, 9, 21}, {11, -3, 6}}));
  EXPECT_EQ(all_of(moved({}, {}), {0, 1e15, 1}).size(), 0u);
}

TEST(Tracks, EndAtT1WhateverTheStep) {
  EXPECT_EQ(times_of({0, 6, 3}), (std::vector<double>{0, 3, 6}));
  EXPECT_EQ(times_of({0, 7, 3}), (std::vector<double>{0, 3, 6, 7}));
  EXPECT_EQ(times_of({0, 7, 1e300}), (std::vector<double>{0, 7}));
  EXPECT_EQ(times_of({7, 7, 3}), (std::vector<double>{7}));
}

TEST(Tracks, RoundEachTimeOnce) {
  // 3 * 0.1 is 0.30000000000000004 in doubles; 1 + 3 * (the double 0.1), rounded once, is 1.3.
  EXPECT_EQ(times_of({1, 1.4, 0.1}), (std::vector<double>{1, 1.1, 1.2, 1.3, 1.4}));
  const auto fine = times_of({0, 1, 0.1});
  EXPECT_EQ(fine[3], 0.1 * 3);
  EXPECT_EQ(fine.size(), 11u);
  for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto same = times_of({0, 1, 0.1});
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(same, fine) << "whatever the host's rounding is";
  }
}

TEST(Tracks, GiveTimesThatRoundAlikeOnce) {
  EXPECT_EQ(times_of({0x1p53, 0x1p53 + 4, 0.75}), (std::vector<double>{0x1p53, 0x1p53 + 2, 0x1p53 + 4}));
}

TEST(Tracks, SkipTheStepsThatRoundToTheSameTime) {
  // Each time is t0 + i step, rounded once, for every i: as many steps as that, and no more, may be skipped.
  for (const double t0 : {1e9, -1e9, 0x1p53 - 3, 1.0, -1.0, 0.0, 5e-324})
    for (const double share : {0.3, 0.01, 0.0007, 1 / 3.0, 0x1p-9, 1.7}) {
      const double ulp = std::nextafter(std::abs(t0), 1e300) - std::abs(t0);
      const TrackTimes lifetime{t0, t0 + 7 * ulp, std::max(share * ulp, 5e-324)};
      std::vector<double> expected{t0};
      for (double i = 1; expected.back() < lifetime.t1; ++i) {
        const double t = std::min(std::fma(i, lifetime.step, t0), lifetime.t1);
        if (t != expected.back()) expected.push_back(t);
      }
      EXPECT_EQ(times_of(lifetime), expected) << t0 << " " << share;
    }
  EXPECT_EQ(times_of({1e9, 1e9 + 1e-6, 1e-14}).size(), 9u) << "of a hundred million steps";
  EXPECT_EQ(times_of({5, 5, 1e-320}), (std::vector<double>{5}));
}

TEST(Tracks, RefuseArgumentsThatGiveNoTimes) {
  const auto scene = moved({1}, {0, 0, 0, 1});
  const double inf = std::numeric_limits<double>::infinity();
  for (const TrackTimes lifetime : {TrackTimes{0, 1, 0}, TrackTimes{0, 1, -1}, TrackTimes{0, 1, inf},
                                    TrackTimes{1, 0, 1}, TrackTimes{0, inf, 1}, TrackTimes{-inf, 0, 1},
                                    TrackTimes{0, 1, 1e-300}, TrackTimes{-1e308, 1e308, 1e-5}}) {
    NeverInterrupt never;
    EXPECT_THROW(Tracks(scene, lifetime, never), Error)
        << lifetime.t0 << " " << lifetime.t1 << " " << lifetime.step;
  }
}

struct AtOnce final : Interrupt {
  void check() override { throw Interrupted(); }
};

TEST(Tracks, CheckForInterruptsWhereNothingExists) {
  AtOnce at_once;
  Tracks tracks(moved({1}, {0, 0, 0, 1}), {5, 1e15, 1}, at_once);
  EXPECT_THROW(tracks.next(), Interrupted);
}

}  // namespace
}  // namespace foresee
