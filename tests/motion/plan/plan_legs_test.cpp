// The velocity of a leg against integers of 128 bits and rationals; the rules of plans and their messages.
#include "motion/plan/plan_legs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

__extension__ using Wide = __int128;

/// A difference of two doubles that are multiples of 2^-10, in units of that.
Wide units(double a, double b) {
  return static_cast<Wide>(std::ldexp(a, 10)) - static_cast<Wide>(std::ldexp(b, 10));
}

/// Whether v is dx / dt rounded once, ties to even: dx lies between dt times the middles of v and its neighbours.
bool is_nearest(double v, Wide dx, Wide dt) {
  if (dx < 0) v = -v, dx = -dx;
  int exponent;
  const auto mantissa = static_cast<Wide>(std::ldexp(std::frexp(v, &exponent), 53));
  exponent -= 55;  // v = 4 mantissa 2^exponent
  const Wide below = 4 * mantissa - (mantissa == Wide(1) << 52 ? 1 : 2), above = 4 * mantissa + 2;
  const Wide scaled = exponent < 0 ? dx << -exponent : dx;
  const Wide unit = exponent < 0 ? dt : dt << exponent;
  const Wide low = below * unit, high = above * unit;
  return mantissa % 2 == 0 ? low <= scaled && scaled <= high : low < scaled && scaled < high;
}

/// A multiple of 2^-10 below 2^53 in size.
double coordinate(judge::Inputs& inputs) {
  const int bits = inputs.between(1, 53);
  return inputs.sign() *
         std::ldexp(std::floor(std::ldexp(1 + std::abs(inputs.number(0, 0)), bits)), -inputs.between(0, 10));
}

TEST(PlanVelocity, IsTheQuotientRoundedOnce) {
  judge::Inputs inputs(1);
  int with_tails = 0;
  for (int i = judge::cases(1'000'000); i > 0; --i) {
    const double from = coordinate(inputs), to = coordinate(inputs);
    double t0 = coordinate(inputs), t1 = coordinate(inputs);
    if (t1 < t0) std::swap(t0, t1);
    if (t0 == t1 || from == to) continue;
    const double v = velocity_between(from, to, t0, t1);
    if (v != (to - from) / (t1 - t0)) ++with_tails;
    ASSERT_TRUE(is_nearest(v, units(to, from), units(t1, t0)))
        << std::hexfloat << from << ' ' << to << ' ' << t0 << ' ' << t1 << ' ' << v;
  }
  EXPECT_GT(with_tails, 1000);  // where a quotient of rounded differences would be wrong
}

