#include "contact/mesh/mesh_oracle.h"

#include <algorithm>
#include <random>

#include "contact/mesh/integer_triangles.h"

namespace foresee::oracle {
namespace {

using BigInteger = boost::multiprecision::cpp_int;

/// All lengths in a unit of which they are whole multiples.
class CommonUnit {
 public:
  void measure(const Rational& length) {
    const BigInteger below = denominator(length);
    if (per_one_ % below != 0) per_one_ = lcm(per_one_, below);
  }
  void measure(const SpacePlace& place) {
    for (const Rational& length : place) measure(length);
  }
  void measure(const Body& body) {
    for (const auto& triangle : body.triangles)
      for (const SpaceCorner& corner : triangle) measure({corner.x, corner.y, corner.z});
  }

  Whole in_units(const Rational& length) const {
    return Whole(BigInteger(numerator(length) * (per_one_ / denominator(length))));
  }
  Arrow in_units(const SpacePlace& place) const {
    return {in_units(place[0]), in_units(place[1]), in_units(place[2])};
  }
  std::vector<Facet> in_units(const Body& body, const SpacePlace& shift) const {
    const Arrow by = in_units(shift);
    const auto at = [&](const SpaceCorner& c) -> Arrow { return by + in_units(SpacePlace{c.x, c.y, c.z}); };
    std::vector<Facet> facets;
    for (const auto& triangle : body.triangles)
      facets.push_back(Facet({at(triangle[0]), at(triangle[1]), at(triangle[2])}));
    return facets;
  }

 private:
  BigInteger per_one_ = 1;
};

Fraction fraction_of(const Rational& number) {
  return {Whole(BigInteger(numerator(number))), Whole(BigInteger(denominator(number)))};
}
Rational rational_of(const Fraction& fraction) {
  return Rational(BigInteger(fraction.above), BigInteger(fraction.below));
}

/// By an odd number of crossings. Requires: on no facet.
bool is_within(const Arrow& corner, const std::vector<Facet>& solid) {
  std::mt19937 random;
  const auto any = [&random] { return Whole(static_cast<int>(random() % 2001) - 1000); };
  while (true) {
    const Arrow ray{any(), any(), any()};
    int count = 0;
    const bool is_decided = std::all_of(solid.begin(), solid.end(), [&](const Facet& facet) {
      const std::optional<int> crossed = crossings(corner, ray, facet);
      count += crossed.value_or(0);
      return crossed.has_value();
    });
    if (is_decided) return count % 2 == 1;
  }
}

/// Some triangle of `inner` is within `outer`. Requires: their surfaces do not touch.
bool holds_one(const std::vector<Facet>& outer, const std::vector<Facet>& inner) {
  std::vector<Arrow> queried;
  return std::any_of(inner.begin(), inner.end(), [&](const Facet& facet) {
    const Arrow& corner = facet.corners[0];
    if (std::find(queried.begin(), queried.end(), corner) != queried.end()) return false;
    queried.push_back(corner);
    return is_within(corner, outer);
  });
}

struct Bounds {
  Arrow lower, upper;

  explicit Bounds(const Facet& facet) {
    const auto& c = facet.corners;
    for (const auto axis : {&Arrow::x, &Arrow::y, &Arrow::z}) {
      lower.*axis = std::min({c[0].*axis, c[1].*axis, c[2].*axis});
      upper.*axis = std::max({c[0].*axis, c[1].*axis, c[2].*axis});
    }
  }
};

/// On which sides of a is b, by more than `distance`? A bit for each of six.
unsigned sides_of(const Bounds& a, const Bounds& b, const Whole& distance) {
  unsigned sides = 0;
  for (const auto axis : {&Arrow::x, &Arrow::y, &Arrow::z}) {
    sides = 4 * sides + (a.upper.*axis + distance < b.lower.*axis ? 1 : 0) +
            (b.upper.*axis + distance < a.lower.*axis ? 2 : 0);
  }
  return sides;
}

/// Both objects at one time, in a unit that depends on the time.
struct Still {
  std::vector<Facet> a, b;
  std::vector<Bounds> bounds_a, bounds_b;

