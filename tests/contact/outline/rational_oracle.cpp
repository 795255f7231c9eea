#include "contact/outline/rational_oracle.h"

#include <algorithm>

namespace foresee::oracle {
namespace {

Rational cross(const Place& a, const Place& b) {
  return a.x * b.y - a.y * b.x;
}
Rational dot(const Place& a, const Place& b) {
  return a.x * b.x + a.y * b.y;
}
Place operator-(const Place& a, const Place& b) {
  return {a.x - b.x, a.y - b.y};
}
Place place_of(const Corner& corner) {
  return {Rational(corner.x), Rational(corner.y)};
}

/// A number that changes steadily: value + s slope.
struct Steady {
  Rational value, slope;
};

/// Cuts a stretch to when low <= number <= high; false if nothing is left.
bool cut(RationalInterval& stretch, const Steady& number, const Rational& low, const Rational& high) {
  if (number.slope == 0) return low <= number.value && number.value <= high;
  Rational first = (low - number.value) / number.slope, last = (high - number.value) / number.slope;
  if (last < first) std::swap(first, last);
  if (stretch.begin < first) stretch.begin = first;
  if (last < stretch.end) stretch.end = last;
  return stretch.begin <= stretch.end;
}

/// When the segment from p along e meets that from q along f, which moves as d does.
std::optional<RationalInterval> meeting(const Place& p, const Place& e, const Place& q, const Place& f,
                                        const Place& d, const Place& v, RationalInterval queried) {
  const Place gap{d.x + q.x - p.x, d.y + q.y - p.y};
  const Rational turn = cross(e, f);
  if (turn != 0) {
    const Steady along_e{cross(gap, f) / turn, cross(v, f) / turn};
    const Steady along_f{cross(gap, e) / turn, cross(v, e) / turn};
    if (cut(queried, along_e, 0, 1) && cut(queried, along_f, 0, 1)) return queried;
    return {};
  }
  // Parallel: in one line, and overlapping in it. A point is a segment without length.
  const bool e_is_point = e.x == 0 && e.y == 0;
  const Place& line = e_is_point ? f : e;
  if (!cut(queried, {cross(gap, line), cross(v, line)}, 0, 0)) return {};
  const Rational reach_e = dot(e, line), reach_f = dot(f, line);
  const Rational low = std::min<Rational>(0, reach_e) - std::max<Rational>(0, reach_f);
  const Rational high = std::max<Rational>(0, reach_e) - std::min<Rational>(0, reach_f);
  if (cut(queried, {dot(gap, line), dot(v, line)}, low, high)) return queried;
  return {};
}

/// Whether a place is no farther than `radius` from the segment from p along e.
bool is_near(const Place& place, const Place& p, const Place& e, const Rational& radius) {
  Place gap = place - p;
  const Rational along = dot(gap, e), length = dot(e, e), limit = radius * radius;
  if (along > 0 && along < length) return cross(gap, e) * cross(gap, e) <= limit * length;
  if (along > 0) gap = gap - e;
  return dot(gap, gap) <= limit;
}

/// By how many rings' edges a ray to the right is crossed. Requires: on no edge.
bool is_within(const Place& place, const Region& region) {
  bool within = false;
  for (const auto& ring : region)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place a = place_of(ring[i]), b = place_of(ring[(i + 1) % ring.size()]);
      if ((a.y > place.y) == (b.y > place.y)) continue;
      const Rational side = cross(b - a, place - a);
      if ((side > 0) == (b.y > a.y)) within = !within;
    }
  return within;
}

/// Some corner of a ring of `inner`, moved by `shift`, is within `outer`.
bool holds_one(const Region& outer, const Region& inner, const Place& shift) {
  return std::any_of(inner.begin(), inner.end(), [&](const auto& ring) {
    const Place corner = place_of(ring[0]);
    return is_within({corner.x + shift.x, corner.y + shift.y}, outer);
  });
}

/// Calls `take` with the start of each edge and its vector.
template <class Take>
void for_each_edge(const Region& region, Take&& take) {
  for (const auto& ring : region)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place p = place_of(ring[i]);
      take(p, place_of(ring[(i + 1) % ring.size()]) - p);
    }
}

class Scene {
 public:
  Scene(const Region& a, const Region& b, const Place& place, const Place& velocity,
        const RationalInterval& queried)
      : a_(a), b_(b), place_(place), velocity_(velocity), queried_(queried) {}

  std::optional<RationalInterval> first_contact() {
    meet_boundaries();
    fill_gaps();
    return first_of(contacts_);
  }

 private:
  void meet_boundaries() {
    for_each_edge(a_, [&](const Place& p, const Place& e) {
      for_each_edge(b_, [&](const Place& q, const Place& f) {
        if (const auto met = meeting(p, e, q, f, place_, velocity_, queried_)) contacts_.push_back(*met);
      });
    });
  }

  /// Where no boundaries meet, nothing enters or leaves.
  void fill_gaps() {
    for (const RationalInterval& gap : gaps_between(contacts_, queried_)) fill(gap.begin, gap.end);
  }

  void fill(const Rational& begin, const Rational& end) {
    const Rational time = (begin + end) / 2;
    const Place d{place_.x + time * velocity_.x, place_.y + time * velocity_.y}, back{-d.x, -d.y};
    if (holds_one(a_, b_, d) || holds_one(b_, a_, back)) contacts_.push_back({begin, end});
  }

  const Region &a_, &b_;
  const Place &place_, &velocity_;
  const RationalInterval queried_;
  std::vector<RationalInterval> contacts_;
};

}  // namespace

std::optional<RationalInterval> first_contact(const Region& a, const Region& b, const Place& place,
                                              const Place& velocity, const RationalInterval& queried) {
  return Scene(a, b, place, velocity, queried).first_contact();
}

bool touch_at(const Region& a, const Region& b, const Place& place, const Rational& radius) {
  const Place still{0, 0}, back{-place.x, -place.y};
  bool near = holds_one(a, b, place) || holds_one(b, a, back);
  for_each_edge(a, [&](const Place& p, const Place& e) {
    for_each_edge(b, [&](const Place& q, const Place& f) {
      near = near || is_near({q.x + place.x, q.y + place.y}, p, e, radius) ||
             is_near({p.x - place.x, p.y - place.y}, q, f, radius) ||
             meeting(p, e, q, f, place, still, {0, 0}).has_value();
    });
  });
  return near;
}

}  // namespace foresee::oracle
