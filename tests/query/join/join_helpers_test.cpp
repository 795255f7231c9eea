// Helper threads change no row and not their order; interrupts and failures reach the caller.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "query/join/join_plan.h"
#include "query/join/slab_helpers.h"
#include "query/join_cases.h"
#include "sanitized.h"
#include "stopping_interrupt.h"

namespace foresee {
namespace {

using testing::discs;
using testing::numbers_of;
using testing::random_scene;
using testing::rows_in_order;
using testing::sanitized;
using testing::scene_of;
using testing::SceneKind;
using testing::StopAt;

JoinQuestion question_of(SceneKind kind, const Layout& layout, std::size_t count) {
  const auto scene = random_scene({.layout = layout, .kind = kind, .count = count, .seed = 21});
  return {.a = scene_of(scene), .now = scene.now, .h = scene.h, .within = scene.within};
}

std::vector<double> numbers_in_order(const JoinQuestion& question) {
  std::vector<JoinRow> all = rows_in_order(question);
  for (JoinRow& row : all) {  // columns that are not wanted are unspecified
    if (!question.wants.ends) row.contact.t_end = row.contact.dt_end = 0;
    if (!question.wants.approach) row.approach = {};
  }
  return numbers_of(all);
}

TEST(JoinHelpers, GiveTheSameRowsInTheSameOrder) {
  constexpr std::size_t count = sanitized ? 13000 : 15000;  // with fewer, the plan uses no helpers
  std::vector<JoinQuestion> questions = {
      question_of(SceneKind::uniform, discs, count), question_of(SceneKind::one_giant, discs, count),
      question_of(SceneKind::one_fast, {.axes = 3, .law = Law::accelerated, .shape = Shape::box}, count)};
  questions.push_back(questions[0]);
  questions.back().h = 20;
  questions.push_back(questions[0]);
  questions.back().b = questions[1].a;
  for (JoinQuestion& question : questions)
    for (JoinOrder order : {JoinOrder::any, JoinOrder::by_t_and_ids}) {
      question.order = order, question.helpers = 0;
      const auto alone = numbers_in_order(question);
      EXPECT_GT(alone.size(), 9 * 4096u) << "several batches";
      for (std::size_t helpers : {1u, 3u}) {
        if (sanitized && helpers == 1) continue;
        question.helpers = helpers;
        EXPECT_TRUE(plan_join(question).with_helpers);
        EXPECT_EQ(numbers_in_order(question), alone) << helpers;
      }
    }
}

/// Boxes, one of 300 of them far larger.
std::shared_ptr<const Scene> giants_among(int axes, std::size_t count, JoinQuestion& question) {
  auto scene = random_scene(
      {.layout = {.axes = axes, .law = Law::uniform, .shape = Shape::box}, .count = count, .seed = 22});
  const Offsets at = row_offsets(scene.layout);
  const auto size = static_cast<std::size_t>(at.size);
  for (std::size_t i = 0; i < scene.size(); i += 300)
    for (int axis = 0; axis < axes; ++axis)
      scene.rows[i * size + static_cast<std::size_t>(at.half + axis)] *= axes == 2 ? 200 : 60;
  question.now = scene.now, question.h = scene.h;
  return scene_of(scene);
}

void expect_same_with_helpers(JoinQuestion question, bool starts_alone) {
  for (JoinOrder order : {JoinOrder::any, JoinOrder::by_t_and_ids}) {
    question.order = order, question.helpers = 0;
    question.wants = {.ends = !starts_alone, .approach = !starts_alone};
    const auto alone = numbers_in_order(question);
    EXPECT_GT(alone.size(), 100000u);
    question.helpers = 2;
    EXPECT_TRUE(plan_join(question).with_helpers);
    EXPECT_EQ(numbers_in_order(question), alone);
  }
}

TEST(JoinHelpers, MeetManyGiantsFromAnyStripeOn) {
  JoinQuestion question;
  question.a = giants_among(2, sanitized ? 13000 : 20000, question);
  expect_same_with_helpers(question, false);
  expect_same_with_helpers(question, true);
  question.b = question.a;
  expect_same_with_helpers(question, true);
  question.a = giants_among(3, sanitized ? 7500 : 12000, question);
  question.b = giants_among(3, sanitized ? 7000 : 9000, question);
  expect_same_with_helpers(question, true);
}

/// If a giant covers all others, the last batch of a slab has pairs that touch. They are written once, also
/// if other slabs follow.
TEST(JoinHelpers, WriteWhatTouchesOnceInSeveralSlabs) {
  constexpr std::size_t count = 15000;
  auto scene = random_scene(
      {.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::box}, .count = count, .seed = 23});
  const Offsets at = row_offsets(scene.layout);
  double* const giant = scene.rows.data() + count / 2 * static_cast<std::size_t>(at.size);
  giant[at.half] = giant[at.half + 1] = 1e5;
  JoinQuestion question{.a = scene_of(scene), .now = scene.now, .h = 40};
  question.wants = {.ends = false, .approach = false};
  EXPECT_GT(plan_join(question).slabs, 1u);
  const auto alone = numbers_in_order(question);
  EXPECT_GT(alone.size(), 9 * 2 * count);
  question.helpers = 2;
  EXPECT_TRUE(plan_join(question).with_helpers);
  EXPECT_EQ(numbers_in_order(question), alone);
}

TEST(JoinHelpers, AreLeftAloneBySmallScenes) {
  JoinQuestion question = question_of(SceneKind::uniform, discs, 1000);
  question.helpers = 8;
  EXPECT_FALSE(plan_join(question).with_helpers);
}

void end_early(const JoinQuestion& question) {
  NeverInterrupt never;
  for (int batches : {0, 1, 20}) {
    Join join(question, never);
    for (int i = 0; i < batches; ++i) EXPECT_FALSE(join.next().empty());
  }
}

TEST(JoinHelpers, EndWithAJoinThatIsNotReadToItsEnd) {
  JoinQuestion question = question_of(SceneKind::one_spot, discs, 20000);  // 200 million pairs
  question.helpers = 2;
  end_early(question);
  question.a = giants_among(2, 60000, question);
  question.wants = {.ends = false, .approach = false};
  end_early(question);
}

TEST(JoinHelpers, AreNotMoreThanTheMachineCanUse) {
  EXPECT_EQ(useful_helpers(0), 0u);
  EXPECT_EQ(useful_helpers(16), 16u);
  EXPECT_EQ(useful_helpers(1 << 20), std::max(16u, 2 * std::thread::hardware_concurrency()));
  JoinQuestion question = question_of(SceneKind::uniform, discs, 60000);
  const std::size_t rows = rows_in_order(question).size();
  question.helpers = 1000000;
  EXPECT_EQ(rows_in_order(question).size(), rows);
}

TEST(JoinHelpers, AreStoppedByAnInterrupt) {
  JoinQuestion question = question_of(SceneKind::one_spot, discs, 20000);
  question.helpers = 2, question.order = JoinOrder::by_dt;
  for (int checks : {0, 1, 5, 30}) {
    StopAt stop(checks);
    EXPECT_THROW(
        {
          Join join(question, stop);
          while (!join.next().empty()) {
          }
        },
        Interrupted)
        << checks;
  }
}

}  // namespace
}  // namespace foresee
