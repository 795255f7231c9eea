// Float boxes contain their boxes and are in the stripes of their ends; all instruction sets give the same
// bits.
#include "index/gpcd_grid/float_lanes.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cstring>

#include "every_simd.h"
#include "index/gpcd_grid/sort_keys.h"
#include "scenes.h"
#include "shape/beam.h"

namespace foresee::testing {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using gpcd::Columns;
using gpcd::FloatBox;
using gpcd::FloatFrame;
using gpcd::FloatLanes;
using gpcd::Partition;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

/// Numbers of any magnitude; some boxes are empty, some unbounded.
std::vector<Beam<2>> some_beams(std::size_t count, double size) {
  Random random(6);
  const auto number = [&] { return std::ldexp(random.in(-2, 2), static_cast<int>(random.in(-size, size))); };
  std::vector<Beam<2>> beams;
  for (std::size_t i = 0; i < count; ++i) {
    Beam<2> beam{Box<2>::empty(), Vec<2>::zero(), 0, 1};
    for (int k = 0; k < 2 && i % 16 != 5; ++k) {
      beam.box.lower[k] = i % 16 == 6 ? -inf : number();
      beam.box.upper[k] = i % 16 == 7 ? inf : beam.box.lower[k] + std::abs(number());
      beam.travel[k] = number();
    }
    beams.push_back(beam);
  }
  return beams;
}

/// Runs with every instruction set.
FloatLanes<2> lanes_of(const std::vector<Beam<2>>& beams, const FloatFrame<2>& frame, const Columns& columns,
                       const Partition<2>& partition) {
  BeamLanes<2> from;
  for (std::size_t l = 0; l < beams.size(); ++l) put(beams[l], from, l);
  FloatLanes<2> first;
  for_every_simd([&](Simd simd) {
    const auto& kernels = gpcd::float_kernels<2>();
    FloatLanes<2> lanes;
    kernels.round_outward(from, beams.size(), frame, columns, lanes);
    kernels.find_stripes(lanes, beams.size(), partition);
    if (simd == Simd::baseline) first = lanes;
    EXPECT_EQ(std::memcmp(&first, &lanes, sizeof lanes), 0);
  });
  return first;
}

void expect_inside(const Box<2>& box, const FloatBox<2>& rounded, const FloatFrame<2>& frame) {
  if (box.is_empty()) {
    EXPECT_TRUE(rounded.is_empty());
    return;
  }
  for (int k = 0; k < 2; ++k) {
    const auto place = [&](double x) -> Rational {
      return Rational(x) * Rational(frame.scale[k]) - Rational(frame.scaled_origin[k]);
    };
    EXPECT_LE(rounded.lower[k], rounded.upper[k]);
    // Values beyond the range of a float are clamped to it.
    if (rounded.lower[k] > -largest && rounded.lower[k] < largest) {
      EXPECT_LE(Rational(rounded.lower[k]), place(box.lower[k]));
    }
    if (rounded.upper[k] > -largest && rounded.upper[k] < largest) {
      EXPECT_GE(Rational(rounded.upper[k]), place(box.upper[k]));
    }
  }
}

TEST(FloatLanes, ContainTheBoxesAndMeetTheirStripes) {
  Partition<2> partition;
  partition.axis[1] = {-40, 0.25F, 30};
  partition.largest_inside[0] = 1e6F, partition.largest_inside[1] = 20;
  for (double size : {3.0, 40.0, 1000.0})
    for (bool moves : {false, true})
      for (const FloatFrame<2>& frame :
           {FloatFrame<2>{{1, 1}, {0, 0}}, FloatFrame<2>{{0x1p-7, 0x1p20}, {12.3, -4e15}}}) {
        const std::vector<Beam<2>> beams = some_beams(BeamLanes<2>::width, size);
        const FloatLanes<2> lanes = lanes_of(beams, frame, {moves, false}, partition);
        for (std::size_t l = 0; l < beams.size(); ++l) {
          const FloatBox<2> box = lanes.box(l);
          expect_inside(beams[l].box, box, frame);
          const bool giant = box.extent(0) > 1e6F || box.extent(1) > 20;
          EXPECT_EQ(lanes.inside[l], !box.is_empty() && !giant);
          EXPECT_EQ(lanes.giant[l], !box.is_empty() && giant);
          if (!lanes.inside[l]) continue;
          EXPECT_EQ(gpcd::Key{lanes.order[l]} << 32 | l,
                    gpcd::key_of(box.lower[0], static_cast<std::uint32_t>(l)));
          EXPECT_EQ(static_cast<int>(lanes.first[l]), partition.axis[1].index(box.lower[1]));
          EXPECT_EQ(static_cast<int>(lanes.first[l] + lanes.more_y[l]),
                    partition.axis[1].index(box.upper[1]));
        }
      }
}

}  // namespace
}  // namespace foresee::testing