/// Quotients exactly between two doubles, whose differences no double holds, and their neighbours.
TEST(PlanVelocity, RoundsTiesToEven) {
  judge::Inputs inputs(2);
  for (int i = judge::cases(20'000); i > 0; --i) {
    const auto half = (std::int64_t(1) << 53) + 2 * inputs.below(1 << 30) * (std::int64_t(1) << 20) +
                      2 * inputs.below(99) + 1;
    const std::int64_t dt = inputs.between(1, 255), dx = half * dt + inputs.between(-1, 1);
    const double low = static_cast<double>(dx % (1 << 20)), high = static_cast<double>(dx - dx % (1 << 20));
    const double v = velocity_between(-low, high, -1.0, static_cast<double>(dt - 1));
    ASSERT_TRUE(is_nearest(v, static_cast<Wide>(dx) << 10, static_cast<Wide>(dt) << 10)) << dx << ' ' << dt;
  }
}

TEST(PlanVelocity, IsRoundedOnceForEveryDouble) {
  judge::Inputs inputs(3);
  int infinite = 0, subnormal = 0;
  for (int i = judge::cases(5'000); i > 0; --i) {
    const double from = inputs.any_double(), to = inputs.one_in(4) ? -from : inputs.any_double();
    double t0 = inputs.any_double(), t1 = inputs.one_in(4) ? std::nextafter(t0, 1e300) : inputs.any_double();
    if (t1 < t0) std::swap(t0, t1);
    if (!(t0 < t1)) continue;
    const double v = velocity_between(from, to, t0, t1);
    const judge::Rational quotient =
        (judge::rational(to) - judge::rational(from)) / (judge::rational(t1) - judge::rational(t0));
    ASSERT_EQ(v, judge::nearest_double(quotient))
        << std::hexfloat << from << ' ' << to << ' ' << t0 << ' ' << t1;
    ASSERT_FALSE(v == 0 && std::signbit(v));
    infinite += std::isinf(v), subnormal += v != 0 && std::abs(v) < 0x1p-1022;
  }
  EXPECT_GT(infinite, judge::cases(5'000) / 100);
  EXPECT_GE(subnormal, judge::cases(5'000) / 1000);
}

TEST(PlanVelocity, IsZeroForAMoverAtRest) {
  EXPECT_EQ(velocity_between(7, 7, 1, 3), 0);
  EXPECT_EQ(velocity_between(7, 7, 1, no_end), 0);
  EXPECT_FALSE(std::signbit(velocity_between(0.0, -0.0, 1, 3)));
  EXPECT_FALSE(std::signbit(velocity_between(5e-324, 0, 0, 1e9)));
}

Plan knots(std::vector<Knot> list, std::vector<std::size_t> part_starts = {0}) {
  return {
      .kind = PlanKind::knots, .axes = 2, .knots = std::move(list), .part_starts = std::move(part_starts)};
}

std::string refusal_of_legs(const Plan& plan) {
  try {
    check_plan(plan);
    legs_of(plan);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PlanLegs, JoinTheKnots) {
  const Plan plan = knots({{0, {0, 0}}, {5, {10, 0}}, {9, {10, 0}}, {12, {1, 2}}, {13, {1, 3}}}, {0, 3});
  EXPECT_EQ(refusal_of_legs(plan), "");
  const std::vector<Leg> legs = legs_of(plan);
  ASSERT_EQ(legs.size(), 3u);
  EXPECT_EQ(leg_count(plan), 3u);
  EXPECT_EQ(legs[0], (Leg{0, 5, {0, 0}, {2, 0}, {}}));
  EXPECT_EQ(legs[1], (Leg{5, 9, {10, 0}, {0, 0}, {}}));
  EXPECT_EQ(legs[2], (Leg{12, 13, {1, 2}, {0, 1}, {}}));
}

TEST(PlanLegs, SayWhatIsWrong) {
  EXPECT_EQ(refusal_of_legs(knots({})), "a plan without knots: write two, or NULL and a plain row");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}})), "part 1 has one knot: write two, or a plain row");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {5, {}}, {6, {}}, {5, {}}})),
            "knot 4: t is 5 after 6: times must rise; write MULTILINESTRING M for a jump");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {5, {}}, {5, {}}, {5, {}}}, {0, 2})),
            "knot 2 of part 2: t is 5 after 5: times must rise; write MULTILINESTRING M for a jump");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {5, {}}, {4, {}}, {6, {}}}, {0, 2})),
            "part 2 starts at 4, before part 1 ends at 5");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {5, {}}, {5, {7, 7}}, {6, {}}}, {0, 2})), "");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {no_end, {1, 0}}})),
            "knot 2: t is inf, but its place is not that of knot 1: write the place where the mover stays");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {no_end, {}}, {no_end, {}}})),
            "knot 3: t is inf after inf: times must rise; write MULTILINESTRING M for a jump");
  EXPECT_EQ(refusal_of_legs(knots({{0, {}}, {1, {}}, {2, {-1e308, 0}}, {3, {1e308, 0}}})),
            "leg 3 from -1e+308 to 1e+308: no double holds its velocity");
  Plan legs{.kind = PlanKind::uniform, .axes = 2};
  EXPECT_EQ(refusal_of_legs(legs), "a plan without legs: write one, or NULL and a plain row");
  legs.legs = {{0, 5, {}, {}, {}}, {5, 5, {}, {}, {}}, {5, 9, {}, {}, {}}};
  EXPECT_EQ(refusal_of_legs(legs), "");
  legs.legs[2].t = 4;
  EXPECT_EQ(refusal_of_legs(legs), "leg 3 starts at 4, before leg 2 ends at 5");
  legs.legs[2].t = 10;
  EXPECT_EQ(refusal_of_legs(legs), "leg 3 ends at 9, before it starts at 10");
}

TEST(PlanLegs, HaveALimit) {
  Plan plan = knots(std::vector<Knot>(max_plan_legs + 1));
  EXPECT_NO_THROW(check_size(plan));
  plan.knots.emplace_back();
  try {
    check_size(plan);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "1048577 legs; at most 1048576: cut it with plan_cut");
  }
}

}  // namespace
}  // namespace foresee
