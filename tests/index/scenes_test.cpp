// The generator of random scenes, on which every other seeded test depends.
#include "scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace foresee::testing {
namespace {

TEST(Scenes, DrawTheSameNumbersEverywhere) {
  Random random(1);
  EXPECT_EQ(random.next(), 0x910a2dec89025cc1u);  // splitmix64's published sequence for seed 1
  EXPECT_EQ(random.next(), 0xbeeb8da1658eec67u);
}

TEST(Scenes, CoverEveryLayoutOnce) {
  std::set<std::string> names;
  for (const Layout& layout : all_layouts()) names.insert(name_of(layout));
  EXPECT_EQ(names.size(), all_layouts().size());
  EXPECT_EQ(names.size(), 4u * 4u * (3u + 3u + 4u) + growing_layouts().size());
}

TEST(Scenes, FillEveryRecordWithValidValues) {
  for (const Layout& layout : all_layouts())
    for (SceneKind kind : all_scene_kinds) {
      const RandomScene scene = random_scene({layout, kind, 20, 5});
      const Offsets at = record_offsets(layout);
      ASSERT_EQ(scene.records.size(), 20u * static_cast<std::size_t>(at.size));
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const double* record = scene.records.data() + i * static_cast<std::size_t>(at.size);
        for (int k = 0; k < at.size; ++k) ASSERT_TRUE(k == at.until || std::isfinite(record[k]));
        if (at.until != Offsets::absent) {
          ASSERT_GE(record[at.until], at.t == Offsets::absent ? 0.0 : record[at.t]);
        }
        if (at.mass != Offsets::absent) {
          ASSERT_GT(record[at.mass], 0);
        }
        if (at.r != Offsets::absent) {
          ASSERT_GE(record[at.r], 0);
        }
      }
    }
}

TEST(Scenes, ShuffleIdsFromOneToCount) {
  const RandomScene scene = random_scene({{2, Law::rest, Shape::point}, SceneKind::uniform, 50, 9});
  const std::set<std::int64_t> ids(scene.ids.begin(), scene.ids.end());
  EXPECT_EQ(ids.size(), 50u);
  EXPECT_EQ(*ids.begin(), 1);
  EXPECT_EQ(*ids.rbegin(), 50);
  EXPECT_FALSE(std::is_sorted(scene.ids.begin(), scene.ids.end()));
}

}  // namespace
}  // namespace foresee::testing
