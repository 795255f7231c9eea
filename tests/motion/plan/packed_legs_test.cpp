#include "motion/plan/packed_legs.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <string>

#include "base/error.h"
#include "never_interrupt.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::never;

std::string refusal_of_blob(std::span<const std::byte> blob) {
  try {
    decode_plan(blob, never);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

void put(std::vector<std::byte>& blob, std::size_t at, double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number);
  for (std::size_t i = 0; i < 8; ++i) blob[at + i] = std::byte(bits >> (8 * i));
}

Plan random_plan(testing::Random& random) {
  Plan plan{.kind = PlanKind(random.below(3)), .axes = 1 + static_cast<int>(random.below(3))};
  const auto vector = [&] {
    std::array<double, 3> numbers{};
    for (std::size_t j = 0; j < static_cast<std::size_t>(plan.axes); ++j) numbers[j] = random.in(-9, 9);
    return numbers;
  };
  double t = random.in(-9, 9);
  for (std::uint64_t i = 1 + random.below(40); i > 0; --i) {
    const double until = t + random.unit() + 0.01;
    plan.knots.push_back({t, vector()});
    plan.legs.push_back({t, i == 1 && random.below(2) ? no_end : until, vector(), vector(), {}});
    if (plan.kind == PlanKind::accelerated) plan.legs.back().a = vector();
    t = until + (random.below(3) ? 0 : 1);
  }
  plan.knots.push_back({random.below(2) ? t : no_end, plan.knots.back().x});
  if (plan.kind == PlanKind::knots) plan.legs.clear();
  if (plan.kind != PlanKind::knots) plan.knots.clear();
  return plan;
}

TEST(PackedLegs, ReadBackTheSame) {
  testing::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Plan plan = random_plan(random);
    const std::vector<std::byte> blob = encode_plan(plan, never);
    ASSERT_EQ(decode_plan(blob, never), plan);
    ASSERT_EQ(encode_plan(decode_plan(blob, never), never), blob);
  }
}

TEST(PackedLegs, HaveTheDocumentedBytes) {
  const Plan plan{.kind = PlanKind::knots, .axes = 1, .knots = {{0, {1}}, {2, {-0.0}}}};
  const std::vector<std::byte> blob = encode_plan(plan, never);
  const unsigned char expected[] = {'p', 'l', 1, 1,    0, 0, 0, 0, 0,    0,    0, 0,   0, 0,
                                    0,   0,   0, 0,    0, 0, 0, 0, 0xf0, 0x3f, 0, 0,   0, 0,
                                    0,   0,   0, 0x40, 0, 0, 0, 0, 0,    0,    0, 0x80};
  ASSERT_EQ(blob.size(), sizeof expected);
  EXPECT_EQ(std::memcmp(blob.data(), expected, sizeof expected), 0);
}

TEST(PackedLegs, HaveNoNumbersBetweenTwoParts) {
  const Plan plan{
      .kind = PlanKind::knots,
      .axes = 2,
      .knots = {{0, {0, 0}}, {1, {1, 3}}, {5, {7, 7}}, {6, {7, 8}}, {6, {0, 0}}, {no_end, {0, 0}}},
      .part_starts = {0, 2, 4}};
  const std::vector<std::byte> blob = encode_plan(plan, never);
  EXPECT_EQ(blob.size(), 8 + 24 * 8u);
  EXPECT_EQ(decode_plan(blob, never), plan);
  // A separator at either end, next to another one, behind one knot.
  for (std::size_t knot : {0, 1, 3, 4, 6, 7}) {
    std::vector<std::byte> other = blob;
    for (std::size_t i = 0; i < 3; ++i) put(other, 8 + 24 * knot + 8 * i, std::nan(""));
    EXPECT_NE(refusal_of_blob(other), "") << knot;
  }
  std::vector<std::byte> half = blob;
  put(half, 8 + 24 * 2 + 16, 7);
  EXPECT_EQ(refusal_of_blob(half), "byte 56: not a finite number");
}

TEST(PackedLegs, SayWhatIsWrong) {
  const Plan knots{.kind = PlanKind::knots, .axes = 2, .knots = {{0, {0, 0}}, {5, {10, 0}}, {9, {10, 0}}}};
  const std::vector<std::byte> good = encode_plan(knots, never);
  EXPECT_EQ(refusal_of_blob({}), "an empty blob is no plan");
  EXPECT_EQ(refusal_of_blob(std::vector<std::byte>(9)),
            "a blob of 9 bytes that does not start with 'pl' is no plan: write one of plan_points");
  EXPECT_EQ(refusal_of_blob(std::span(good).first(7)),
            "a blob of 7 bytes that does not start with 'pl' is no plan: write one of plan_points");
  EXPECT_EQ(refusal_of_blob(std::span(good).first(8)),
            "a plan without knots: write two, or NULL and a plain row");
  EXPECT_EQ(refusal_of_blob(std::span(good).first(32)), "part 1 has one knot: write two, or a plain row");
  EXPECT_EQ(refusal_of_blob(std::span(good).first(40)), "a blob of 40 bytes: write 8 bytes and 24 per knot");
  const auto with = [&](std::size_t at, int value) {
    std::vector<std::byte> blob = good;
    blob[at] = std::byte(value);
    return refusal_of_blob(blob);
  };
  EXPECT_EQ(with(2, 2), "byte 2 is 2, a format that this version does not know; write 1");
  EXPECT_EQ(with(3, 0), "byte 3 is 0 axes; write 1, 2 or 3");
  EXPECT_EQ(with(3, 4), "byte 3 is 4 axes; write 1, 2 or 3");
  EXPECT_EQ(with(4, 3), "byte 4 is 3, no kind of plan; write 0, 1 or 2");
  EXPECT_EQ(with(4, 1), "a blob of 80 bytes: write 8 bytes and 48 per leg");
  EXPECT_EQ(with(6, 1), "byte 6 is 1; write 0");
  const auto with_number = [&](std::size_t at, double value) {
    std::vector<std::byte> blob = good;
    put(blob, at, value);
    return refusal_of_blob(blob);
  };
  EXPECT_EQ(with_number(24, std::nan("")), "byte 24: not a finite number");
  EXPECT_EQ(with_number(24, no_end), "byte 24: not a finite number");
  EXPECT_EQ(with_number(8, no_end), "byte 8: not a finite number");
  EXPECT_EQ(with_number(56, -no_end), "byte 56: not a finite number");
  EXPECT_EQ(with_number(56, no_end), "");
  EXPECT_EQ(with_number(64, 11), "");
  EXPECT_EQ(with_number(56, 5),
            "knot 3: t is 5 after 5: times must rise; write MULTILINESTRING M for a jump");
  Plan legs{.kind = PlanKind::accelerated, .axes = 1};
  legs.legs = {{0, no_end, {}, {}, {}}, {5, 9, {}, {}, {}}};
  EXPECT_EQ(refusal_of_blob(encode_plan(legs, never)), "byte 16: not a finite number");
}

}  // namespace
}  // namespace foresee
