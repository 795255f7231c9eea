// Horizons from 2^-1074 to 2^1000, in which squares and products leave the range of doubles but distances do
// not: make_contact() against the exact stage alone.
#include <gtest/gtest.h>

#include <cfloat>
#include <random>

#include "contact/exact/exact_contact.h"
#include "contact/minkowski/contact_set.h"
#include "contact/pair_by_hand.h"
#include "contact/window_contact.h"

namespace foresee {
namespace {

using testing_by_hand::contact;
using testing_by_hand::Object;
using testing_by_hand::object;

Object disc(double x, double v, double a, double r) {
  Object o = object(2, Shape::ball);
  o.x[0] = x, o.v[0] = v, o.a[0] = a, o.r = r;
  return o;
}

std::optional<ContactTimes> exactly(const Object& a, const Object& b, const ContactQuestion& question) {
  const std::vector<double> row_a = a.row(), row_b = b.row();
  const Setup setup{{a.layout, row_a.data(), 1},
                    {b.layout, row_b.data(), 1},
                    question.horizon,
                    PairRule(a.layout, b.layout, question.within)};
  const ContactSet set = contact_set(setup);
  const ExactLifetime lifetime = exact_lifetime_of(setup, row_a.data(), row_b.data());
  if (lifetime.rounded.none) return std::nullopt;
  PairPolynomials polynomials(setup, row_a.data(), row_b.data(), {set, row_a.data(), row_b.data()});
  return exact_times(polynomials, lifetime);
}

void expect_exact(const Object& a, const Object& b, const ContactQuestion& question) {
  const auto expected = exactly(a, b, question), found = contact(a, b, question);
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!expected) return;
  EXPECT_EQ(found->t, expected->t);
  EXPECT_EQ(found->dt, expected->dt);
  EXPECT_EQ(found->t_end, expected->t_end);
  EXPECT_EQ(found->dt_end, expected->dt_end);
}

TEST(ExtremeInstants, TheSquareOfAHorizonVanishesWhereTheBendDoesNot) {
  const Object a = disc(0, 0, 0, 0x1p-90), b = disc(0x1p-62, -0x1p480, 0x1p1021, 0);
  ASSERT_TRUE(exactly(a, b, {.horizon = {0, 0x1p-540}}));
  expect_exact(a, b, {.horizon = {0, 0x1p-540}});
}

TEST(ExtremeInstants, TwiceASquareOverflowsWhereThePlaceDoesNot) {
  const Object a = disc(0, 0, 0, 1), b = disc(1.1e154, -0.1, 0, 0);
  ASSERT_TRUE(exactly(a, b, {.horizon = {0, 1e156}}));
  expect_exact(a, b, {.horizon = {0, 1e156}});
}

TEST(ExtremeInstants, TheSlopeOfAChordOverflowsWhereThePlacesDoNot) {
  const Object a = disc(0, 0, 0, 1e300);
  Object b = disc(-.25 * DBL_MAX, DBL_MAX, 0x1p991, 0);
  b.x[1] = -.25e308, b.v[1] = 1e308;
  ASSERT_TRUE(exactly(a, b, {.horizon = {0, .5}}));
  expect_exact(a, b, {.horizon = {0, .5}});
}

TEST(ExtremeInstants, AWindowIsEnteredWhereTimesAreSubnormal) {
  const MovingWindow window({.lower = {0, -1}, .upper = {0x1p-76, 1}}, {.axes = 2}, 0);
  Object point = object(2, Shape::point);
  point.layout.law = Law::uniform, point.x[0] = -5.7 * 0x1p-74, point.v[0] = 0x1p1000;
  const std::vector<double> row = point.row();
  const Bodies points(point.layout, row.data(), 1);
  const Pair pair{0, 0};
  std::vector<Pair> hits;
  make_window_contact(window, points, {0, 0x1p-1050})->decide({&pair, 1}, hits);
  EXPECT_EQ(hits.size(), 1u);
}

/// Discs, and boxes with discs, that come near each other at some time of a horizon of any length.
TEST(ExtremeInstants, AnswersAreExactOverHorizonsOfAnyLength) {
  std::mt19937_64 random(1123);
  const auto whole = [&](int low, int high) { return low + static_cast<int>(random() % (high - low + 1)); };
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto power = [&](int exponent) {
    const double size = std::ldexp(1 + share(), std::min(exponent, 1022));
    return random() % 2 == 0 ? size : -size;
  };
  int touching = 0;
  for (int i = 0; i < 4000; ++i) {
    const int time = whole(-1074, 1000), size = whole(-400, 400);
    const double h = std::ldexp(1 + share(), time), meet = h * share(), r = std::abs(power(size));
    Object a = object(2, i % 2 == 0 ? Shape::ball : Shape::box), b = object(2, Shape::ball);
    a.r = a.half[0] = a.half[1] = r / 2, b.r = r / 2;
    for (int j = 0; j < 2; ++j) {
      const int travel = size + whole(-2, 30);
      b.v[j] = power(travel - time), b.a[j] = i % 3 == 0 ? 0 : power(travel - 2 * time);
      const double place = -(b.v[j] * meet + 0.5 * b.a[j] * meet * meet) + r * (share() - 0.5);
      b.x[j] = std::isfinite(place) ? place : 0;
    }
    SCOPED_TRACE(i);
    const ContactQuestion question{.horizon = {0, h}};
    expect_exact(a, b, question);
    touching += exactly(a, b, question).has_value();
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(touching, 1000);
}

}  // namespace
}  // namespace foresee
