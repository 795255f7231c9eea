// Every stage of contact alone, on the families of hard_pairs.h: where it is certain it agrees with the exact
// one.
//
// Chord and certified double against the exact stage; its 128 bits against integers; and the begin and end
// that doubles vouch for against those of the exact stage, bit for bit.
#include <gtest/gtest.h>

#include "contact/ball_ball.h"
#include "contact/box_ball.h"
#include "contact/box_box.h"
#include "contact/cylinder_box.h"
#include "contact/cylinder_cylinder.h"
#include "contact/exact_contact.h"
#include "contact/hard_pairs.h"
#include "contact/track.h"

namespace foresee {
namespace {

using namespace testing_pairs;

/// How often each stage was certain.
struct Certain {
  int chord = 0, track = 0, wide = 0, times = 0;
};

template <class Kind, int Degree>
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
               c.question.within,
               c.question.within_z.value_or(0)},
        polynomials_(setup_, row_a_.data(), row_b_.data()),
        moments_(moments_of(setup_, row_a_.data(), row_b_.data())) {}

  void check() {
    if (moments_.none) return;
    Formula formula;
    polynomials_.formula(formula);
    const ExactMoments exact = exact_moments_of(setup_, row_a_.data(), row_b_.data());
    const bool touches = exact_touches(formula, exact);
    check_doubles(touches);
    check_wide(formula, exact);
    if (touches) check_times(exact);
  }

 private:
  void check_doubles(bool touches) {
    const Track<Kind, Degree> track(setup_, row_a_.data(), row_b_.data(), moments_);
    const ChordVisitor<Kind::axes> chord(track.relative(), moments_.dt_begin, moments_.dt_end);
    if (moments_.begin_exact && moments_.end_exact && Kind::visit(track.sizes(), chord).none()) {
      ++certain_.chord;
      EXPECT_FALSE(touches) << "chord: " << case_;
    }
    Bracket first;
    for (const Verdict verdict : {track.touches(), track.first_contact(first)}) {
      if (verdict == Verdict::uncertain) continue;
      ++certain_.track;
      EXPECT_EQ(verdict == Verdict::yes, touches) << "certified double: " << case_;
    }
  }

  void check_wide(Formula& formula, const ExactMoments& exact) {
    for (Curve& curve : formula.curves)
      for (const Dyadic& moment : {exact.begin, exact.end}) {
        const int sign = curve.value_at(Wide(moment)).sign();
        if (sign == unknown_sign) continue;
        ++certain_.wide;
        EXPECT_EQ(sign, sign_at(curve.exact(), moment)) << "128 bits: " << case_;
      }
  }

  void check_times(const ExactMoments& exact) {
    Formula formula;
    polynomials_.formula(formula);
    const auto times = exact_times(formula, exact);
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
  PairPolynomials<Kind> polynomials_;
  Moments moments_;
};

template <class Kind>
void check_kind(Shapes shapes, std::uint64_t seed) {
  Certain certain;
  for (const auto& families : {ordinary_families(), extreme_families()})
    for (const Family& family : families) {
      Generator generate(family, ++seed);
      for (int i = 0; i < 40; ++i) {
        const Case c = make_case(generate, family, shapes, Kind::axes);
        if (std::max(c.a.layout.law, c.b.layout.law) <= Law::uniform)
          StagesOfPair<Kind, 1>(c, certain).check();
        else
          StagesOfPair<Kind, 2>(c, certain).check();
      }
    }
  // A stage that is never certain would prove nothing.
  EXPECT_GT(certain.chord, 20);
  EXPECT_GT(certain.track, 100);
  EXPECT_GT(certain.wide, 1000);
  EXPECT_GT(certain.times, 50);
}

TEST(Stages, BoxesInOneDimension) {
  check_kind<BoxBox<1>>(Shapes::boxes, 100);
}
TEST(Stages, BoxesInTwoDimensions) {
  check_kind<BoxBox<2>>(Shapes::boxes, 200);
}
TEST(Stages, BoxesInThreeDimensions) {
  check_kind<BoxBox<3>>(Shapes::boxes, 300);
}
TEST(Stages, BallsInTwoDimensions) {
  check_kind<BallBall<2>>(Shapes::balls, 400);
}
TEST(Stages, BallsInThreeDimensions) {
  check_kind<BallBall<3>>(Shapes::balls, 500);
}
TEST(Stages, BoxAndBallInTwoDimensions) {
  check_kind<BoxBall<2>>(Shapes::box_and_ball, 600);
}
TEST(Stages, BoxAndBallInThreeDimensions) {
  check_kind<BoxBall<3>>(Shapes::box_and_ball, 700);
}
TEST(Stages, Cylinders) {
  check_kind<CylinderCylinder>(Shapes::cylinders, 800);
}
TEST(Stages, CylinderAndBox) {
  check_kind<CylinderBox>(Shapes::cylinder_and_box, 900);
}

/// Whatever is done to numbers of 128 bits, the exact result lies within their error.
TEST(Wide, EnclosesWhatIsExact) {
  std::mt19937_64 random(7);
  const auto number = [&random] {
    const auto whole = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 50));
    return std::ldexp(whole, static_cast<int>(random() % 200) - 100);
  };
  const auto encloses = [](const Wide& w, const Dyadic& exact) {
    return w.low().dyadic() <= exact && exact <= w.high().dyadic();
  };
  for (int i = 0; i < 20000; ++i) {
    const double a = number(), b = number(), c = number(), d = number();
    const Wide w = Wide(a) * Wide(b) + Wide(c) * Wide(d);
    const Dyadic exact = Dyadic(a) * Dyadic(b) + Dyadic(c) * Dyadic(d);
    ASSERT_TRUE(encloses(w, exact)) << a << " " << b << " " << c << " " << d;
    ASSERT_TRUE(encloses(w * w, exact * exact));
    if (w.sign() != unknown_sign) {
      ASSERT_EQ(w.sign(), exact.sign());
    }
    if (Wide(c).sign() != 0) {
      const Wide quotient = w / Wide(c), back = quotient * Wide(c);
      ASSERT_TRUE(encloses(back, exact));
    }
    const Wide root = sqrt(w * w);
    ASSERT_TRUE(encloses(root, w.side() < 0 ? -exact : exact));
    ASSERT_EQ(w.middle().rounded(), rounded(w.middle().dyadic()));
  }
}

TEST(Wide, FewDigitsStayExact) {
  const Wide tenth(0.1);
  EXPECT_EQ((tenth * tenth - tenth * tenth).sign(), 0);
  EXPECT_TRUE((Wide(3) * Wide(0x1p-900) * Wide(5e300)).exact());
  EXPECT_EQ((Wide(1e300) + Wide(1e-300) - Wide(1e300)).sign(), unknown_sign);
}

}  // namespace
}  // namespace foresee
