#include "base/simd.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foresee {
namespace {

#if defined(__x86_64__)
// GCC's runtime and ours read the same registers of the processor.
TEST(Simd, FindsWhatTheCompilersRuntimeFinds) {
  const auto found = available_simd();
  const auto has = [&](Simd simd) { return std::find(found.begin(), found.end(), simd) != found.end(); };
  __builtin_cpu_init();
  EXPECT_TRUE(has(Simd::baseline));
  EXPECT_EQ(has(Simd::avx2), __builtin_cpu_supports("avx2") != 0);
  EXPECT_EQ(has(Simd::avx512), __builtin_cpu_supports("avx512f") != 0);
}
#endif

TEST(Simd, IsOrderedFromNarrowToWide) {
  const auto found = available_simd();
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  EXPECT_EQ(found.front(), Simd::baseline);
  EXPECT_EQ(simd_in_use(), found.back());
}

TEST(Simd, CallsWithTheInstructionsInUse) {
  const Simd usual = simd_in_use();
  for (const Simd simd : available_simd()) {
    use_simd(simd);
    EXPECT_EQ(with_simd_in_use([]<Simd given>(Level<given>) { return given; }), simd);
  }
  use_simd(usual);
}

TEST(Simd, NamesEachLevelDifferently) {
  EXPECT_STREQ(name_of(Simd::avx2), "AVX2");
  EXPECT_STREQ(name_of(Simd::avx512), "AVX-512");
  EXPECT_STRNE(name_of(Simd::baseline), name_of(Simd::avx2));
}

}  // namespace
}  // namespace foresee
