// ContactSet with sets that no pair of shapes has today: many pieces, sizes that change with time.
#include "contact/minkowski/contact_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "contact/contact_factories.h"
#include "contact/exact/exact_contact.h"
#include "contact/oracle.h"
#include "contact/pair_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// A point that moves past a set at rest around the origin.
class Passage {
 public:
  Passage(std::initializer_list<double> x, std::initializer_list<double> v, double h,
          std::initializer_list<double> a = {})
      : moving(object(static_cast<int>(x.size()), Shape::point)), still(moving) {
    std::copy(x.begin(), x.end(), moving.x);
    std::copy(v.begin(), v.end(), moving.v);
    std::copy(a.begin(), a.end(), moving.a);
    row_moving_ = moving.row(), row_still_ = still.row();
    setup = {.a = {still.layout, row_still_.data(), 1},
             .b = {moving.layout, row_moving_.data(), 1},
             .horizon = {0, h}};
  }

  /// The answer of all stages; it must be that of the exact stage alone.
  std::optional<ContactTimes> through(const ContactSet& set) const {
    const auto contact = make_set_contact(setup, set, 2);
    const Pair pair{0, 0};
    std::vector<Pair> hits, decided;
    std::vector<ContactTimes> times;
    contact->first_contacts({&pair, 1}, TimesWanted::both, hits, times);
    contact->decide({&pair, 1}, decided);
    EXPECT_EQ(hits, decided);
    PairPolynomials polynomials(setup, row_still_.data(), row_moving_.data(),
                                {set, row_still_.data(), row_moving_.data()});
    const auto exact =
        exact_times(polynomials, exact_lifetime_of(setup, row_still_.data(), row_moving_.data()));
    EXPECT_EQ(exact.has_value(), !times.empty());
    if (!exact || times.empty()) return {};
    EXPECT_EQ(times[0].dt, exact->dt);
    EXPECT_EQ(times[0].dt_end, exact->dt_end);
    return times[0];
  }

  Object moving, still;
  Setup setup;

 private:
  std::vector<double> row_moving_, row_still_;
};

void expect_span(const std::optional<ContactTimes>& times, double begin, double end) {
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->dt, begin);
  EXPECT_EQ(times->dt_end, end);
}

struct Disc {
  double x, y, r;
};

ContactSet set_of(std::span<const Disc> discs) {
  ContactSet set;
  for (const Disc& disc : discs) {
    const int x = set.given(disc.x), y = set.given(disc.y), r = set.given(disc.r);
    const AxisPart centre[] = {{.axis = 0, .at = {x}}, {.axis = 1, .at = {y}}};
    const int ball = set.ball(centre, {r});
    Conditions piece{.all = {ball}, .ball = ball};
    for (const AxisPart& part : centre) {
      piece.around.push_back(set.bound(part.axis, 1, {set.sum(part.at.value, r)}));
      piece.around.push_back(set.bound(part.axis, -1, {set.difference(r, part.at.value)}));
    }
    set.add_piece(piece);
  }
  return set;
}

TEST(ContactSet, OfAHundredDiscsThatTouchIsOneContact) {
  std::vector<Disc> chain;
  for (int i = 1; i <= 100; ++i) chain.push_back({static_cast<double>(i), 0, 0.5});
  std::shuffle(chain.begin(), chain.end(), std::mt19937_64(3));
  expect_span(Passage({-4, 0}, {1, 0}, 1000).through(set_of(chain)), 4.5, 104.5);
  // Off their common line the point leaves the first before it enters the second.
  Passage beside({-4, 0.3}, {1, 0}, 1000);
  expect_span(beside.through(set_of(chain)), 4.6, 5.4);
  EXPECT_FALSE(Passage({-4, std::nextafter(0.5, 1)}, {1, 0}, 1000).through(set_of(chain)));
}

