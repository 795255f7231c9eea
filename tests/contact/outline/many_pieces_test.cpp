// Outlines of so many pieces that not all pairs of them can be kept in mind: the answer, what is kept, and an
// interrupt.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/outline/staged_pair.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// Strips side by side, as far apart as they are wide, all so long and slanted that the boxes of any two
/// meet. Across them they start at `first`, at first + 4, …
OutlinedObject slanted_strips(int count, double first, Corner velocity) {
  OutlinedObject strips{object(2, Shape::point), {}};
  strips.row.layout.law = Law::uniform;
  strips.row.v[0] = velocity.x, strips.row.v[1] = velocity.y;
  const double length = 8.0 * count;
  std::vector<std::vector<Ring>> parts;
  for (int i = 0; i < count; ++i) {
    const double near = first + 4 * i, far = near + 1;
    parts.push_back({{near, -near, far, -far, far + length, length - far, near + length, length - near}});
  }
  strips.outline = outline_of(parts);
  return strips;
}

/// The strips of each are between those of the other, and move across.
OutlineScene interleaved(int count, double speed) {
  return {slanted_strips(count, 0, {0, 0}), slanted_strips(count, 2, {speed, -speed}), {.horizon = {0, 10}}};
}

TEST(ManyPieces, ThatAllMayTouchAreTestedAgainWhenNeededAgain) {
  const auto answer = outline_contact(interleaved(190, 1));
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->t, 1);
  EXPECT_EQ(answer->t_end, 3);
  EXPECT_FALSE(outline_contact(interleaved(190, 0)));
}

TEST(ManyPieces, OfAPairTakeBoundedMemory) {
  for (const bool times_wanted : {false, true}) {
    StagedScene staged(interleaved(190, 1));
    const FlatSpace<1>& space = staged.space;
    UnionPair<FlatTraits<2, 1>> pair = staged.pair(times_wanted);
    if (times_wanted) {
      EXPECT_EQ(pair.first_contact().touches, Verdict::yes);
      EXPECT_EQ(pair.end_of_contact().t, 3);
    } else {
      EXPECT_EQ(pair.touches(), Verdict::yes);
    }
    EXPECT_LT(space.tested.size() + space.intervals.size() + space.ends.size(), times_wanted ? 33'000u : 10u);
  }
}

/// Interrupts at once, or counts.
class Interrupting final : public Interrupt {
 public:
  explicit Interrupting(bool at_once) : at_once_(at_once) {}

  void check() override {
    if (at_once_) throw Interrupted();
    ++checks_;
  }
  int checks() const { return checks_; }

 private:
  bool at_once_;
  int checks_ = 0;
};

TEST(ManyPieces, OfAPairPollAnInterrupt) {
  Interrupting at_once(true);
  EXPECT_THROW(outline_contact(interleaved(200, 1), at_once), Interrupted);
}

/// A wheel with this many teeth: the piece within has a corner at each.
OutlinedObject wheel(int teeth) {
  Ring ring;
  for (int i = 0; i < teeth; ++i)
    for (const double part : {0.0, 0.5}) {
      const double angle = 2 * std::numbers::pi * (i + part) / teeth, r = part > 0 ? 1000 : 1001;
      ring.insert(ring.end(), {r * std::cos(angle), r * std::sin(angle)});
    }
  return {object(2, Shape::point), outline_of({{ring}})};
}

// A tooth and the piece within the other wheel have thousands of conditions: each such pair counts as many steps.
TEST(ManyPieces, OfManyCornersPollAnInterruptAsOften) {
  constexpr int teeth = 2000;
  OutlineScene scene;
  scene.a = scene.b = wheel(teeth);
  scene.b.row.x[0] = 1990, scene.b.row.x[1] = 700, scene.b.row.v[0] = -10, scene.b.row.v[1] = 1;
  scene.question.horizon = {0, 100};
  Interrupting counting(false);
  ASSERT_TRUE(outline_contact(scene, counting).has_value());
  EXPECT_GT(counting.checks(), 40) << "2 where each pair of pieces counts as many steps";
}

TEST(ManyPieces, ArePassedOneAfterAnotherInFewSteps) {
  // A point along a saw, whose pieces are the teeth.
  constexpr int teeth = 3000;
  Ring saw{0, 0, teeth, 0};
  for (int i = teeth; i-- > 0;)
    for (const double number : {i + 0.5, 2.0, double(i), 1.0}) saw.push_back(number);
  OutlineScene scene;
  scene.a = {object(2, Shape::point), outline_of({{saw}})}, scene.b.row = scene.a.row;
  scene.b.row.x[0] = -1, scene.b.row.x[1] = 0.625, scene.b.row.v[0] = 1;
  scene.question.horizon = {0, 2.0 * teeth};
  Interrupting counting(false);
  const auto answer = outline_contact(scene, counting);
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->t, 1);
  EXPECT_EQ(answer->t_end, teeth + 1 - 0.15625);
  EXPECT_LT(counting.checks(), 100) << "of 16384 steps each";
}

}  // namespace
}  // namespace foresee
