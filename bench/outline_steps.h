// First contact of two outlines by sampling: Boost.Geometry's intersects() in steps, and FCL's samples of
// upright prisms.
//
//   BoostSteps boost(fleet_a, fleet_b);                       // polygons are made once
//   boost.first_intersection(pair, flight, 0.1)            // seconds; never: at no step
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "fcl_rival.h"
#include "outline_scenes.h"

namespace foresee::bench {

class BoostSteps {
 public:
  BoostSteps(const OutlineFleet& a, const OutlineFleet& b) : a_(polygons_of(a)), b_(polygons_of(b)) {}

  double first_intersection(const Pair& pair, const Flight& flight, double step) {
    const Polygon &a = a_[pair.a], &b = b_[pair.b];
    moved_ = b;
    for (int i = 0; i * step <= flight.h; ++i) {
      const double x = flight.from[0] + i * step * flight.velocity[0],
                   y = flight.from[1] + i * step * flight.velocity[1];
      for (std::size_t k = 0; k < b.outer().size(); ++k)
        moved_.outer()[k] = {b.outer()[k].x() + x, b.outer()[k].y() + y};
      if (boost::geometry::intersects(a, moved_)) return i * step;
    }
    return never;
  }

 private:
  using Polygon = boost::geometry::model::polygon<boost::geometry::model::d2::point_xy<double>>;

  /// Of outlines of one ring.
  static std::vector<Polygon> polygons_of(const OutlineFleet& fleet) {
    std::vector<Polygon> polygons;
    for (const Outline& outline : fleet.outlines) {
      Polygon& polygon = polygons.emplace_back();
      for (const Corner& corner : outline.corners()) polygon.outer().emplace_back(corner.x, corner.y);
      boost::geometry::correct(polygon);
    }
    return polygons;
  }

  const std::vector<Polygon> a_, b_;
  Polygon moved_;
};

/// An upright prism of the pieces' union from `bottom` to `top`: where two overlap in z but neither encloses
/// the other there, their surfaces meet exactly while the outlines touch.
inline Mesh prism_of(const ConvexPieces& pieces, double bottom, double top) {
  std::vector<SpaceCorner> corners;
  std::vector<Triangle> triangles;
  for (std::size_t p = 0; p < pieces.count(); ++p) {
    const auto ring = pieces.corners(p);
    const auto first = static_cast<std::uint32_t>(corners.size()),
               size = static_cast<std::uint32_t>(ring.size());
    for (const double z : {bottom, top})
      for (const Corner& corner : ring) corners.push_back({corner.x, corner.y, z});
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t low = first + i, next = first + (i + 1) % size;
      if (i > 0 && i + 1 < size) {
        triangles.push_back({first, low, next});
        triangles.push_back({first + size, low + size, next + size});
      }
      if (pieces.inner(p)[i] != 0) continue;
      triangles.push_back({low, next, low + size});
      triangles.push_back({next, next + size, low + size});
    }
  }
  return {Mesh::Kind::parts, false, std::move(corners), std::move(triangles)};
}

/// FCL's meshes for both fleets: prisms that overlap in z, each with an end within the other.
inline std::vector<FclMesh> prisms_of(const OutlineFleet& fleet, double bottom, double top) {
  std::vector<FclMesh> prisms;
  for (const ConvexPieces& pieces : fleet.cut) prisms.emplace_back(prism_of(pieces, bottom, top));
  return prisms;
}

}  // namespace foresee::bench
