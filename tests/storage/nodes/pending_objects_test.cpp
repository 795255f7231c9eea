#include "storage/nodes/pending_objects.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

const std::vector<double> record{1, 2, 3};

std::vector<std::int64_t> ids_in(const PendingObjects& pending) {
  std::vector<std::int64_t> ids;
  pending.for_each([&](std::int64_t id, std::span<const double>) { ids.push_back(id); });
  return ids;
}

TEST(PendingObjects, ObjectsThatComeAndGoTakeNoMemory) {
  Journal journal;
  PendingObjects pending(journal, record.size());
  journal.begin();
  pending.add(-1, record);
  for (std::int64_t id = 0; id < 20000; ++id) {
    const Journal::Mark change = journal.set_mark();
    pending.add(id, record);
    if (id != 7000) pending.erase(id);
    journal.forget(change);
  }
  EXPECT_LT(pending.memory(), 20000u);
  EXPECT_EQ(ids_in(pending), (std::vector<std::int64_t>{-1, 7000}));
  EXPECT_EQ(pending.count(), 2u);
  const Journal::Mark mark = journal.set_mark();
  pending.erase(7000);
  pending.add(8, record);
  pending.remove_all();
  pending.add(9, record);
  EXPECT_EQ(ids_in(pending), std::vector<std::int64_t>{9});
  journal.rewind(mark);
  EXPECT_EQ(ids_in(pending), (std::vector<std::int64_t>{-1, 7000}));
  journal.end(Journal::Ended::rolled_back);
  EXPECT_EQ(ids_in(pending), std::vector<std::int64_t>{});
  EXPECT_EQ(pending.find(-1), nullptr);
}

// As one statement does that writes more rows than may wait.
TEST(PendingObjects, WhatGoesIntoTheTreeWithinAMarkIsForgotten) {
  for (const std::int64_t before : {0, 3}) {
    Journal journal;
    PendingObjects pending(journal, record.size());
    journal.begin();
    for (std::int64_t id = 1; id <= before; ++id) pending.add(-id, record);
    const Journal::Mark statement = journal.set_mark();
    std::size_t kept = 0;
    for (int flush = 0; flush < 4; ++flush) {
      for (std::int64_t id = 0; id < 100; ++id) pending.add(id, record);
      pending.replace(50, record);
      pending.erase(51);
      const Journal::Mark change = journal.set_mark();
      pending.remove_all();
      EXPECT_EQ(pending.count(), 0u);
      if (flush == 2) {
        journal.rewind(change);
        EXPECT_EQ(pending.count(), 99u);
        pending.remove_all();
      }
      journal.forget(change);
      if (flush == 0) kept = pending.kept();
      EXPECT_EQ(pending.kept(), kept);
    }
    EXPECT_EQ(kept > 0, before > 0);
    pending.add(7, record);
    journal.rewind(statement);
    EXPECT_EQ(pending.count(), static_cast<std::size_t>(before));
    EXPECT_EQ(pending.find(7), nullptr);
  }
}

TEST(PendingObjects, ErasedObjectsMayComeAgain) {
  using Ids = std::vector<std::int64_t>;
  Journal journal;
  PendingObjects pending(journal, record.size());
  journal.begin();
  pending.erase_stored(5);
  pending.erase_stored(2);
  EXPECT_EQ(pending.erased_ids(), (Ids{2, 5}));
  EXPECT_EQ(pending.find(5), nullptr);
  EXPECT_EQ(pending.count(), 0u);
  EXPECT_FALSE(pending.is_empty());
  const Journal::Mark mark = journal.set_mark();
  pending.add(5, record);
  EXPECT_FALSE(pending.is_erased(5));
  EXPECT_EQ(pending.erased_ids(), Ids{2});
  pending.erase(5);
  pending.erase_stored(5);
  EXPECT_EQ(pending.erased_ids(), (Ids{2, 5}));
  pending.add(2, record);
  pending.erase_stored(9);
  const Journal::Mark change = journal.set_mark();
  pending.remove_all();
  EXPECT_TRUE(pending.is_empty());
  EXPECT_FALSE(pending.is_erased(5));
  journal.rewind(change);
  EXPECT_EQ(pending.erased_ids(), (Ids{5, 9}));
  EXPECT_EQ(ids_in(pending), Ids{2});
  journal.rewind(mark);
  EXPECT_EQ(pending.erased_ids(), (Ids{2, 5}));
  EXPECT_EQ(ids_in(pending), Ids{});
  journal.end(Journal::Ended::rolled_back);
  EXPECT_TRUE(pending.is_empty());
}

TEST(PendingObjects, WithoutHolesTheyAreStillErased) {
  Journal journal;
  PendingObjects pending(journal, record.size());
  journal.begin();
  for (std::int64_t id = 0; id < 200; ++id) {
    const Journal::Mark change = journal.set_mark();
    pending.erase_stored(id);
    pending.add(id, record);
    pending.erase(id);
    pending.erase_stored(id);
    journal.forget(change);  // drops the holes
  }
  EXPECT_EQ(pending.erased_ids().size(), 200u);
  EXPECT_EQ(pending.count(), 0u);
}

}  // namespace
}  // namespace foresee
