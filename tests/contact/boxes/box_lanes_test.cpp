// BoxLanes: certain answers of a lane against the exact stage, on the families of hard_pairs.h. Every set of
// vector instructions gives the same bits. Boxes without t and until take a shorter path.
#include "contact/boxes/box_lanes.h"

#include <gtest/gtest.h>

#include <cstring>

#include "contact/certified/certain_motion.h"
#include "contact/exact/exact_contact.h"
#include "contact/hard_pairs.h"
#include "contact/minkowski/contact_set.h"
#include "every_simd.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

struct Certain {
  int misses = 0, now = 0, meets = 0, first = 0, leaves = 0, lasts = 0;
};

template <int D, int Degree = 2>
class LaneOfPair {
 public:
  explicit LaneOfPair(const Case& c)
      : case_(c),
        row_a_(c.a.row()),
        row_b_(c.b.row()),
        setup_{{c.a.layout, row_a_.data(), 1},
               {c.b.layout, row_b_.data(), 1},
               c.question.horizon,
               PairRule(c.a.layout, c.b.layout, c.question.within)},
        lifetime_(pair_lifetime_of(setup_, row_a_.data(), row_b_.data())),
        relative_(certain_motion_of<D, Degree>(setup_, row_a_.data(), row_b_.data())) {}

  bool from_now() const {
    return !lifetime_.none && lifetime_.start_exact && lifetime_.dt_start == 0 &&
           relative_.underflow <= usual_underflow;
  }

  bool touches() const { return run(exact_touches); }

  void check(Certain& certain) const {
    BoxLanes<D, Degree> lanes;
    double half[D];
    for (int j = 0; j < D; ++j)
      half[j] = size_as_of_t<double>(setup_.rule.extent[j], row_a_.data(), row_b_.data());
    for (int l = 0; l < lanes.width; ++l)
      put_motion(lanes, l, relative_, half, lifetime_.dt_end * (1 + 0x1p-52));
    box_kernel<D, Degree>().settle(lanes);
    check_simd(lanes);
    const bool touches = run(exact_touches);
    certain.misses += lanes.misses[3] > 0;
    certain.now += lanes.touches_now[3] > 0;
    certain.meets += lanes.meets[3] > 0;
    certain.first += lanes.meets_first[3] > 0;
    if (lanes.misses[3] > 0) {
      EXPECT_FALSE(touches) << case_;
    }
    if (lanes.touches_now[3] > 0 || lanes.meets[3] > 0) {
      EXPECT_TRUE(touches) << case_;
    }
    if (!touches) return;
    const ContactTimes times = *run(exact_times);
    if (lanes.touches_now[3] > 0) {
      EXPECT_EQ(times.dt, 0) << case_;
    } else if (lanes.meets_first[3] > 0) {
      EXPECT_GE(times.dt, lanes.before[3]) << case_;
      EXPECT_LE(times.dt, lanes.after[3]) << case_;
    } else {
      return;
    }
    check_end(lanes, times.dt_end, certain);
  }

 private:
  template <class Answer>
  Answer run(Answer (*question)(PiecePolynomials&, const ExactLifetime&)) const {
    const ContactSet set = contact_set(setup_);
    PairPolynomials polynomials(setup_, row_a_.data(), row_b_.data(), {set, row_a_.data(), row_b_.data()});
    return question(polynomials, exact_lifetime_of(setup_, row_a_.data(), row_b_.data()));
  }

  void check_end(const BoxLanes<D, Degree>& lanes, double dt_end, Certain& certain) const {
    EndLanes ends;
    std::fill_n(ends.from, lanes_width, lanes.touches_now[3] > 0 ? 0 : lanes.after[3]);
    box_kernel<D, Degree>().settle_ends(lanes, ends);
    certain.leaves += ends.leaves[3] > 0;
    certain.lasts += ends.lasts[3] > 0;
    if (ends.leaves[3] > 0) {
      EXPECT_LE(std::abs(dt_end - ends.time[3]), ends.room[3]) << case_;
    }
    if (ends.lasts[3] > 0) {
      EXPECT_EQ(dt_end, lifetime_.dt_end) << case_;
    }
    testing::for_every_simd([&](Simd) {
      EndLanes others = ends;
      box_kernel<D, Degree>().settle_ends(lanes, others);
      EXPECT_EQ(std::memcmp(&ends, &others, sizeof ends), 0) << case_;
    });
  }

