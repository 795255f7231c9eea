// Sample of records: represents all of them, also if they repeat periodically.
#include "base/record_sample.h"

#include <gtest/gtest.h>

#include <map>

namespace foresee {
namespace {

TEST(RecordSample, KeepsAllIfThereAreFew) {
  RecordSample sample(2);
  std::vector<double> all;
  for (int i = 0; i < 16'384; ++i) {
    const double record[] = {i / 1.0, -i / 1.0};
    sample.add(record);
    all.insert(all.end(), record, record + 2);
  }
  EXPECT_TRUE(std::equal(all.begin(), all.end(), sample.records().begin(), sample.records().end()));
}

TEST(RecordSample, HasEveryColumnOfAGrid) {
  constexpr int columns = 256, rows = 1024;
  RecordSample sample(1);
  for (int i = 0; i < rows * columns; ++i) {
    const double column = i % columns;
    sample.add(&column);
  }
  std::map<double, int> seen;
  for (const double column : sample.records()) ++seen[column];
  EXPECT_GE(sample.records().size(), 4'096U);
  EXPECT_LE(sample.records().size(), 16'384U);
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(columns));
  const int fair = static_cast<int>(sample.records().size()) / columns;
  for (const auto& [column, times] : seen) EXPECT_LT(times, 3 * fair) << column;
}

}  // namespace
}  // namespace foresee
