// Sorted hits of which few rows are read: few hits are kept, and a reader that continues misses none.
#include "query/join/sorted_hits.h"

#include <gtest/gtest.h>

#include "query/join_cases.h"
#include "sanitized.h"

namespace foresee {
namespace {

using testing::numbers_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_in_order;
using testing::sanitized;
using testing::scene_of;

/// Hits with few different times, so that most are tied with others.
Hits random_hits(std::uint32_t count, Random& random) {
  Hits hits;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(random.below(5));
    hits.pairs.push_back({i, i + 1});
    hits.times.push_back({t, t, t, t});
  }
  return hits;
}

std::vector<Pair> taken(SortedHits& sorted, NeverInterrupt& never) {
  std::vector<Pair> pairs;
  sorted.sort(never);
  for (Hits some; sorted.any();) {
    sorted.take(some);
    pairs.insert(pairs.end(), some.pairs.begin(), some.pairs.end());
  }
  return pairs;
}

TEST(SortedHits, KeepAMultipleOfWhatIsReadAndGiveTheOthersLater) {
  constexpr std::uint32_t count = sanitized ? 60000 : 200000;
  NeverInterrupt never;
  Random random(1);
  const Hits hits = random_hits(count, random);
  for (JoinOrder order : {JoinOrder::by_t, JoinOrder::by_dt}) {
    const JoinQuestion all{.a = nullptr, .order = order},
        few{.a = nullptr, .order = order, .likely_rows = 10};
    SortedHits plain(all), sparing(few);
    plain.add(hits, never);
    EXPECT_EQ(plain.size(), count);
    const std::vector<Pair> right = taken(plain, never);
    EXPECT_FALSE(plain.take_left_out());

    std::vector<Pair> found;
    std::size_t answered = 0;
    for (bool again = true; again; again = sparing.take_left_out(), ++answered) {
      sparing.add(hits, never);
      EXPECT_LE(sparing.size(), 10000 + 2 * 8 * found.size());
      const std::vector<Pair> some = taken(sparing, never);
      found.insert(found.end(), some.begin(), some.end());
    }
    EXPECT_TRUE(found == right);
    EXPECT_EQ(answered, 3u);  // 4096 hits, eight times as many, and the others
  }
}

/// Discs that all start at the same time, most of them in contact then.
TEST(SortedHits, OfAJoinAreTheSameRowsInTheSameOrderHoweverFewAreLikely) {
  constexpr std::size_t count = sanitized ? 150 : 250;
  RandomScene scene =
      random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true},
                    .kind = testing::SceneKind::one_spot,
                    .count = count,
                    .seed = 3});
  const Offsets at = row_offsets(scene.layout);
  for (std::size_t i = 0; i < scene.size(); ++i)
    scene.rows[i * static_cast<std::size_t>(at.size) + static_cast<std::size_t>(at.t)] = 1;
  JoinQuestion question{.a = scene_of(scene), .now = 0, .h = 3};
  for (JoinMethod method : {JoinMethod::grid, JoinMethod::scan})
    for (JoinOrder order : {JoinOrder::by_t, JoinOrder::by_dt, JoinOrder::by_t_and_ids}) {
      question.method = method, question.order = order, question.likely_rows = all_rows;
      const auto right = numbers_of(rows_in_order(question));
      EXPECT_GT(right.size(), 9 * count * count / 4);
      question.likely_rows = 1;
      EXPECT_TRUE(numbers_of(rows_in_order(question)) == right);
    }
}

}  // namespace
}  // namespace foresee