  void check_simd(const BoxLanes<D, Degree>& lanes) const {
    testing::for_every_simd([&](Simd) {
      BoxLanes<D, Degree> others = lanes;
      box_kernel<D, Degree>().settle(others);
      EXPECT_EQ(std::memcmp(&lanes, &others, sizeof lanes), 0) << case_;
    });
  }

  const Case& case_;
  std::vector<double> row_a_, row_b_;
  Setup setup_;
  PairLifetime lifetime_;
  CertainMotion<D> relative_;
};

Object without_acceleration(Object o) {
  o.layout.law = std::min(o.layout.law, Law::uniform);
  return o;
}

template <int D, int Degree>
void check_families(std::uint64_t seed) {
  Certain certain;
  for_each_hard_pair(Shapes::boxes, D, 60, seed, [&](Case c, Generator& generate) {
    if (Degree < 2) {
      c.a = without_acceleration(c.a), c.b = without_acceleration(c.b);
      generate.aim(c.a, c.b, c.question.horizon);
    }
    const LaneOfPair<D, Degree> lane(c);
    if (lane.from_now()) lane.check(certain);
  });
  // A stage that is never certain would prove nothing.
  EXPECT_GT(certain.misses, 60);
  EXPECT_GT(certain.now, 20);
  EXPECT_GT(certain.meets, 60);
  EXPECT_GT(certain.first, 60);
  EXPECT_GT(certain.leaves, 60);
  EXPECT_GT(certain.lasts, 20);
}

TEST(BoxLanes, AreRightWhereCertainInOneDimension) {
  check_families<1, 2>(1000);
}
TEST(BoxLanes, AreRightWhereCertainInTwoDimensions) {
  check_families<2, 2>(2000);
}
TEST(BoxLanes, AreRightWhereCertainInThreeDimensions) {
  check_families<3, 2>(3000);
}

TEST(BoxLanes, AreRightWhereCertainOfStraightCourses) {
  check_families<1, 1>(5000);
  check_families<2, 1>(6000);
  check_families<3, 1>(7000);
}

/// The object as one of a table that declares neither t nor until.
Object without_times(Object o) {
  o.layout.has_t = o.layout.has_until = false;
  return o;
}

TEST(BoxLanes, UndeclaredTimesChangeNothing) {
  std::uint64_t seed = 4000;
  int hits = 0;
  for (const Family& family : ordinary_families()) {
    if (family.now != 0 || family.ages > 0 || family.lives) continue;
    Generator generate(family, ++seed);
    for (int i = 0; i < 200; ++i) {
      const Case c = make_case(generate, family, Shapes::boxes, 1 + i % 3);
      const auto aged = contact(c.a, c.b, c.question);
      const auto fresh = contact(without_times(c.a), without_times(c.b), c.question);
      ASSERT_EQ(aged.has_value(), fresh.has_value()) << c;
      if (!aged) continue;
      ++hits;
      EXPECT_EQ(std::memcmp(&*aged, &*fresh, sizeof *aged), 0) << c;
    }
  }
  EXPECT_GT(hits, 500);
}

/// Two huge accelerations of different ages that nearly cancel: error bounds overflow, the motion does not,
/// and no answer may be certain.
TEST(BoxLanes, AreNotCertainWhereErrorBoundsOverflow) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> mantissa(1, 1.7), age(1, 1.2), exponent(280, 308);
  int hits = 0, misses = 0;
  for (int i = 0; i < 3000; ++i) {
    Case c;
    c.question = {.horizon = {0, i % 2 == 0 ? 0 : 0.5}};
    for (Object* o : {&c.a, &c.b}) {
      *o = object(2, Shape::box);
      o->t = -age(random);
      o->a[0] = mantissa(random) * 1e308;
      o->half[0] = std::pow(10, exponent(random)), o->half[1] = 1;
    }
    if (i % 3 == 0) c.b.a[0] = c.a.a[0], c.b.t = std::nextafter(c.a.t, 0), c.a.half[0] = c.b.half[0] = 0;
    const bool touches = LaneOfPair<2>(c).touches();
    EXPECT_EQ(contact(c.a, c.b, c.question).has_value(), touches) << c;
    touches ? ++hits : ++misses;
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 300);
}

