// Avoidance against exact contact of single changes: clear rows are right, ends are tight, and a tree and a
// scene have the same rows. FORESEE_LONG=1: 200 times as many scenes.
#include "query/avoid/avoid.h"

#include <cstdlib>

#include "query/avoid/avoid_cases.h"
#include "stopping_interrupt.h"

namespace foresee {
namespace {

using testing::as_scene;
using testing::as_tree;
using testing::avoid_question;
using testing::expect_sound;
using testing::expect_tight;
using testing::is_clear;
using testing::never;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_of;
using testing::shifted;
using testing::text_of;
using testing::varied_layouts;

const int rounds = std::getenv("FORESEE_LONG") ? 200 : 1;

/// Any manoeuvre that the layout can have, with a range of its own.
void choose_changes(AvoidQuestion& question, Random& random) {
  const Layout& layout = question.own_scene->layout;
  std::vector<QueriedChanges> queried{{Manoeuvre::speed, -4, 4}};
  if (layout.axes > 1) queried.push_back({Manoeuvre::turn, -180, 180});
  if (layout.axes > 1) queried.push_back({Manoeuvre::turn, -360, 45});
  if (layout.axes > 2 && layout.law != Law::rest) queried.push_back({Manoeuvre::climb, -3, 3});
  if (layout.law == Law::accelerated || layout.law == Law::forced)
    queried.push_back({Manoeuvre::accelerate, -0.5, 0.5});
  if (layout.has_t) {
    const double t = question.record[static_cast<std::size_t>(record_offsets(layout).t)];
    // Earlier too, where nothing grows: from now on.
    const double lo = grows(layout) ? std::max(0.0, question.now - t) : question.now - t;
    queried.push_back({Manoeuvre::delay, lo, std::max(lo, question.now - t + 5)});
  }
  const QueriedChanges& one = queried[random.below(queried.size())];
  question.how = one.manoeuvre, question.lo = one.lo, question.hi = one.hi;
  question.touching = random.below(2) ? Touching::part : Touching::ignore;
}

TEST(Avoid, IsSoundAndTightAgainstSingleChanges) {
  Random random(1);
  for (int round = 0; round < rounds; ++round)
    for (const Layout& layout : varied_layouts()) {
      RandomScene scene = random_scene({.layout = layout, .count = 12, .seed = 7 + random.below(1 << 20)});
      if (random.below(4) == 0) scene = shifted(scene, 1.7e9);
      scene.h = random.below(8) == 0 ? 0 : random.in(1, 8);
      AvoidQuestion question = avoid_question(scene, random.below(scene.size()), as_scene(scene));
      choose_changes(question, random);
      SCOPED_TRACE(testing::name_of(layout) + " of object " + std::to_string(question.own_scene->ids[0]));
      const std::vector<AvoidRow> rows = rows_of(question);
      ASSERT_NO_FATAL_FAILURE(expect_sound(question, rows, random));
      if (question.touching == Touching::ignore) {
        ASSERT_NO_FATAL_FAILURE(expect_tight(question, rows, random));
      }
    }
}

TEST(Avoid, NamesBlockersOfTheShortestRange) {
  RandomScene scene = random_scene({.layout = {.axes = 2, .law = Law::uniform, .has_t = true}, .count = 2});
  scene.ids = {1, 2};
  scene.records = scene.rows = {0, 0, 0, 1, 0, 0, 10, 1 + 0x1p-52, 0, 0};
  scene.now = 0, scene.h = 20, scene.within = 1;
  AvoidQuestion question = avoid_question(scene, 0, as_scene(scene));
  question.how = Manoeuvre::speed, question.lo = 0, question.hi = 1e-320;
  EXPECT_FALSE(rows_of(question).empty());  // the first step from an end was 0, and so were all others
}

TEST(Avoid, GivesTheSameRowsFromATreeAndFromAScene) {
  Random random(2);
  for (int round = 0; round < rounds; ++round)
    for (const Layout& layout : varied_layouts()) {
      const RandomScene scene = random_scene({.layout = layout, .count = 60, .seed = random.below(1 << 20)});
      AvoidQuestion question = avoid_question(scene, random.below(scene.size()), as_scene(scene));
      choose_changes(question, random);
      const std::string plain = text_of(rows_of(question));
      question.others = as_tree(scene);
      EXPECT_EQ(text_of(rows_of(question)), plain) << testing::name_of(layout);
    }
}

/// Discs by x, y, vx, vy, r; the first is the object that changes.
AvoidQuestion discs(const std::vector<std::array<double, 5>>& numbers, double h, double within = 0) {
  RandomScene scene;
  scene.layout = testing::discs;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    scene.ids.push_back(static_cast<std::int64_t>(i) + 1);
    scene.rows.insert(scene.rows.end(), numbers[i].begin(), numbers[i].end());
  }
  scene.records = scene.rows;
  scene.h = h, scene.within = within;
  return avoid_question(scene, 0, as_scene(scene));
}

std::vector<AvoidRow> rows_of_how(AvoidQuestion question, Manoeuvre how) {
  question.how = how;
  return rows_of(question);
}

TEST(Avoid, FindsATouchAtTheEndOfTheHorizonOfOneChangeAlone) {
  const auto rows = rows_of_how(discs({{0, 0, 0, 10, 10}, {0, 1020, 0, 0, 10}}, 100), Manoeuvre::turn);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_FALSE(rows[1].clear);
  EXPECT_LE(rows[1].k_from, 0);
  EXPECT_GE(rows[1].k_to, 0);
  EXPECT_LT(rows[1].k_to - rows[1].k_from, 3.6e-4);
  ASSERT_TRUE(rows[1].below);
  EXPECT_EQ(rows[1].below->t, 100);
}

TEST(Avoid, BlocksAllSpeedsBesideAnObjectExactlyAsFarAsBothReach) {
  const auto touching = rows_of_how(discs({{0, 0, 0, 10, 10}, {20, 100, 0, 5, 10}}, 100), Manoeuvre::speed);
  ASSERT_EQ(touching.size(), 2u);  // slower than the other by enough, and all that meet
  EXPECT_TRUE(touching[0].clear);
  EXPECT_NEAR(touching[1].k_from, -4, 1e-5);
  const auto apart =
      rows_of_how(discs({{0, 0, 0, 10, 10}, {20.0000001, 100, 0, 5, 10}}, 100), Manoeuvre::speed);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_TRUE(apart[0].clear);
}

TEST(Avoid, FindsGapsThatNeedlesFit) {
  for (const double gap : {1e-1, 1e-2, 2e-3}) {
    const double at = 700, r = 50;
    const auto rows = rows_of_how(
        discs({{0, 0, 0, 10, 1}, {-(r + 1 + gap / 2), at, 0, 0, r}, {r + 1 + gap / 2, at, 0, 0, r}}, 100),
        Manoeuvre::turn);
    ASSERT_EQ(rows.size(), 5u) << gap;
    EXPECT_TRUE(rows[2].clear);
    EXPECT_LE(rows[2].k_from, 0);
    EXPECT_GE(rows[2].k_to, 0);
  }
}

TEST(Avoid, FindsPebbles) {
  for (const double r : {1e-1, 1e-2, 1e-3}) {
    const auto rows =
        rows_of_how(discs({{0, 0, 0, 10, 0}, {300, 632.4555320336759, 0, 0, r}}, 100), Manoeuvre::turn);
    ASSERT_EQ(rows.size(), 3u) << r;
    EXPECT_FALSE(rows[1].clear);
    EXPECT_NEAR(rows[1].k_to - rows[1].k_from, 2 * std::asin(r / 700) * 180 / M_PI, 1e-6);
  }
}

TEST(Avoid, SeesBothArcsOfAFasterIntruder) {
  const auto rows = rows_of_how(discs({{0, 0, 0, 5, 10}, {-500, 0, 10, 0, 10}}, 200), Manoeuvre::turn);
  int blocked = 0;
  for (const AvoidRow& row : rows) blocked += !row.clear;
  EXPECT_GE(blocked, 1);
  const auto two = rows_of_how(discs({{0, 0, 0, 5, 10}, {-500, 200, 10, -4, 10}}, 200), Manoeuvre::turn);
  blocked = 0;
  for (const AvoidRow& row : two) blocked += !row.clear;
  EXPECT_EQ(blocked, 2);
}

TEST(Avoid, RequiresOnlySeparationFromObjectsThatTouchAlready) {
  const AvoidQuestion moored = discs({{0, 0, 0, 2, 10}, {15, 0, 0, 0, 10}}, 60);
  const auto rows =
      rows_of_how(moored, Manoeuvre::turn);  // along its side at 0 and 180: no separation is needed
  const auto row_at = [&](double k) {
    return std::find_if(rows.begin(), rows.end(), [k](const AvoidRow& row) { return k <= row.k_to; });
  };
  EXPECT_TRUE(row_at(-90)->clear) << text_of(rows);
  EXPECT_NEAR(row_at(-90)->k_from, -180, 1e-6);
  EXPECT_NEAR(row_at(-90)->k_to, 0, 1e-6);
  EXPECT_TRUE(is_clear(moored, Manoeuvre::turn, 0));
  EXPECT_FALSE(row_at(90)->clear);
  AvoidQuestion ignored = moored;
  ignored.touching = Touching::ignore;
  const auto all = rows_of_how(ignored, Manoeuvre::turn);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].clear);
}