  Still(const std::vector<Facet>& resting, const std::vector<Facet>& flying, const Arrow& velocity,
        const Fraction& time) {
    const Arrow path = time.above * velocity;
    const auto moved = [&](const Facet& facet, const Arrow& by) {
      const auto at = [&](std::size_t i) { return time.below * facet.corners[i] + by; };
      return Facet({at(0), at(1), at(2)});
    };
    for (const Facet& facet : resting) bounds_a.emplace_back(a.emplace_back(moved(facet, {})));
    for (const Facet& facet : flying) bounds_b.emplace_back(b.emplace_back(moved(facet, path)));
  }
};

/// Whether one is on one side of the other's bounds, or of a triangle's plane, all along its straight path.
bool remains_beside(const Still& first, const Still& last, std::size_t i, std::size_t j) {
  const auto remains = [&](const auto& side_at) { return (side_at(first) & side_at(last)) != 0; };
  return remains([&](const Still& s) { return sides_of(s.bounds_a[i], s.bounds_b[j], 0); }) ||
         remains([&](const Still& s) { return side_of(s.a[i], s.b[j], 0); }) ||
         remains([&](const Still& s) { return side_of(s.b[j], s.a[i], 0); });
}

class Scene {
 public:
  Scene(const Body& a, const Body& b, const SpacePlace& place, const SpacePlace& velocity,
        const RationalInterval& queried)
      : a_is_solid_(a.is_solid), b_is_solid_(b.is_solid), queried_(queried) {
    CommonUnit unit;
    unit.measure(a), unit.measure(b), unit.measure(place), unit.measure(velocity);
    a_ = unit.in_units(a, {}), b_ = unit.in_units(b, place);
    velocity_ = unit.in_units(velocity);
  }

  std::optional<RationalInterval> first_contact() {
    meet_surfaces();
    for (const RationalInterval& gap : gaps_between(contacts_, queried_))
      if (is_inside((gap.begin + gap.end) / 2)) contacts_.push_back(gap);
    return first_of(contacts_);
  }

 private:
  void meet_surfaces() {
    const Span queried{fraction_of(queried_.begin), fraction_of(queried_.end)};
    const Still first(a_, b_, velocity_, queried.begin), last(a_, b_, velocity_, queried.end);
    for (std::size_t i = 0; i < a_.size(); ++i)
      for (std::size_t j = 0; j < b_.size(); ++j) {
        if (remains_beside(first, last, i, j)) continue;
        const bool at_first = touch(first.a[i], first.b[j]);
        const bool at_last = touch(last.a[i], last.b[j]);
        auto met = at_first && at_last ? queried : features_meet(a_[i], b_[j], velocity_, queried);
        if (!met && !at_first && !at_last) continue;
        contacts_.push_back({at_first ? queried_.begin : rational_of(met->begin),
                             at_last ? queried_.end : rational_of(met->end)});
      }
  }

  bool is_inside(const Rational& time) const {
    const Still still(a_, b_, velocity_, fraction_of(time));
    return (a_is_solid_ && holds_one(still.a, still.b)) || (b_is_solid_ && holds_one(still.b, still.a));
  }

  const bool a_is_solid_, b_is_solid_;
  const RationalInterval queried_;
  std::vector<Facet> a_, b_;
  Arrow velocity_;
  std::vector<RationalInterval> contacts_;
};

}  // namespace

Body body_of(const Mesh& mesh) {
  Body body{{}, mesh.is_solid()};
  for (const Triangle& t : mesh.triangles())
    body.triangles.push_back({mesh.corners()[t[0]], mesh.corners()[t[1]], mesh.corners()[t[2]]});
  return body;
}

Body box_body(double half_x, double half_y, double half_z) {
  // A corner for each of eight numbers, whose bits say on which sides it is; faces of four corners, in turn.
  const auto corner = [&](int sides) -> SpaceCorner {
    return {sides & 1 ? half_x : -half_x, sides & 2 ? half_y : -half_y, sides & 4 ? half_z : -half_z};
  };
  static constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  Body body{{}, half_x > 0 && half_y > 0 && half_z > 0};
  if (half_x == 0 && half_y == 0 && half_z == 0) return {{{corner(0), corner(0), corner(0)}}};
  for (const auto& face : faces) {
    body.triangles.push_back({corner(face[0]), corner(face[1]), corner(face[2])});
    body.triangles.push_back({corner(face[0]), corner(face[2]), corner(face[3])});
  }
  return body;
}

std::optional<RationalInterval> first_contact(const Body& a, const Body& b, const SpacePlace& place,
                                              const SpacePlace& velocity, const RationalInterval& queried) {
  return Scene(a, b, place, velocity, queried).first_contact();
}

bool touch_at(const Body& a, const Body& b, const SpacePlace& place, const Rational& radius) {
  CommonUnit unit;
  unit.measure(a), unit.measure(b), unit.measure(place), unit.measure(radius);
  const Still still(unit.in_units(a, {}), unit.in_units(b, place), {}, {0, 1});
  const Whole reach = unit.in_units(radius), squared = reach * reach;
  for (std::size_t i = 0; i < still.a.size(); ++i)
    for (std::size_t j = 0; j < still.b.size(); ++j) {
      const Facet &one = still.a[i], &other = still.b[j];
      if (sides_of(still.bounds_a[i], still.bounds_b[j], reach) != 0) continue;
      if (side_of(one, other, squared) != 0 || side_of(other, one, squared) != 0) continue;
      if (touch(one, other) || are_near(one, other, squared)) return true;
    }
  return (a.is_solid && holds_one(still.a, still.b)) || (b.is_solid && holds_one(still.b, still.a));
}

}  // namespace foresee::oracle
