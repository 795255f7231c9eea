// Every stage of contact alone, on the families of hard_pairs.h: a certain answer is that of the exact stage.
//
// Compared with the exact stage are the chord, certified doubles and the lanes; and, bit for bit, start and
// end from doubles. The 128-bit numbers of the exact stage are compared with integers.
#include <gtest/gtest.h>

#include <cstring>

#include "contact/certified/chord.h"
#include "contact/exact/exact_contact.h"
#include "contact/hard_pairs.h"
#include "contact/minkowski/contact_set.h"
#include "contact/set/set_lanes.h"
#include "contact/set/set_pair.h"
#include "every_simd.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// The number of certain answers of each stage.
struct Certain {
  int chord = 0, lanes_miss = 0, lanes_touch = 0, lanes_start = 0, doubles = 0, in_128_bits = 0, times = 0;
};

template <int D, int Degree>
class StagesOfPair {
 public:
  StagesOfPair(const Case& c, Certain& certain)
      : case_(c),
        certain_(certain),
        row_a_(c.a.row()),
        row_b_(c.b.row()),
        setup_{{c.a.layout, row_a_.data(), 1},
               {c.b.layout, row_b_.data(), 1},
               c.question.horizon,
               PairRule(c.a.layout, c.b.layout, c.question.within, c.question.within_z)},
        set_(contact_set(setup_)),
        lifetime_(pair_lifetime_of(setup_, row_a_.data(), row_b_.data())) {}

  void check() {
    if (lifetime_.none) return;
    PairPolynomials polynomials(setup_, row_a_.data(), row_b_.data(), {set_, row_a_.data(), row_b_.data()});
    const ExactLifetime exact = exact_lifetime_of(setup_, row_a_.data(), row_b_.data());
    const bool touches = exact_touches(polynomials, exact);
    check_doubles(touches);
    check_lanes(touches, exact);
    check_128_bits(polynomials, exact);
    if (touches) check_times(exact);
  }

 private:
  void check_doubles(bool touches) {
    SetPieces pieces;
    pieces.load(set_, row_a_.data(), row_b_.data());
    const SetPairContext<D, Degree> context(
        {setup_, row_a_.data(), row_b_.data(), pieces, pieces, lifetime_, any_time, true, steps_});
    const Chord<D> chord(context.relative, lifetime_.dt_end);
    const auto hull = set_.hull();
    const Interval<double> near = chord.between(hull.data(), static_cast<int>(hull.size()), pieces.lengths(),
                                                {lifetime_.dt_start, lifetime_.dt_end});
    if (lifetime_.start_exact && lifetime_.end_exact && near.begin > near.end) {
      ++certain_.chord;
      EXPECT_FALSE(touches) << "chord: " << case_;
    }
    SetSpace space;
    for (const Verdict verdict : {SetPair<D, Degree>(context, space).touches(),
                                  SetPair<D, Degree>(context, space).first_contact().touches}) {
      if (verdict == Verdict::uncertain) continue;
      ++certain_.doubles;
      EXPECT_EQ(verdict == Verdict::yes, touches) << "certified double: " << case_;
    }
  }

  void check_lanes(bool touches, const ExactLifetime& exact) {
    const AllLengths<Bounded> lengths(set_);
    std::vector<LanesLine> space(lanes_space(set_));
    LanesQuestion question{.a = setup_.a.at,
                           .b = setup_.b.at,
                           .now = setup_.horizon.now,
                           .h = setup_.horizon.h,
                           .set = set_.arrays(),
                           .lengths = lengths.data(),
                           .times_wanted = false,
                           .space = reinterpret_cast<double*>(space.data())};
    SetLanes lanes;
    std::fill_n(lanes.a, lanes.width, row_a_.data());
    std::fill_n(lanes.b, lanes.width, row_b_.data());
    set_kernel<D, Degree>().classify(question, lanes);
    expect_from_every_cpu(question, lanes);
    for (const int l : {0, 13}) {
      const bool misses = lanes.begin[l] > lanes.end[l];
      certain_.lanes_miss += misses, certain_.lanes_touch += lanes.touches[l] > 0;
      EXPECT_FALSE(misses && touches) << "side by side: " << case_;
      EXPECT_TRUE(touches || !(lanes.touches[l] > 0)) << "side by side: " << case_;
    }
    question.times_wanted = true;
    set_kernel<D, Degree>().classify(question, lanes);
    expect_from_every_cpu(question, lanes);
    const bool at_start = lanes.touches[0] > 0;
    certain_.lanes_start += at_start;
    EXPECT_TRUE(touches || !at_start) << "side by side: " << case_;
    if (!touches) return;
    PairPolynomials polynomials(setup_, row_a_.data(), row_b_.data(), {set_, row_a_.data(), row_b_.data()});
    const auto times = exact_times(polynomials, exact);
    ASSERT_TRUE(times) << case_;
    EXPECT_TRUE(!at_start || times->dt == 0) << "side by side: " << case_;
    EXPECT_GE(times->dt, lanes.begin[0]) << case_;
    EXPECT_LE(times->dt_end, lanes.end[0] * (1 + 0x1p-52)) << case_;
  }

  void expect_from_every_cpu(const LanesQuestion& question, const SetLanes& lanes) const {
    testing::for_every_simd([&](Simd) {
      SetLanes others = lanes;
      set_kernel<D, Degree>().classify(question, others);
      EXPECT_EQ(std::memcmp(&lanes, &others, sizeof lanes), 0) << case_;
    });
  }

