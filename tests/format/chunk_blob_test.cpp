// Stored chunk of a plan: round trip through its bytes, and faults of other bytes.
#include "format/chunk_blob.h"

#include <cstring>

#include "base/float_environment.h"
#include "format/crc32c.h"
#include "storage/plan_cases.h"

namespace foresee {
namespace {

Layout layout_of(const Plan& plan) {
  Layout layout = fleet(Law::accelerated).layout;
  layout.axes = plan.axes;
  return layout;
}

using Blobs = std::vector<std::vector<std::byte>>;

Blobs blobs_of(const Plan& plan, std::int64_t first = 5) {
  const ChunkWriter writer(plan, 42);
  Blobs blobs;
  for (std::size_t i = 0; i < writer.chunks(); ++i)
    blobs.push_back(writer.blob(i, first + static_cast<std::int64_t>(i)));
  return blobs;
}

/// What is wrong with a blob of row `number`, in both ways of reading.
std::string fault_of(const Layout& layout, std::span<const std::byte> blob, std::int64_t number = 5) {
  const FloatEnvironment environment;
  StoredChunk chunk;
  if (const char* fault = open_chunk(layout, blob, number, chunk)) return fault;
  std::vector<Leg> legs;
  const char* const of_legs = append_legs(chunk, legs);
  Plan plan{.part_starts = {0}};
  const char* const of_plan = chunk.is_first ? append_to_plan(chunk, plan) : of_legs;
  EXPECT_STREQ(of_legs ? of_legs : "", of_plan ? of_plan : "");
  return of_legs ? of_legs : "";
}

std::vector<std::byte> resealed(std::vector<std::byte> blob, std::int64_t number = 5) {
  std::uint32_t checksum = crc32c(blob.data(), blob.size() - 4);
  checksum = crc32c(&number, sizeof number, checksum);
  std::memcpy(blob.data() + blob.size() - 4, &checksum, sizeof checksum);
  return blob;
}

template <class T>
std::vector<std::byte> replaced_at(std::vector<std::byte> blob, std::size_t at, T value) {
  std::memcpy(blob.data() + at, &value, sizeof value);
  return resealed(std::move(blob));
}

/// Expects the legs of some times to be those of all legs that exist then.
void expect_legs_of_times(const Plan& plan, const std::vector<Leg>& all) {
  const std::vector<double> joints = {all.front().t, all[all.size() / 2].t, all.back().t, all.back().until};
  for (const double from : joints)
    for (const double until : joints) {
      if (until < from) continue;
      std::vector<Leg> expected, legs, of_part;
      std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
                   [&](const Leg& leg) { return leg.t <= until && from <= leg.until; });
      std::int64_t number = 5;
      for (const auto& blob : blobs_of(plan)) {
        StoredChunk chunk;
        ASSERT_EQ(open_chunk(layout_of(plan), blob, number++, chunk), nullptr);
        ASSERT_EQ(append_legs(chunk, legs, {from, until}), nullptr);
        ASSERT_EQ(check_legs(chunk), nullptr);
        const StoredChunk part = legs_during(chunk, {from, until});
        ASSERT_TRUE(1 <= part.legs && part.legs <= chunk.legs);
        ASSERT_EQ(append_legs(part, of_part, {from, until}), nullptr);
      }
      ASSERT_EQ(legs, expected);
      ASSERT_EQ(of_part, expected);
    }
}

TEST(ChunkBlob, PlansAndLegsReadBackBitForBit) {
  const FloatEnvironment environment;
  testing::Random random(1);
  std::size_t chunks = 0;
  for (int i = 0; i < 3000; ++i) {
    const Plan plan =
        random_stored_plan(random, 1 + static_cast<int>(random.below(3)), PlanKind(random.below(3)));
    const Layout layout = layout_of(plan);
    Plan read{.part_starts = {0}};
    std::vector<Leg> legs;
    std::int64_t number = 5;
    for (const auto& blob : blobs_of(plan)) {
      StoredChunk chunk;
      ASSERT_EQ(open_chunk(layout, blob, number, chunk), nullptr);
      EXPECT_EQ(chunk.is_first, number == 5);
      EXPECT_EQ(chunk.object, 42);
      ASSERT_EQ(append_legs(chunk, legs), nullptr);
      ASSERT_EQ(append_to_plan(chunk, read), nullptr);
      ++number, ++chunks;
    }
    if (plan.kind == PlanKind::knots) {
      ASSERT_EQ(read.part_starts.back(), read.knots.size());
      read.part_starts.pop_back();
    }
    ASSERT_TRUE(same_plan(read, plan)) << i;
    ASSERT_EQ(legs, legs_of(plan)) << i;
    expect_legs_of_times(plan, legs);
  }
  EXPECT_GT(chunks, 9000u);
}

TEST(ChunkBlob, ALegOfKnotsInThePlaneTakes24Bytes) {
  std::vector<Knot> knots;
  for (int i = 0; i <= 160; ++i) knots.push_back({1.0 * i, {1.0 * i, 2}});
  const Blobs blobs = blobs_of(plan_of_knots(knots));
  ASSERT_EQ(blobs.size(), 10u);
  EXPECT_EQ(blobs[0].size(), 16 + (8 + 8 * 10) + 24 * 17 + 4u);
  EXPECT_EQ(blobs[1].size(), 16 + 24 * 17 + 4u);
}

TEST(ChunkBlob, TheFirstChunkHasTheStartsOfAll) {
  testing::Random random(2);
  const Plan plan = random_stored_plan(random, 2, PlanKind::uniform, 200);
  const ChunkWriter writer(plan, 42);
  StoredChunk chunk;
  ASSERT_EQ(open_chunk(layout_of(plan), writer.blob(0, 5), 5, chunk), nullptr);
  ASSERT_EQ(chunk.plan_chunks, writer.chunks());
  EXPECT_EQ(chunk.plan_legs, plan.legs.size());
  // The blob is gone: `starts` pointed into it.
  const auto blob = writer.blob(0, 5);
  ASSERT_EQ(open_chunk(layout_of(plan), blob, 5, chunk), nullptr);
  for (std::size_t i = 0; i < writer.chunks(); ++i) EXPECT_EQ(chunk.start(i), writer.legs(i).front().t);
}

TEST(ChunkBlob, EveryChangedByteIsDetected) {
  testing::Random random(3);
  const Plan plan = random_stored_plan(random, 2, PlanKind::knots);
  const auto blob = blobs_of(plan)[0];
  for (std::size_t i = 0; i < blob.size(); ++i) {
    auto changed = blob;
    changed[i] ^= std::byte{0x10};
    EXPECT_EQ(fault_of(layout_of(plan), changed), "its checksum does not match") << i;
  }
  EXPECT_EQ(fault_of(layout_of(plan), blob, 6), "its checksum does not match") << "in another row";
}

TEST(ChunkBlob, OfAnotherObjectDiffersInNothingElse) {
  testing::Random random(4);
  const Plan plan = random_stored_plan(random, 2, PlanKind::knots);
  const auto blob = blobs_of(plan)[0], other = chunk_of_object(blob, 5, 43);
  StoredChunk chunk;
  ASSERT_EQ(open_chunk(layout_of(plan), other, 5, chunk), nullptr);
  EXPECT_EQ(chunk.object, 43);
  EXPECT_EQ(chunk_of_object(other, 5, 42), blob);
}

// Bytes of an attacker, with correct checksums.
TEST(ChunkBlob, HostileBytesAreFaults) {
  const Plan plan = plan_of_knots({{0, {0, 0}}, {1, {1, 0}}, {2, {2, 0}}, {no_end, {2, 0}}});
  const Layout layout = layout_of(plan);
  const auto blob = blobs_of(plan)[0];
  constexpr std::size_t first_knot = 16 + 8 + 2 * 8;  // the leg without end is a chunk of its own
  EXPECT_EQ(fault_of(layout, {}), "it is too short");
  EXPECT_EQ(fault_of(layout, resealed(std::vector<std::byte>(20))), "its format or kind is not known");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 0, std::uint8_t{2})), "its format or kind is not known");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 1, std::uint8_t{3})), "its format or kind is not known");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 2, std::uint8_t{5})), "its format or kind is not known");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 2, std::uint8_t{3})), "its flags do not fit its kind");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 3, std::uint8_t{3})), "it has another number of axes");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 4, std::uint16_t{0})), "its number of legs is out of range");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 4, std::uint16_t{17})), "its number of legs is out of range");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 4, std::uint16_t{9})), "its counts are out of range");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 4, std::uint16_t{1})), "its size does not fit its counts");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 6, std::uint16_t{4})), "its flags do not fit its kind");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 6, std::uint16_t{1})), "its size does not fit its counts");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 16, std::uint32_t{0})), "its counts are out of range");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 16, std::uint32_t{3})), "its size does not fit its counts");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 16, std::uint32_t{0xffffffff})),
            "its counts are out of range");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 20, std::uint32_t{0xffffffff})),
            "its counts are out of range");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, 24, 0.5)), "its starts are not those of its legs");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, first_knot + 8, no_end)), "a number is not finite");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, first_knot + 8, std::nan(""))), "a number is not finite");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, first_knot + 24, 0.0)), "its times do not rise");
  EXPECT_EQ(fault_of(layout, replaced_at(blob, first_knot + 48, no_end)),
            "a knot without end is not where the mover rests");
  EXPECT_EQ(fault_of(layout, replaced_at(replaced_at(blob, first_knot + 8, -1e308), first_knot + 32, 1e308)),
            "no double holds the velocity of a leg");
  Layout uniform = layout;
  uniform.law = Law::uniform;
  testing::Random random(5);
  EXPECT_EQ(fault_of(uniform, blobs_of(random_stored_plan(random, 2, PlanKind::accelerated))[0]),
            "its format or kind is not known");
}

}  // namespace
}  // namespace foresee
