#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "shape/outline/test_outlines.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

TEST(WktWriter, WritesWhatTheReferenceShows) {
  for (const char* text :
       {"POLYGON((-8 -90, 8 -90, 8 60, 0 90, -8 60, -8 -90))",
        "POLYGON((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))",
        "MULTIPOLYGON(((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1)), ((20 0.1, 1e+22 0, 20 1e-07, 20 0.1)))"})
    EXPECT_EQ(write_outline(read_outline(text)), text);
}

TEST(WktWriter, OnePartIsAPolygon) {
  EXPECT_EQ(write_outline(read_outline("multipolygon(((0 0,1.50 0,0 1,0 0)))")),
            "POLYGON((0 0, 1.5 0, 0 1, 0 0))");
}

TEST(WktWriter, WhatIsWrittenReadsBackTheSame) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 300; ++i) {
    const Outline outline = moved(random_rings(random), [&](const Corner&) {
      const auto any = [&] {
        for (;;) {
          const std::uint64_t bits = random();
          double number;
          std::memcpy(&number, &bits, sizeof number);
          if (std::isfinite(number)) return number;
        }
      };
      return Corner{any(), any()};
    });
    EXPECT_EQ(read_outline(write_outline(outline)), outline);
  }
}

}  // namespace
}  // namespace foresee
