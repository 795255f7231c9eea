// Chunks of plans in memory: found as they were added, dropped with their stamp, and evicted by the common budget.
#include "storage/nodes/chunk_cache.h"

#include "base/float_environment.h"
#include "storage/plan_cases.h"

namespace foresee {
namespace {

/// Chunks of one long plan, as rows would hold them.
class StoredBlobs : public ::testing::Test {
 protected:
  StoredBlobs() {
    testing::Random random(5);
    while (plan.knots.size() < 300) plan = random_stored_plan(random, 2, PlanKind::knots, 400);
    const FloatEnvironment environment;
    const ChunkWriter writer(plan, 42);
    for (std::size_t i = 0; i < writer.chunks(); ++i) blobs.push_back(writer.blob(i, number_of(i)));
  }

  static std::int64_t number_of(std::size_t chunk) { return static_cast<std::int64_t>(chunk) + 7; }

  void add(ChunkCache& cache, std::size_t i) {
    std::vector<std::byte> row = blobs[i];
    StoredChunk chunk;
    ASSERT_EQ(open_chunk(fleet().layout, row, number_of(i), chunk), nullptr);
    cache.add(number_of(i), row, chunk);
    std::fill(row.begin(), row.end(), std::byte{0xff});  // the row ends before the chunk is used
  }
  void add_all(ChunkCache& cache, std::int64_t stamp) {
    for (std::size_t i = 0; i < blobs.size(); ++i)
      if (!cache.find(stamp, number_of(i))) add(cache, i);
  }
  std::size_t count_found(ChunkCache& cache, std::int64_t stamp) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < blobs.size(); ++i) found += cache.find(stamp, number_of(i)) != nullptr;
    return found;
  }

  Plan plan;
  std::vector<std::vector<std::byte>> blobs;
};

TEST_F(StoredBlobs, ReadFromMemoryGiveTheWholePlan) {
  MemoryBudget budget;
  ChunkCache cache(budget, 3);
  EXPECT_EQ(cache.find(1, 7), nullptr);
  add_all(cache, 1);
  const FloatEnvironment environment;
  Plan read;
  std::vector<Leg> legs;
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const ChunkCache::Entry* const known = cache.find(1, number_of(i));
    ASSERT_NE(known, nullptr);
    EXPECT_EQ(known->chunk().object, 42);
    EXPECT_EQ(append_to_plan(known->chunk(), read), nullptr);
    EXPECT_EQ(append_legs(known->chunk(), legs), nullptr);
  }
  read.part_starts.pop_back();
  EXPECT_TRUE(same_plan(read, plan));
  EXPECT_EQ(legs, legs_of(plan));
}

TEST_F(StoredBlobs, HaveTheRecordThatWasAddedUntilTheyAreDropped) {
  MemoryBudget budget;
  ChunkCache cache(budget, 3);
  EXPECT_EQ(count_found(cache, 1), 0u);
  add_all(cache, 1);
  EXPECT_TRUE(cache.find(1, 8)->record().empty());
  const std::vector<double> record = {1, 2, 3};
  cache.add_record(8, record);
  cache.add_record(6, record);  // not in memory
  cache.prefetch(8);
  cache.prefetch(6);
  EXPECT_TRUE(std::ranges::equal(cache.find(1, 8)->record(), record));
  EXPECT_TRUE(cache.find(1, 7)->record().empty());
  EXPECT_EQ(count_found(cache, 2), 0u);
  add_all(cache, 2);
  EXPECT_TRUE(cache.find(2, 8)->record().empty());
}

TEST_F(StoredBlobs, OfAnotherStampAreDropped) {
  MemoryBudget budget;
  ChunkCache cache(budget, 3);
  EXPECT_EQ(count_found(cache, 1), 0u);
  add_all(cache, 1);
  EXPECT_EQ(count_found(cache, 1), blobs.size());
  EXPECT_EQ(count_found(cache, 2), 0u);
  EXPECT_EQ(count_found(cache, 1), 0u) << "they are gone, not hidden";
}

TEST_F(StoredBlobs, AreKeptOverAnOwnCommitThatHasNotChangedThem) {
  MemoryBudget budget;
  ChunkCache cache(budget, 3);
  EXPECT_EQ(count_found(cache, 1), 0u);
  add_all(cache, 1);
  ChangedChunks changed;
  changed.add(8, 10);
  changed.add(5, 6);  // not in memory
  cache.note_commit(1, 2, changed);
  EXPECT_EQ(count_found(cache, 2), blobs.size() - 3);
  EXPECT_EQ(cache.find(2, 9), nullptr);
  EXPECT_NE(cache.find(2, 11), nullptr);
  cache.note_commit(1, 3, {});
  EXPECT_NE(cache.find(2, 11), nullptr) << "a commit of another stamp is not this cache's";
  cache.note_commit({}, 3, {});
  EXPECT_NE(cache.find(2, 11), nullptr) << "nothing is known before the first stamp";
  changed.add(0, 1000000);
  cache.note_commit(2, 3, changed);
  EXPECT_EQ(count_found(cache, 3), 0u) << "many changes drop everything";
}

TEST_F(StoredBlobs, AreEvictedByTheBudgetUnlessTheyWereUsed) {
  std::size_t bytes = 0;
  for (const auto& blob : blobs) bytes += blob.size();
  MemoryBudget large, small({.memory = bytes});  // what the cache itself needs besides exceeds it
  ChunkCache all(large, 3), some(small, 3);
  EXPECT_EQ(all.find(1, 7), nullptr);
  EXPECT_EQ(some.find(1, 7), nullptr);
  add_all(all, 1);
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    if (!some.find(1, number_of(i))) add(some, i);
    ASSERT_NE(some.find(1, number_of(i)), nullptr) << "the newest is there";
  }
  EXPECT_EQ(count_found(all, 1), blobs.size());
  EXPECT_LT(count_found(some, 1), blobs.size());
  EXPECT_GT(count_found(some, 1), 0u);
}

}  // namespace
}  // namespace foresee
