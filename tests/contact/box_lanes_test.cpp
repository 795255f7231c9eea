// Boxes eight at a time: what a lane is certain of against the exact stage, on the families of hard_pairs.h;
// the same bits from every set of vector instructions; and boxes without t and until, which take a shorter
// way.
#include <gtest/gtest.h>

#include <cstring>

#include "contact/box_contact.h"
#include "contact/hard_pairs.h"
#include "motion/simd.h"

namespace foresee {
namespace {

using namespace testing_pairs;

struct Certain {
  int misses = 0, now = 0, meets = 0, first = 0;
};

template <int D>
class LaneOfPair {
 public:
  explicit LaneOfPair(const Case& c)
      : case_(c),
        row_a_(c.a.row()),
        row_b_(c.b.row()),
        setup_{{c.a.layout, row_a_.data(), 1},
               {c.b.layout, row_b_.data(), 1},
               c.question.horizon,
               c.question.within,
               0},
        moments_(moments_of(setup_, row_a_.data(), row_b_.data())),
        relative_(relative_of<D, 2>(setup_, row_a_.data(), row_b_.data())) {}

  bool from_now() const {
    return !moments_.none && moments_.begin_exact && moments_.dt_begin == 0 &&
           relative_.underflow <= usual_underflow;
  }

  void check(Certain& certain) const {
    BoxLanes<D, 2> lanes;
    const auto raw = raw_sizes_of<double, D>(setup_, row_a_.data(), row_b_.data());
    for (int l = 0; l < lanes.width; ++l)
      put_course(lanes, l, relative_, BoxBox<D>::sizes(raw, setup_).half, moments_.dt_end * (1 + 0x1p-52));
    settle(lanes);
    check_simd(lanes);
    const bool touches = ask(exact_touches);
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
    const double begin = ask(exact_times).dt;
    if (lanes.touches_now[3] > 0) {
      EXPECT_EQ(begin, 0) << case_;
    }
    if (!(lanes.meets_first[3] > 0)) return;
    EXPECT_GE(begin, lanes.before[3]) << case_;
    EXPECT_LE(begin, lanes.after[3]) << case_;
  }

 private:
  template <class Answer>
  Answer ask(Answer (*question)(Formula&, const ExactMoments&)) const {
    const PairPolynomials<BoxBox<D>> polynomials(setup_, row_a_.data(), row_b_.data());
    Formula formula;
    polynomials.formula(formula);
    return question(formula, exact_moments_of(setup_, row_a_.data(), row_b_.data()));
  }

  void check_simd(const BoxLanes<D, 2>& lanes) const {
    const Simd usual = simd_in_use();
    for (const Simd simd : available_simd()) {
      BoxLanes<D, 2> others = lanes;
      use_simd(simd);
      settle(others);
      EXPECT_EQ(std::memcmp(&lanes, &others, sizeof lanes), 0) << name_of(simd) << ": " << case_;
    }
    use_simd(usual);
  }

  const Case& case_;
  std::vector<double> row_a_, row_b_;
  Setup setup_;
  Moments moments_;
  Relative<D> relative_;
};

template <int D>
void check_families(std::uint64_t seed) {
  Certain certain;
  for (const auto& families : {ordinary_families(), extreme_families()})
    for (const Family& family : families) {
      Generator generate(family, ++seed);
      for (int i = 0; i < 60; ++i) {
        const Case c = make_case(generate, family, Shapes::boxes, D);
        const LaneOfPair<D> lane(c);
        if (lane.from_now()) lane.check(certain);
      }
    }
  // A stage that is never certain would prove nothing.
  EXPECT_GT(certain.misses, 60);
  EXPECT_GT(certain.now, 20);
  EXPECT_GT(certain.meets, 60);
  EXPECT_GT(certain.first, 60);
}

TEST(BoxLanes, AreRightWhereCertainInOneDimension) {
  check_families<1>(1000);
}
TEST(BoxLanes, AreRightWhereCertainInTwoDimensions) {
  check_families<2>(2000);
}
TEST(BoxLanes, AreRightWhereCertainInThreeDimensions) {
  check_families<3>(3000);
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

/// A lane decides the same whatever its neighbours are, and wherever a batch ends.
TEST(BoxLanes, PairsAnswerAloneAsInABatch) {
  const Layout layout{.axes = 2, .law = Law::accelerated, .shape = Shape::box};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0, 8), speed(-3, 3);
  std::vector<double> rows;
  for (int i = 0; i < 21; ++i)
    for (const double number : {place(random), place(random), speed(random), speed(random), speed(random) / 6,
                                speed(random) / 6, 0.5, 0.5})
      rows.push_back(number);
  const Bodies bodies(layout, rows.data(), 21);
  const auto contact = make_contact(bodies, bodies, {.horizon = {0, 3}}, "a", "a");
  std::vector<Pair> pairs, hits;
  for (std::uint32_t a = 0; a < 21; ++a)
    for (std::uint32_t b = a + 1; b < 21; ++b) pairs.push_back({a, b});
  std::vector<ContactTimes> times;
  contact->first_contacts(pairs, TimesWanted::both, hits, times);
  std::vector<Pair> hits_alone;
  std::vector<ContactTimes> times_alone;
  for (const Pair& pair : pairs)
    contact->first_contacts({&pair, 1}, TimesWanted::both, hits_alone, times_alone);
  EXPECT_EQ(hits, hits_alone);
  ASSERT_GT(hits.size(), 10u);
  EXPECT_EQ(std::memcmp(times.data(), times_alone.data(), times.size() * sizeof times[0]), 0);
}

}  // namespace
}  // namespace foresee