/// The first contact of the union is the first of the contacts of the discs, which the oracle gives one by
/// one.
TEST(ContactSet, OfAHundredDiscsIsTheUnionOfDiscs) {
  std::mt19937_64 random(11);
  const auto number = [&random](double range) {
    return std::uniform_real_distribution<double>(-range, range)(random);
  };
  int contacts = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Disc> discs;
    for (int i = 0; i < 100; ++i) discs.push_back({number(40), number(40), std::abs(number(3))});
    Passage passage({number(40), number(40)}, {number(4), number(4)}, 10);
    std::vector<std::pair<double, double>> each;
    for (const Disc& disc : discs) {
      Object round_one = object(2, Shape::ball);
      round_one.x[0] = disc.x, round_one.x[1] = disc.y, round_one.r = disc.r;
      const auto times = contact(round_one, passage.moving, {.horizon = {0, 10}});
      oracle::Rule rule{.axes = {}, .half = {{}, {}}, .round = {0, 1}, .radius = {disc.r}};
      for (int j = 0; j < 2; ++j) rule.axes.push_back(oracle::relative_axis(round_one, passage.moving, j, 0));
      EXPECT_EQ(oracle::judge(rule, round_one, passage.moving, {0, 10}, times), "");
      if (times) each.emplace_back(times->dt, times->dt_end);
    }
    const auto whole = passage.through(set_of(discs));
    ASSERT_EQ(whole.has_value(), !each.empty());
    if (!whole) continue;
    ++contacts;
    std::sort(each.begin(), each.end());
    double end = each[0].second;
    for (const auto& [from, to] : each)
      if (from <= end) end = std::max(end, to);
    expect_span(whole, each[0].first, end);
  }
  EXPECT_GT(contacts, 20);
}

TEST(ContactSet, OfNoPieceIsNeverMetAndOfAnEmptyPieceAlways) {
  const Passage passage({1, 2}, {3, 4}, 8);
  ContactSet set;
  EXPECT_FALSE(passage.through(set));
  set.add_piece({});
  expect_span(passage.through(set), 0, 8);
}

/// |x| <= R over two axes, R = r + rate tau.
ContactSet growing_disc(double r, double rate) {
  ContactSet set;
  const Size radius{set.given(r), set.given(rate)};
  const AxisPart centre[] = {{.axis = 0}, {.axis = 1}};
  const int ball = set.ball(centre, radius);
  Conditions piece{.all = {ball}, .ball = ball};
  for (const AxisPart& part : centre)
    for (const int sign : {1, -1}) piece.around.push_back(set.bound(part.axis, sign, radius));
  set.add_piece(piece);
  return set;
}

TEST(ContactSet, SizesGrowWithTime) {
  const Passage at_rest({6, 8}, {0, 0}, 100), closing({12, 0}, {-1, 0}, 100);
  expect_span(at_rest.through(growing_disc(4, 0.5)), 12, 100);
  expect_span(closing.through(growing_disc(3, 0.5)), 6, 30);
  // Moving away at the speed of growth it is never reached; slightly slower it is.
  EXPECT_FALSE(Passage({4, 0}, {2, 0}, 100).through(growing_disc(3, 2)));
  expect_span(Passage({4, 0}, {2, 0}, 100).through(growing_disc(3, 2.25)), 4, 100);
  // A shrinking disc ends the contact.
  expect_span(Passage({3, 4}, {0, 0}, 16).through(growing_disc(9, -0.5)), 0, 8);
}

TEST(ContactSet, BoundsAndCentresMoveToo) {
  ContactSet bound;
  // x <= -5 + 2 tau
  const Size limit{bound.given(-5), bound.given(2)};
  const int face = bound.bound(0, 1, limit);
  bound.add_piece({.all = {face}});
  expect_span(Passage({3, 0}, {0, 0}, 100).through(bound), 4, 100);
  expect_span(Passage({3, 0}, {1, 0}, 100).through(bound), 8, 100);

  ContactSet ball;
  // A disc of radius 1 around (4 tau, 3 tau).
  const AxisPart centre[] = {{.axis = 0, .at = {no_length, ball.given(4)}},
                             {.axis = 1, .at = {no_length, ball.given(3)}}};
  ball.add_piece({.all = {ball.ball(centre, {ball.given(1)})}});
  expect_span(Passage({8, 6}, {0, 0}, 100).through(ball), 1.8, 2.2);
}

}  // namespace
}  // namespace foresee
