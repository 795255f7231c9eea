// The indexes of a watch in memory against a plain list of its pairs.
#include "query/watch/memory_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scenes.h"

namespace foresee::testing {
namespace {

using PlainPairs = std::map<MemoryWatch::Ids, WatchedPair>;

bool are_equal(const WatchedPair& l, const WatchedPair& r) {
  return l.a == r.a && l.b == r.b && l.t == r.t && l.due == r.due && l.reported_t == r.reported_t &&
         l.state == r.state;
}

/// In any order.
template <class Keep>
void expect_those(std::vector<WatchedPair> found, const PlainPairs& plain, Keep keep) {
  std::sort(found.begin(), found.end(), [](const WatchedPair& l, const WatchedPair& r) {
    return std::pair(l.a, l.b) < std::pair(r.a, r.b);
  });
  std::vector<WatchedPair> wanted;
  for (const auto& [ids, pair] : plain)
    if (keep(pair)) wanted.push_back(pair);
  EXPECT_TRUE(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), are_equal))
      << found.size() << " found, wanted " << wanted.size();
}

std::vector<std::int64_t> some_ids(Random& random) {
  std::vector<std::int64_t> ids;
  for (std::int64_t id = 0; id < 20; ++id)
    if (random.below(4) == 0) ids.push_back(id);
  return ids;
}

TEST(MemoryWatch, FindsThePairsOfAList) {
  Random random(1);
  MemoryWatch watch;
  PlainPairs plain;
  const auto has = [](const std::vector<std::int64_t>& ids, std::int64_t id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  for (int step = 0; step < 4000; ++step) {
    WatchedPair pair{.a = static_cast<std::int64_t>(random.below(20)),
                     .b = static_cast<std::int64_t>(random.below(20)),
                     .t = random.in(0, 50),
                     .due = random.below(5) == 0 ? never_due : static_cast<double>(random.below(30)),
                     .reported_t = 7,
                     .state = random.below(2) ? PairState::reported : PairState::waiting};
    const auto known = plain.find({pair.a, pair.b});
    if (random.below(3) == 0) {
      if (known == plain.end()) continue;
      watch.erase_pair(known->second);
      plain.erase(known);
    } else {
      const bool with_reported_t = random.below(2) == 0;
      const auto before = watch.pair(pair.a, pair.b);
      EXPECT_EQ(before.has_value(), known != plain.end());
      watch.write_pair(before ? &*before : nullptr, pair, with_reported_t);
      if (!with_reported_t) pair.reported_t = pair.t;
      plain[{pair.a, pair.b}] = pair;
    }
    if (step % 1000 == 999) {
      watch.erase_all_pairs();
      plain.clear();
    }
    if (step % 8 != 0) continue;
    expect_those(watch.pairs(), plain, [](const WatchedPair&) { return true; });
    const std::vector<std::int64_t> a = some_ids(random), b = some_ids(random);
    expect_those(watch.stored_pairs_of(a, b), plain,
                 [&](const WatchedPair& one) { return has(a, one.a) || has(b, one.b); });
    for (const PairState state : {PairState::waiting, PairState::reported})
      expect_those(watch.due_pairs(state, 12), plain,
                   [&](const WatchedPair& one) { return one.state == state && one.due <= 12; });
    if (HasFailure()) return;
  }
}

TEST(MemoryWatch, GivesItsLogOnceAndTrimsIt) {
  MemoryWatch watch;
  for (std::int64_t seq = 1; seq <= 5; ++seq)
    watch.append({.seq = seq, .op = '+', .a = 1, .b = 2, .t = 3, .now = 0});
  watch.trim(2);
  EXPECT_EQ(watch.log().front().seq, 3);
  EXPECT_EQ(watch.take_log().size(), 3u);
  EXPECT_TRUE(watch.log().empty());
  EXPECT_TRUE(watch.take_log().empty());
}

}  // namespace
}  // namespace foresee::testing
