// Edges of zones: chords on the plane stay within a metre of the geodesic, at every place and length.
#include "geography/geodesic_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geography/plane.h"
#include "scenes.h"

namespace foresee {
namespace {

using testing::Random;

std::vector<LatLon> cut(const LatLon& a, const LatLon& b, const LatLon& origin) {
  return cut_edge(a, b, std::max(geodesic_between(origin, a).distance, geodesic_between(origin, b).distance));
}

struct Deviation {
  double on_plane = 0, on_ground = 0;
};

/// The distance of the cut edge from the geodesic, at `samples` places of each piece.
Deviation deviation_of(const LatLon& a, const LatLon& b, const LatLon& origin, int samples) {
  std::vector<LatLon> places = cut(a, b, origin);
  places.insert(places.begin(), a), places.push_back(b);
  const Geodesic line = geodesic_between(a, b);
  const auto pieces = places.size() - 1;
  Deviation found;
  for (std::size_t i = 0; i < pieces; ++i) {
    const OnPlane from = to_plane({places[i], {}}, origin), to = to_plane({places[i + 1], {}}, origin);
    for (int j = 1; j < samples; ++j) {
      const double part = static_cast<double>(j) / samples;
      const OnPlane chord{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y), {}};
      const LatLon place =
          geodesic_from(a, line.azimuth, line.distance * (static_cast<double>(i) + part) / pieces).place;
      const OnPlane point = to_plane({place, {}}, origin);
      found.on_plane = std::max(found.on_plane, std::hypot(point.x - chord.x, point.y - chord.y));
      found.on_ground =
          std::max(found.on_ground, geodesic_between(place, from_plane(chord, origin).place).distance);
    }
  }
  return found;
}

LatLon place_about(Random& random, const LatLon& origin, double reach) {
  return canonical_place(geodesic_from(origin, random.in(0, 360), reach * std::sqrt(random.in(0, 1))).place);
}

TEST(GeodesicEdge, IsWithinAMetreOfTheGeodesic) {
  Random random(1);
  Deviation worst;
  for (int i = 0; i < 500; ++i) {
    const double lat = i % 5 == 0 ? std::copysign(90 - std::pow(10, random.in(-6, 1)), random.in(-1, 1))
                                  : random.in(-90, 90);
    const LatLon origin{i % 50 == 0 ? 90 : lat, i % 7 == 0 ? 180 : random.in(-180, 180)};
    const LatLon a = place_about(random, origin, max_distance_from_origin - 1);
    LatLon b = place_about(random, origin, max_distance_from_origin - 1);
    if (i % 3 == 0)  // short edges, up to some pieces
      while (true) {
        b = canonical_place(geodesic_from(a, random.in(0, 360), std::pow(10, random.in(3, 5.5))).place);
        if (geodesic_between(origin, b).distance < max_distance_from_origin) break;
      }
    const Deviation found = deviation_of(a, b, origin, 16);
    ASSERT_LE(found.on_plane, 1) << i << " from " << a.lat << ' ' << a.lon << " to " << b.lat << ' ' << b.lon
                                 << " about " << origin.lat << ' ' << origin.lon;
    ASSERT_LE(found.on_ground, 1) << i;
    worst = {std::max(worst.on_plane, found.on_plane), std::max(worst.on_ground, found.on_ground)};
  }
  EXPECT_GT(worst.on_plane, 0.8);  // the bound is not wasteful
}

/// Across the direction to the origin, far from it: where the bound is reached.
TEST(GeodesicEdge, IsWithinAMetreWhereTheBoundIsReached) {
  for (const double lat : {0.0, 30.0, 60.0, 85.0, 90.0})
    for (double azimuth = 0; azimuth < 360; azimuth += 15)
      for (const double distance : {1e4, 1e5, 5e5, 1.2e6, 1.4999e6}) {
        const LatLon origin{lat, 179};
        const GeodesicEnd middle = geodesic_from(origin, azimuth, distance);
        const double half =
            std::sqrt(max_distance_from_origin * max_distance_from_origin - distance * distance) * 0.9;
        const LatLon a = canonical_place(geodesic_from(middle.place, middle.azimuth + 90, half).place);
        const LatLon b = canonical_place(geodesic_from(middle.place, middle.azimuth - 90, half).place);
        const Deviation found = deviation_of(a, b, origin, 8);
        ASSERT_LE(found.on_plane, 1) << lat << ' ' << azimuth << ' ' << distance;
        ASSERT_LE(found.on_ground, 1) << lat << ' ' << azimuth << ' ' << distance;
      }
}

TEST(GeodesicEdge, IsTheSameInBothDirections) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const LatLon origin{random.in(-90, 90), random.in(-180, 180)};
    const LatLon a = place_about(random, origin, 1e6), b = place_about(random, origin, 1e6);
    std::vector<LatLon> there = cut(a, b, origin), back = cut(b, a, origin);
    std::reverse(back.begin(), back.end());
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t j = 0; j < there.size(); ++j) {
      EXPECT_EQ(there[j].lat, back[j].lat);
      EXPECT_EQ(there[j].lon, back[j].lon);
    }
  }
}

TEST(GeodesicEdge, OfAHarbourHasNoCorners) {
  EXPECT_TRUE(cut_edge({53.9, 7.7}, {54, 7.9}, 20000).empty());
  EXPECT_TRUE(is_short_edge(20000, 20000));
  EXPECT_FALSE(is_short_edge(20000, 1.4e6));
}

TEST(GeodesicEdge, KnowsAPlaceByOneNotation) {
  const LatLon date_line = canonical_place({12, -180}), pole = canonical_place({-90, 17}),
               plain = canonical_place({-0.0, -0.0});
  EXPECT_EQ(date_line.lon, 180);
  EXPECT_EQ(pole.lon, 0);
  EXPECT_FALSE(std::signbit(plain.lat) || std::signbit(plain.lon));
}

}  // namespace
}  // namespace foresee
