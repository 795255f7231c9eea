// Geodesics, checked against a differential equation that shares no code with the series of the product, and
// against published figures.
#include "geography/geodesic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geography/geodesic_by_steps.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

TEST(Geodesic, HasThePublishedLengths) {
  // C. F. F. Karney's own example, and half the meridian.
  const Geodesic line = geodesic_between({40.6, -73.8}, {51.6, -0.5});
  EXPECT_NEAR(line.distance, 5551759.400319, 1e-6);
  EXPECT_NEAR(line.azimuth, 51.198882845579824, 1e-12);
  EXPECT_NEAR(line.azimuth_there, 107.821776735514, 1e-11);
  EXPECT_NEAR(geodesic_between({90, 0}, {-90, 0}).distance, greatest_distance, 1e-4);
  EXPECT_NEAR(geodesic_between({0, 0}, {0, 90}).distance, 6378137 * std::acos(0.0), 1e-8);
}

TEST(Geodesic, LeadsWhereStepsAlongItLead) {
  Random random(1);
  for (int i = 0; i < 40; ++i) {
    const LatLon from{random.in(-89, 89), random.in(-180, 180)};
    const double azimuth = random.in(-180, 180), distance = std::pow(10, random.in(0, 6));
    const GeodesicEnd end = geodesic_from(from, azimuth, distance);
    const Walked there = walked(from, azimuth, distance);
    EXPECT_NEAR(metres_between(end.place, there.place), 0, 1e-8) << i;
    EXPECT_NEAR(std::remainder(end.azimuth - there.azimuth, 360) * std::cos(there.place.lat / 57.3), 0, 1e-12)
        << i;
    EXPECT_NEAR(end.reduced_length, there.reduced_length, 1e-8) << i;
  }
}

TEST(Geodesic, BetweenTwoPlacesLeadsFromOneToTheOther) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const LatLon from{random.in(-90, 90), random.in(-180, 180)};
    const double azimuth = random.in(-180, 180), distance = std::pow(10, random.in(-3, 6.5));
    const GeodesicEnd end = geodesic_from(from, azimuth, distance);
    const Geodesic line = geodesic_between(from, end.place);
    EXPECT_NEAR(line.distance, distance, 2e-8) << i;
    EXPECT_NEAR(line.reduced_length, end.reduced_length, 2e-8) << i;
    // Its azimuth is known as well as its length lets it.
    EXPECT_NEAR(std::remainder(line.azimuth - azimuth, 360) / 57.3 * distance, 0, 2e-8) << i;
  }
}

TEST(Geodesic, CrossesTheDateLineAndThePoles) {
  EXPECT_NEAR(geodesic_between({0, 179.5}, {0, -179.5}).distance, 6378137 * std::acos(0.0) / 90, 1e-8);
  EXPECT_EQ(geodesic_between({10, 179.5}, {20, -179.5}).distance,
            geodesic_between({10, 539.5}, {20, 180.5}).distance);
  const GeodesicEnd over = geodesic_from({89.9, 0}, 0, 22338.8);
  EXPECT_NEAR(std::abs(over.place.lon), 180, 1e-9);
  EXPECT_NEAR(over.place.lat, 89.9, 1e-4);
}

TEST(Geodesic, FromAPlaceToItselfIsNone) {
  EXPECT_EQ(geodesic_between({30, -90.5}, {30, -90.5}).distance, 0);
  EXPECT_EQ(geodesic_between({30, -90.5}, {30, 269.5}).distance, 0);
  EXPECT_EQ(geodesic_between({90, 12}, {90, -50}).distance, 0);
}

}  // namespace
}  // namespace foresee