/// Two boxes that approach, turn at their closest approach, and separate. The quadratic has no root, and the
/// interval around the turn is certified by its minimum alone.
TEST(BoxLanes, KnowTheLowestPointOfAParabola) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(0.1, 2), closeness(1, 54);
  Certain certain;
  for (int i = 0; i < 4000; ++i) {
    Case c;
    c.a = object(2, Shape::box), c.b = object(2, Shape::box);
    const double turn = number(random), a = number(random), half = number(random);
    const double beside = std::exp2(-closeness(random)) * (i % 2 ? 1 : -1);
    c.question = {.horizon = {0, turn * (1 + number(random))}};
    c.b.x[0] = (half + 0.5 * a * turn * turn) * (1 + beside), c.b.v[0] = -a * turn, c.b.a[0] = a;
    c.b.half[0] = half, c.b.half[1] = 2;
    if (i % 4 >= 2) c.b.x[1] = 3, c.b.v[1] = -4 / turn;  // enters in y first
    LaneOfPair<2>(c).check(certain);
  }
  EXPECT_GT(certain.misses, 1500);
  EXPECT_GT(certain.first, 500);
}

/// Also if four times the acceleration overflows.
TEST(BoxLanes, KnowTheLowestPointOfTheLargestAccelerations) {
  for (double a = 0x1p1020; std::isfinite(a); a *= 2)
    for (int bits : {40, 100, 400}) {
      const double h = std::exp2(-bits), k = 0.5 * a;
      Case c;
      c.a = object(1, Shape::box), c.b = object(1, Shape::box);
      c.question = {.horizon = {0, h}};
      c.b.x[0] = k * (0.3 * h) * (0.7 * h), c.b.v[0] = -k * h, c.b.a[0] = a;
      const bool touches = LaneOfPair<1>(c).touches();
      EXPECT_TRUE(touches) << c;
      EXPECT_EQ(contact(c.a, c.b, c.question).has_value(), touches) << c;
    }
}

struct Answers {
  std::vector<Pair> decided, hits;
  std::vector<ContactTimes> times;

  bool operator==(const Answers& other) const {
    return decided == other.decided && hits == other.hits && times.size() == other.times.size() &&
           std::memcmp(times.data(), other.times.data(), times.size() * sizeof times[0]) == 0;
  }
};

void run(const Bodies& bodies, std::span<const Pair> pairs, TimesWanted wanted, Answers& answers) {
  const auto contact = make_contact(bodies, bodies, {.horizon = {2, 3}, .within = 0.25}, "a", "a");
  contact->decide(pairs, answers.decided);
  contact->first_contacts(pairs, wanted, answers.hits, answers.times);
  if (wanted == TimesWanted::starts)
    for (ContactTimes& times : answers.times) times.t_end = times.dt_end = 0;  // unspecified
}

/// The answer of a lane depends neither on its neighbours nor on the end of a batch nor on the instructions.
/// The pairs have reference times at `now` and before; many giants touch now, and some pairs never touch.
TEST(BoxLanes, PairsAnswerAloneAsInABatch) {
  const Layout layout{.axes = 2, .law = Law::accelerated, .shape = Shape::box, .has_t = true};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 12), speed(-3, 3);
  std::vector<double> rows;
  constexpr std::uint32_t count = 83;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double half = i < 20 ? 20 : 0.25;
    for (const double number : {i % 40 == 39 ? 1.5 : 2, place(random), place(random), speed(random),
                                speed(random), speed(random) / 6, speed(random) / 6, half, half})
      rows.push_back(number);
  }
  const Bodies bodies(layout, rows.data(), count);
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b) pairs.push_back({a, b});
  for (const TimesWanted wanted : {TimesWanted::starts, TimesWanted::both}) {
    Answers alone;
    for (const Pair& pair : pairs) run(bodies, {&pair, 1}, wanted, alone);
    EXPECT_GT(alone.hits.size(), 1000u);
    EXPECT_LT(alone.hits.size(), pairs.size() - 500);
    EXPECT_EQ(alone.decided, alone.hits);
    testing::for_every_simd([&](Simd) {
      Answers together;
      run(bodies, pairs, wanted, together);
      EXPECT_TRUE(together == alone);
    });
  }
}

}  // namespace
}  // namespace foresee
