// Every contact of a pair against the oracle: the number of contacts, and each time the double nearest to the exact
// one.
//
// FORESEE_LONG=1 multiplies the number of cases by 50.
#include <gtest/gtest.h>

#include <sstream>

#include "base/error.h"
#include "contact/case_count.h"
#include "contact/hard_pairs.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

std::vector<ContactTimes> all_contacts(const Object& a, const Object& b, const ContactQuestion& question) {
  const std::vector<double> row_a = a.row(), row_b = b.row();
  const Bodies bodies_a(a.layout, row_a.data(), 1), bodies_b(b.layout, row_b.data(), 1);
  const auto contact = make_contact(bodies_a, bodies_b, question, "a", "b");
  const Pair pair{0, 0};
  std::vector<Pair> hits, first_hits;
  std::vector<ContactTimes> times, first;
  contact->all_contacts({&pair, 1}, hits, times);
  contact->first_contacts({&pair, 1}, TimesWanted::both, first_hits, first);
  EXPECT_EQ(hits.size(), times.size());
  EXPECT_EQ(first.empty(), times.empty());
  if (first.empty() || times.empty()) return times;
  EXPECT_EQ(times[0].t, first[0].t);
  EXPECT_EQ(times[0].t_end, first[0].t_end);
  EXPECT_EQ(times[0].dt, first[0].dt);
  EXPECT_EQ(times[0].dt_end, first[0].dt_end);
  return times;
}

/// Checks cases of all families; returns the number of pairs with several contacts.
int check_all_contacts(std::span<const Family> families, Shapes shapes, std::initializer_list<int> all_axes,
                       int cases) {
  int several = 0;
  std::uint64_t seed = 77'000 * (static_cast<int>(shapes) + 1);
  for (const Family& family : families)
    for (int axes : all_axes) {
      Generator generate(family, seed++);
      for (int i = 0; i < scaled_count(cases); ++i) {
        const Case c = make_case(generate, family, shapes, axes);
        const std::vector<ContactTimes> answer = all_contacts(c.a, c.b, c.question);
        several += answer.size() > 1;
        const std::string complaint =
            oracle::judge_all(rule_of(c.a, c.b, c.question), c.a, c.b, c.question.horizon, answer);
        if (complaint.empty()) continue;
        std::ostringstream story;
        story << c;
        ADD_FAILURE() << family.name << ", axes " << axes << ", case " << i << ": " << complaint << "\n"
                      << story.str();
        return several;
      }
    }
  return several;
}

/// A sanitizer build has few cases, of which none may have several contacts.
constexpr int more_than(int count) {
  return sanitized ? -1 : count;
}

TEST(AllContacts, OfBoxes) {
  EXPECT_GT(check_all_contacts(ordinary_families(), Shapes::boxes, {1, 2, 3}, 150), more_than(20));
  check_all_contacts(extreme_families(), Shapes::boxes, {1, 2, 3}, 30);
}
TEST(AllContacts, OfBalls) {
  EXPECT_GT(check_all_contacts(ordinary_families(), Shapes::balls, {1, 2, 3}, 50), more_than(5));
  check_all_contacts(extreme_families(), Shapes::balls, {2, 3}, 20);
}
TEST(AllContacts, OfBoxAndBall) {
  EXPECT_GT(check_all_contacts(ordinary_families(), Shapes::box_and_ball, {1, 2, 3}, 30), more_than(2));
}
TEST(AllContacts, OfCylindersAndPoints) {
  check_all_contacts(ordinary_families(), Shapes::cylinders, {3}, 80);
  check_all_contacts(ordinary_families(), Shapes::cylinder_and_box, {3}, 30);
  EXPECT_GT(check_all_contacts(ordinary_families(), Shapes::points_within, {1, 2, 3}, 20), more_than(1));
}
TEST(AllContacts, OfShapesThatGrow) {
  check_all_contacts(growing_families(), Shapes::boxes, {1, 2, 3}, 30);
  check_all_contacts(growing_families(), Shapes::balls, {1, 2, 3}, 20);
  check_all_contacts(growing_families(), Shapes::cylinders, {3}, 20);
}

/// Thrown up beside a balcony: it touches on the ascent and on the descent. Balls on one axis, cylinders on three.
TEST(AllContacts, OnTheAscentAndTheDescent) {
  for (const Shape shape : {Shape::ball, Shape::cylinder, Shape::box}) {
    const int axes = shape == Shape::cylinder ? 3 : 1;
    Object balcony = object(axes, shape), ball = object(axes, shape);
    for (Object* o : {&balcony, &ball}) o->r = o->hz = o->half[0] = 1;
    balcony.x[axes - 1] = 10;
    ball.v[axes - 1] = 16,
                  ball.a[axes - 1] = -2;  // 16 s - s^2: 8 at s = 8 -+ sqrt(56), 12 at s = 8 -+ sqrt(52)
    const auto times = all_contacts(ball, balcony, {.horizon = {0, 100}});
    ASSERT_EQ(times.size(), 2u);
    EXPECT_NEAR(times[0].t, 8 - std::sqrt(56), 1e-12);
    EXPECT_NEAR(times[0].t_end, 8 - std::sqrt(52), 1e-12);
    EXPECT_NEAR(times[1].t, 8 + std::sqrt(52), 1e-12);
    EXPECT_NEAR(times[1].t_end, 8 + std::sqrt(56), 1e-12);
  }
}

/// A graze in the middle of a contact does not part it, and a graze alone is a contact of one time.
TEST(AllContacts, AtAGraze) {
  Object wall = object(1, Shape::ball), ball = object(1, Shape::ball);
  wall.x[0] = 17, wall.r = 1, ball.v[0] = 8, ball.a[0] = -2, ball.r = 0;  // 8 s - s^2: 16 at s = 4
  const auto graze = all_contacts(ball, wall, {.horizon = {0, 100}});
  ASSERT_EQ(graze.size(), 1u);
  EXPECT_EQ(graze[0].t, 4);
  EXPECT_EQ(graze[0].t_end, 4);
  wall.x[0] = 15;  // from 14 to 16: it turns at the far side
  const auto through = all_contacts(ball, wall, {.horizon = {0, 100}});
  ASSERT_EQ(through.size(), 1u);
  EXPECT_NEAR(through[0].t, 4 - std::sqrt(2), 1e-12);
  EXPECT_NEAR(through[0].t_end, 4 + std::sqrt(2), 1e-12);
}

TEST(AllContacts, AreRefusedForOutlines) {
  Object a = object(2, Shape::outline), b = object(2, Shape::point);
  std::vector<double> row_b = b.row();
  const Bodies none(a.layout, nullptr, 0), points(b.layout, row_b.data(), 1);
  const auto contact = make_contact(none, points, {.horizon = {0, 1}}, "a", "b");
  std::vector<Pair> hits;
  std::vector<ContactTimes> times;
  try {
    contact->all_contacts({}, hits, times);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "contacts = 'all' is not for outlines and meshes: leave it out");
  }
}

}  // namespace
}  // namespace foresee