  void check_128_bits(PairPolynomials& polynomials, const ExactLifetime& exact) {
    for (int i = 0; i < static_cast<int>(set_.primitives().size()); ++i)
      for (const Dyadic& time : {exact.begin, exact.end}) {
        LazyPolynomial& polynomial = polynomials.polynomial(polynomials.number_of(i));
        const int sign = polynomial.value_at(Midrad128(time)).sign();
        if (sign == unknown_sign) continue;
        ++certain_.in_128_bits;
        EXPECT_EQ(sign, sign_at(polynomial.exact(), time)) << "128 bits: " << case_;
      }
  }

  void check_times(const ExactLifetime& exact) {
    PairPolynomials polynomials(setup_, row_a_.data(), row_b_.data(), {set_, row_a_.data(), row_b_.data()});
    const auto times = exact_times(polynomials, exact);
    ASSERT_TRUE(times) << case_;
    const auto answer = contact(case_.a, case_.b, case_.question);
    ASSERT_TRUE(answer) << case_;
    ++certain_.times;
    EXPECT_EQ(answer->dt, times->dt) << case_;
    EXPECT_EQ(answer->t, times->t) << case_;
    EXPECT_EQ(answer->dt_end, times->dt_end) << case_;
    EXPECT_EQ(answer->t_end, times->t_end) << case_;
  }

  const Case& case_;
  Certain& certain_;
  std::vector<double> row_a_, row_b_;
  Setup setup_;
  ContactSet set_;
  PairLifetime lifetime_;
  NeverInterrupt never_;
  Steps steps_{never_};
};

template <int D>
void check_kind(Shapes shapes, std::uint64_t seed) {
  Certain certain;
  const auto look = [&](const Case& c, const Generator&) {
    if (std::max(c.a.layout.law, c.b.layout.law) <= Law::uniform)
      StagesOfPair<D, 1>(c, certain).check();
    else
      StagesOfPair<D, 2>(c, certain).check();
  };
  for_each_hard_pair(shapes, D, 40, seed, look);
  for (const Family& family : growing_families()) {
    Generator generate(family, ++seed);
    for (int i = 0; i < 20; ++i) look(make_case(generate, family, shapes, D), generate);
  }
  // A stage that is never certain would prove nothing.
  EXPECT_GT(certain.chord, 20);
  EXPECT_GT(certain.lanes_miss, 40);
  EXPECT_GT(certain.lanes_touch, 40);
  EXPECT_GT(certain.lanes_start, 20);
  EXPECT_GT(certain.doubles, 100);
  EXPECT_GT(certain.in_128_bits, 1000);
  EXPECT_GT(certain.times, 50);
}

TEST(Stages, BoxesInOneDimension) {
  check_kind<1>(Shapes::boxes, 100);
}
TEST(Stages, BoxesInTwoDimensions) {
  check_kind<2>(Shapes::boxes, 200);
}
TEST(Stages, BoxesInThreeDimensions) {
  check_kind<3>(Shapes::boxes, 300);
}
TEST(Stages, BallsInTwoDimensions) {
  check_kind<2>(Shapes::balls, 400);
}
TEST(Stages, BallsInThreeDimensions) {
  check_kind<3>(Shapes::balls, 500);
}
TEST(Stages, BoxAndBallInTwoDimensions) {
  check_kind<2>(Shapes::box_and_ball, 600);
}
TEST(Stages, BoxAndBallInThreeDimensions) {
  check_kind<3>(Shapes::box_and_ball, 700);
}
TEST(Stages, Cylinders) {
  check_kind<3>(Shapes::cylinders, 800);
}
TEST(Stages, CylinderAndBox) {
  check_kind<3>(Shapes::cylinder_and_box, 900);
}

/// The exact result of any operation on 128-bit numbers is within their error.
TEST(Midrad128, EnclosesWhatIsExact) {
  std::mt19937_64 random(7);
  const auto number = [&random] {
    const auto whole = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 50));
    return std::ldexp(whole, static_cast<int>(random() % 200) - 100);
  };
  const auto encloses = [](const Midrad128& w, const Dyadic& exact) {
    return w.low().dyadic() <= exact && exact <= w.high().dyadic();
  };
  for (int i = 0; i < 20000; ++i) {
    const double a = number(), b = number(), c = number(), d = number();
    const Midrad128 w = Midrad128(a) * Midrad128(b) + Midrad128(c) * Midrad128(d);
    const Dyadic exact = Dyadic(a) * Dyadic(b) + Dyadic(c) * Dyadic(d);
    ASSERT_TRUE(encloses(w, exact)) << a << " " << b << " " << c << " " << d;
    ASSERT_TRUE(encloses(w * w, exact * exact));
    if (w.sign() != unknown_sign) {
      ASSERT_EQ(w.sign(), exact.sign());
    }
    if (Midrad128(c).sign() != 0) {
      const Midrad128 quotient = w / Midrad128(c), back = quotient * Midrad128(c);
      ASSERT_TRUE(encloses(back, exact));
    }
    const Midrad128 root = sqrt(w * w);
    ASSERT_TRUE(encloses(root, w.side() < 0 ? -exact : exact));
    ASSERT_EQ(w.middle().rounded(), rounded(w.middle().dyadic()));
  }
}

TEST(Midrad128, FewDigitsRemainExact) {
  const Midrad128 tenth(0.1);
  EXPECT_EQ((tenth * tenth - tenth * tenth).sign(), 0);
  EXPECT_TRUE((Midrad128(3) * Midrad128(0x1p-900) * Midrad128(5e300)).exact());
  EXPECT_EQ((Midrad128(1e300) + Midrad128(1e-300) - Midrad128(1e300)).sign(), unknown_sign);
}

}  // namespace
}  // namespace foresee
