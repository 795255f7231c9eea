// Contact of boxes by cases whose answer is known: touches, near misses, curved paths, lifetimes, reference
// times.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/pair_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

Object box(double x, double y, double vx, double vy, double half = 1) {
  Object o = object(2, Shape::box);
  o.x[0] = x, o.x[1] = y, o.v[0] = vx, o.v[1] = vy;
  o.half[0] = o.half[1] = half;
  return o;
}

void expect_times(const std::optional<ContactTimes>& times, double dt, double dt_end, double now = 0) {
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->dt, dt);
  EXPECT_EQ(times->dt_end, dt_end);
  EXPECT_EQ(times->t, now + dt);
  EXPECT_EQ(times->t_end, now + dt_end);
}

TEST(BoxBox, MeetAndPart) {
  expect_times(contact(box(0, 0, 1, 0), box(10, 0, -1, 0), {.horizon = {0, 100}}), 4, 6);
}

TEST(BoxBox, TouchAtTheLastInstantAndNotAfterIt) {
  EXPECT_TRUE(contact(box(0, 0, 1, 0), box(10, 0, -1, 0), {.horizon = {0, 4}}));
  EXPECT_FALSE(contact(box(0, 0, 1, 0), box(10, 0, -1, 0), {.horizon = {0, std::nextafter(4.0, 0)}}));
}

TEST(BoxBox, TouchAtTheFirstInstantAndLeave) {
  expect_times(contact(box(0, 0, 0, 0), box(2, 0, 1, 0), {.horizon = {0, 10}}), 0, 0);
}

TEST(BoxBox, SharedEdgeIsContact) {
  expect_times(contact(box(0, 0, 1, 0), box(10, 2, -1, 0), {.horizon = {0, 100}}), 4, 6);
}

TEST(BoxBox, CornersMeetForAnInstant) {
  expect_times(contact(box(0, 0, 1, 0), box(8, 8, 0, -1), {.horizon = {0, 100}}), 6, 10);
  EXPECT_FALSE(contact(box(0, 0, 1, 0), box(10, 14.000001, 0, -1), {.horizon = {0, 100}}));
}

TEST(BoxBox, AcceleratedCatchUp) {
  Object fast = box(0, 0, 0, 0);
  fast.a[0] = 2;  // x = t^2
  expect_times(contact(fast, box(11, 0, 0, 0), {.horizon = {0, 100}}), 3, std::sqrt(13.0));
}

TEST(BoxBox, ThrownUpAndBackIsTheFirstContactOnly) {
  Object ball = box(0, 0, 0, 8, 0.5);
  ball.a[1] = -2;  // y = 8 t - t^2: 15 at 3 and 5
  expect_times(contact(ball, box(0, 14, 0, 0, 0.5), {.horizon = {0, 100}}), 4 - std::sqrt(3.0), 4 - 1);
}

TEST(BoxBox, GrazingAtTheTurningPointIsContact) {
  Object ball = box(0, 0, 0, 8, 0.5);
  ball.a[1] = -2;  // rises to 16.5 at 4
  const auto times = contact(ball, box(0, 17, 0, 0, 0.5), {.horizon = {0, 100}});
  ASSERT_TRUE(times.has_value());
  EXPECT_NEAR(times->dt, 4, 1e-6);
}

TEST(BoxBox, WithinGrowsEveryAxis) {
  expect_times(contact(box(0, 0, 1, 0), box(10, 3, -1, 0), {.horizon = {0, 100}, .within = 1}), 3.5, 6.5);
  EXPECT_FALSE(contact(box(0, 0, 1, 0), box(10, 3.5, -1, 0), {.horizon = {0, 100}, .within = 1}));
}

TEST(BoxBox, ReferenceTimesMayDiffer) {
  Object late = box(6, 0, -1, 0);
  late.t = 104;  // was at 10 when now was 100
  Object early = box(-50, 0, 1, 0);
  early.t = 50;  // is at 0 then
  late.t = 100, late.x[0] = 10;
  expect_times(contact(early, late, {.horizon = {100, 50}}), 4, 6, 100);
}

TEST(BoxBox, OnlyWhileBothExist) {
  Object guest = box(0.5, 0, 0, 0);
  guest.t = 30, guest.until = 40;
  expect_times(contact(box(0, 0, 0, 0), guest, {.horizon = {10, 100}}), 20, 30, 10);
  EXPECT_FALSE(contact(box(0, 0, 0, 0), guest, {.horizon = {10, 19}}));
  EXPECT_TRUE(contact(box(0, 0, 0, 0), guest, {.horizon = {10, 20}}));
  EXPECT_TRUE(contact(box(0, 0, 0, 0), guest, {.horizon = {40, 20}}));
  EXPECT_FALSE(contact(box(0, 0, 0, 0), guest, {.horizon = {41, 20}}));
}

TEST(BoxBox, PointsMeetWhereTheyCoincide) {
  Object a = object(3, Shape::point), b = object(3, Shape::point);
  for (int j = 0; j < 3; ++j) a.v[j] = j + 1, b.x[j] = 4.0 * (j + 1);
  const auto times = contact(a, b, {.horizon = {0, 10}});
  ASSERT_TRUE(times.has_value());
  EXPECT_NEAR(times->dt, 4, 1e-6);
  b.x[2] += 1e-9;
  EXPECT_FALSE(contact(a, b, {.horizon = {0, 10}}));
}

TEST(BoxBox, FarFromTheOriginNothingIsLost) {
  Object a = box(1e15, 1e15, 1, 0, 0.125), b = box(1e15 + 4, 1e15, -1, 0, 0.125);
  expect_times(contact(a, b, {.horizon = {0, 10}}), 1.875, 2.125);
}

TEST(BoxBox, DifferentLawsMeet) {
  Object rock = box(20, 0, 0, 0);
  rock.layout.law = Law::rest;
  rock.layout.has_t = rock.layout.has_until = false;
  Object rocket = box(0, 0, 0, 0);
  rocket.layout.law = Law::forced;
  rocket.a[0] = 4;  // x = 2 t^2
  expect_times(contact(rocket, rock, {.horizon = {0, 10}}), 3, std::sqrt(11.0));
  Object car = box(0, 0, 2, 0);
  car.layout.law = Law::uniform;
  expect_times(contact(rock, car, {.horizon = {0, 100}}), 9, 11);
}

}  // namespace
}  // namespace foresee
