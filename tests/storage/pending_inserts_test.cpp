#include "storage/nodes/pending_inserts.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

const std::vector<double> record{1, 2, 3};

std::vector<std::int64_t> ids_in(const LooseObjects& loose) {
  std::vector<std::int64_t> ids;
  loose.for_each([&](std::int64_t id, std::span<const double>) { ids.push_back(id); });
  return ids;
}

TEST(LooseObjects, ObjectsThatComeAndGoTakeNoMemory) {
  LooseObjects loose(record.size());
  loose.add(-1, record);
  for (std::int64_t id = 0; id < 20000; ++id) {
    loose.add(id, record);
    if (id != 7000) loose.erase(id);
    loose.forget_past();
  }
  EXPECT_LT(loose.memory(), 20000u);
  EXPECT_EQ(ids_in(loose), (std::vector<std::int64_t>{-1, 7000}));
  EXPECT_EQ(loose.count(), 2u);
  const std::size_t mark = loose.position();
  loose.erase(7000);
  loose.add(8, record);
  loose.rewind(mark);
  EXPECT_EQ(ids_in(loose), (std::vector<std::int64_t>{-1, 7000}));
  loose.clear();
  EXPECT_EQ(ids_in(loose), std::vector<std::int64_t>{});
  EXPECT_EQ(loose.find(-1), nullptr);
}

}  // namespace
}  // namespace foresee
