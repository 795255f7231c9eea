// Block of 64 ids: round trip through its bytes, and faults of other bytes.
#include "format/id_block.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>

namespace foresee {
namespace {

constexpr std::int64_t min_id = std::numeric_limits<std::int64_t>::min(),
                       max_id = std::numeric_limits<std::int64_t>::max();

std::map<std::int64_t, std::int64_t> contents(const IdBlock& block) {
  std::map<std::int64_t, std::int64_t> all;
  block.for_each([&](std::int64_t id, std::int64_t leaf) { all[id] = leaf; });
  return all;
}

std::string fault_of(std::initializer_list<int> bytes) {
  std::vector<std::byte> blob;
  for (const int byte : bytes) blob.push_back(static_cast<std::byte>(byte));
  IdBlock block(0);
  const char* fault = block.decode(blob);
  return fault ? fault : "";
}

TEST(IdBlock, EveryIdHasOne) {
  for (const std::int64_t id : {std::int64_t{0}, std::int64_t{63}, std::int64_t{64}, std::int64_t{-1},
                                std::int64_t{-64}, std::int64_t{-65}, min_id, max_id}) {
    IdBlock block(IdBlock::base_of(id));
    EXPECT_LE(block.base(), id);
    EXPECT_GE(block.last(), id);
    EXPECT_EQ(block.last() - block.base(), IdBlock::ids - 1);
    block.set(id, 7);
    EXPECT_EQ(contents(block), (std::map<std::int64_t, std::int64_t>{{id, 7}}));
  }
}

TEST(IdBlock, RoundTripsThroughItsBytes) {
  std::mt19937_64 random(1);
  for (const std::int64_t largest :
       {std::int64_t{1}, std::int64_t{255}, std::int64_t{256}, std::int64_t{1} << 24, max_id})
    for (int round = 0; round < 200; ++round) {
      IdBlock block(-128), read(-128);
      std::uniform_int_distribution<std::int64_t> leaf(1, largest), id(block.base(), block.last());
      for (int i = 0; i <= round % 90; ++i) block.set(id(random), leaf(random));
      if (round % 2) block.set(contents(block).begin()->first, 0);
      if (block.count() == 0) continue;
      EXPECT_EQ(block.count(), contents(block).size());
      ASSERT_STREQ(read.decode(block.encode()), nullptr);
      EXPECT_EQ(contents(read), contents(block));
      EXPECT_EQ(read.count(), block.count());
    }
}

TEST(IdBlock, TakesFourBytesForOneIdAndThreeForEachOfManyInAMiddlingTable) {
  IdBlock block(0);
  block.set(5, 700);
  EXPECT_EQ(block.encode().size(), 4u);
  for (std::int64_t id = 0; id < IdBlock::ids; ++id) block.set(id, 20'000 + id);
  EXPECT_EQ(block.encode().size(), 1u + 3 * IdBlock::ids);
}

TEST(IdBlock, OtherBytesAreFaults) {
  EXPECT_EQ(fault_of({1, 5, 7}), "");
  EXPECT_EQ(fault_of({}), "a leaf's number takes 1 to 8 bytes");
  EXPECT_EQ(fault_of({0, 5, 7}), "a leaf's number takes 1 to 8 bytes");
  EXPECT_EQ(fault_of({9, 5, 7}), "a leaf's number takes 1 to 8 bytes");
  EXPECT_EQ(fault_of({1}), "its size fits no number of ids");
  EXPECT_EQ(fault_of({1, 5}), "its size fits no number of ids");
  EXPECT_EQ(fault_of({1, 5, 7, 0}), "its size fits no number of ids");
  EXPECT_EQ(fault_of({1, 64, 7}), "an id is beyond its block");
  EXPECT_EQ(fault_of({1, 5, 5, 7, 7}), "its ids do not ascend");
  EXPECT_EQ(fault_of({1, 5, 4, 7, 7}), "its ids do not ascend");
  EXPECT_EQ(fault_of({1, 5, 0}), "a leaf's number is not positive");
  EXPECT_EQ(fault_of({8, 5, 0, 0, 0, 0, 0, 0, 0, 128}), "a leaf's number is not positive");
  std::vector<std::byte> many(1 + 2 * 65, std::byte{1});
  EXPECT_STREQ(IdBlock(0).decode(many), "its size fits no number of ids");
}

}  // namespace
}  // namespace foresee