TEST(Avoid, LeavesNothingWithinARing) {
  std::vector<std::array<double, 5>> ring{{0, 0, 0, 10, 10}};
  for (int i = 0; i < 72; ++i)
    ring.push_back({400 * std::cos(i * M_PI / 36), 400 * std::sin(i * M_PI / 36), 0, 0, 20});
  const auto rows = rows_of_how(discs(ring, 100), Manoeuvre::turn);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows[0].clear);
  EXPECT_TRUE(rows[0].below && rows[0].above);
}

TEST(Avoid, TurnsToTheOppositeSideInAMirror) {
  Random random(5);
  for (int i = 0; i < 10 * rounds; ++i) {
    std::vector<std::array<double, 5>> scene{{0, 0, 0, 10, 10}}, mirrored = scene;
    for (int j = 0; j < 10; ++j) {
      const double x = random.in(-500, 500), y = random.in(-500, 500), vx = random.in(-10, 10),
                   vy = random.in(-10, 10);
      scene.push_back({x, y, vx, vy, 10}), mirrored.push_back({-x, y, -vx, vy, 10});
    }
    const auto rows = rows_of_how(discs(scene, 60), Manoeuvre::turn);
    const auto turned = rows_of_how(discs(mirrored, 60), Manoeuvre::turn);
    ASSERT_EQ(rows.size(), turned.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      EXPECT_NEAR(rows[j].k_from, -turned[rows.size() - 1 - j].k_to, 1e-8);
      EXPECT_EQ(rows[j].clear, turned[rows.size() - 1 - j].clear);
    }
  }
}

TEST(Avoid, HasOneAnswerForAnObjectAtRest) {
  const AvoidQuestion resting = discs({{0, 0, 0, 0, 10}, {100, 0, -10, 0, 10}}, 60);
  const auto rows = rows_of(resting);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(text_of(rows), "turn blocked -180 to 180 by 0.2@8 0.2@8\n");
  EXPECT_TRUE(rows_of_how(resting, Manoeuvre::speed).empty());
}

TEST(Avoid, StopsWhenInterrupted) {
  std::vector<std::array<double, 5>> crowd{{0, 0, 0, 10, 10}};
  for (int i = 0; i < 5000; ++i) crowd.push_back({100.0 + i, 500, 0, 0, 10});
  testing::StopAt stop(3);
  EXPECT_THROW(avoid(discs(crowd, 100), stop), Interrupted);
}

}  // namespace
}  // namespace foresee
