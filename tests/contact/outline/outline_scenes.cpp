#include "contact/outline/outline_scenes.h"

#include <cmath>
#include <sstream>

#include "contact/contact_factories.h"
#include "shape/outline/outline_rotation.h"
#include "shape/outline/validity.h"

namespace foresee::testing_by_hand {
namespace {

/// The outlines of a table of one row.
class OneOutline final : public OutlineRows {
 public:
  explicit OneOutline(const Outline& outline) {
    if (outline.rings() > 0) pieces_ = convex_pieces(outline);
  }
  const ConvexPieces* pieces(std::size_t /*row*/, ScratchPieces<ConvexPieces>& /*own*/) const override {
    return pieces_.count() > 0 ? &pieces_ : nullptr;
  }

 private:
  ConvexPieces pieces_;
};

class Draw {
 public:
  Draw(const OutlineFamily& family, OutlinePairing pairing, std::uint64_t seed)
      : family_(family), pairing_(pairing), random_(seed) {}

  OutlineScene scene() {
    OutlineScene scene;
    scene.question.horizon = {.now = family_.ages > 0 ? 100.0 : family_.now, .h = 8};
    scene.a = object(true), scene.b = object(pairing_ == OutlinePairing::outlines);
    move(scene);
    scale(scene);
    return scene;
  }

 private:
  using Motion = OutlineFamily::Motion;

  std::uint64_t below(std::uint64_t count) { return random_() % count; }
  double number(double range) {
    const double any = std::uniform_real_distribution<double>(-range, range)(random_);
    return family_.whole ? std::round(2 * any) / 2 : any;
  }
  double above(double min, double range) { return min + std::abs(number(range)); }

  OutlinedObject object(bool has_outline) {
    OutlinedObject o;
    const bool box = !has_outline && pairing_ == OutlinePairing::outline_and_box;
    o.row.layout.shape = box ? Shape::box : Shape::point;
    if (!family_.bent) o.row.layout.law = Law::uniform;
    if (box) o.row.half[0] = std::abs(number(3)), o.row.half[1] = std::abs(number(3));
    if (!has_outline) return o;
    const Outline drawn = outline();
    const double heading = family_.turned < 0 ? std::abs(number(180)) : family_.turned;
    check_outline(drawn);
    o.outline = turned(drawn, heading);
    check_turned(drawn, edge_touch_of(drawn), o.outline, heading);
    return o;
  }

  Outline outline() {
    const double w = above(1, 3), h = above(1, 3), x = number(2), y = number(2);
    const auto box = [](double x0, double y0, double x1, double y1) {
      return Ring{x0, y0, x1, y0, x1, y1, x0, y1};
    };
    switch (below(9)) {
      case 0:
        return outline_of({{box(x, y, x + w, y + h)}});
      case 1:  // an L
        return outline_of(
            {{{x, y, x + 2 * w, y, x + 2 * w, y + h, x + w, y + h, x + w, y + 2 * h, x, y + 2 * h}}});
      case 2:  // a hull
        return outline_of({{{x - w, y - h, x + w, y - h, x + w, y + h, x, y + 2 * h, x - w, y + h}}});
      case 3:  // a frame, whose hole may be smaller than what is in it
        return outline_of(
            {{box(x - 2 * w, y - 2 * h, x + 2 * w, y + 2 * h), box(x - w, y - h, x + w, y + h)}});
      case 4:  // two parts
        return outline_of({{box(x, y, x + w, y + h)}, {box(x + 2 * w, y, x + 3 * w, y + 2 * h)}});
      case 5:
        return comb(static_cast<int>(2 + below(3)), w, h);
      case 6:  // an arrow with a reflex corner
        return outline_of({{{x, y, x + w, y - h, x, y + 2 * h, x - w, y - h}}});
      case 7:
        return spiral(w);
      default:
        return star(static_cast<int>(3 + below(6)));
    }
  }

  static Outline comb(int teeth, double w, double h) {
    // The gaps between teeth, from right to left.
    Ring ring{0, 0, (2 * teeth - 1) * w, 0};
    for (int i = teeth; i-- > 0;) {
      for (const double number : {(2 * i + 1) * w, 2 * h, 2 * i * w, 2 * h}) ring.push_back(number);
      if (i > 0)
        for (const double number : {2 * i * w, h, (2 * i - 1) * w, h}) ring.push_back(number);
    }
    return outline_of({{ring}});
  }

  static Outline spiral(double w) {
    Ring ring{0, 0, 7, 0,   7,   6,   1,   6,   1, 2,   5, 2, 5, 4, 3, 4, 3, 3,
              4, 3, 4, 3.5, 4.5, 3.5, 4.5, 2.5, 2, 2.5, 2, 5, 6, 5, 6, 1, 0, 1};
    for (double& number : ring) number *= w;
    return outline_of({{ring}});
  }

  Outline star(int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * 3.14159265358979 * (i + 0.4 * uniform()) / corners, r = 1 + 5 * uniform();
      ring.push_back(r * std::cos(angle)), ring.push_back(r * std::sin(angle));
    }
    return outline_of({{ring}});
  }
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  Corner corner_of(const OutlinedObject& o) {
    if (o.outline.rings() > 0) return o.outline.corners()[below(o.outline.corners().size())];
    const Corner half{o.row.half[0], o.row.half[1]};
    return {below(2) ? half.x : -half.x, below(2) ? half.y : -half.y};
  }

  void move(OutlineScene& scene) {
    Object &a = scene.a.row, &b = scene.b.row;
    double place[2] = {number(10), number(10)}, velocity[2] = {number(3), number(3)};
    if (family_.motion != Motion::any) meet(scene, place, velocity);
    for (int j = 0; j < 2; ++j) {
      a.x[j] = family_.offset + number(5), a.v[j] = number(2);
      b.x[j] = a.x[j] + place[j], b.v[j] = a.v[j] + velocity[j];
      if (family_.bent) a.a[j] = number(1), b.a[j] = number(1);
      for (auto i = family_.ulps > 0 ? below(family_.ulps + 1) : 0; i > 0; --i)
        b.x[j] = std::nextafter(b.x[j], below(2) ? 1e300 : -1e300);
    }
    const double t = family_.ages > 0 ? scene.question.horizon.now : 0;
    for (Object* o : {&a, &b}) {
      o->t = t;
      if (family_.ages > 0) age(*o, std::abs(number(family_.ages)));
      if (family_.lives) o->until = t + static_cast<double>(below(9));
    }
  }

  /// So much older, and where it was then.
  static void age(Object& o, double years) {
    o.t -= years;
    for (int j = 0; j < 2; ++j) {
      o.v[j] -= o.a[j] * years;
      o.x[j] -= years * (o.v[j] + o.a[j] * years / 2);
    }
  }

  /// Brings a corner of b to one of a.
  void meet(const OutlineScene& scene, double (&place)[2], double (&velocity)[2]) {
    const Corner p = corner_of(scene.a), q = corner_of(scene.b);
    const double time = static_cast<double>(below(9));
    if (family_.motion == Motion::none) velocity[0] = velocity[1] = 0;
    if (family_.motion == Motion::along_an_edge || family_.motion == Motion::through_corners) {
      const auto ring = scene.a.outline.ring(below(scene.a.outline.rings()));
      const auto i = below(ring.size());
      const auto j = family_.motion == Motion::along_an_edge ? (i + 1) % ring.size() : below(ring.size());
      const double pace = std::ldexp(1.0, static_cast<int>(below(4)) - 2) * (below(2) ? 1 : -1);
      velocity[0] = pace * (ring[j].x - ring[i].x), velocity[1] = pace * (ring[j].y - ring[i].y);
      const Corner& start = below(2) ? ring[i] : ring[j];
      place[0] = start.x - q.x - time * velocity[0], place[1] = start.y - q.y - time * velocity[1];
      return;
    }
    place[0] = p.x - q.x - time * velocity[0], place[1] = p.y - q.y - time * velocity[1];
  }

  void scale(OutlineScene& scene) const {
    if (family_.scale == 0) return;
    const double factor = std::ldexp(1.0, family_.scale);
    for (OutlinedObject* o : {&scene.a, &scene.b}) {
      Object& row = o->row;
      for (double* list : {row.x, row.v, row.a, row.half})
        for (int j = 0; j < 2; ++j) list[j] *= factor;
      o->outline = changed(o->outline, {factor, factor});
    }
  }

  const OutlineFamily& family_;
  const OutlinePairing pairing_;
  std::mt19937_64 random_;
};

}  // namespace

Outline outline_of(const std::vector<std::vector<Ring>>& parts) {
  Outline outline;
  for (const auto& part : parts)
    for (const Ring& ring : part) {
      &ring == &part[0] ? outline.begin_part() : outline.begin_hole();
      for (std::size_t i = 0; i < ring.size(); i += 2) outline.add({ring[i] + 0.0, ring[i + 1] + 0.0});
    }
  return outline;
}

Outline changed(const Outline& outline, const Corner& factor) {
  Outline changed;
  for (std::size_t p = 0; p < outline.parts(); ++p)
    for (std::size_t r = outline.part_start(p); r < outline.part_start(p + 1); ++r) {
      r == outline.part_start(p) ? changed.begin_part() : changed.begin_hole();
      for (const Corner& c : outline.ring(r)) changed.add({factor.x * c.x + 0.0, factor.y * c.y + 0.0});
    }
  return changed;
}

std::span<const OutlineFamily> outline_families() {
  using Motion = OutlineFamily::Motion;
  static constexpr OutlineFamily families[] = {
      {.name = "whole"},
      {.name = "any", .whole = false},
      {.name = "an ulp off", .ulps = 2},
      {.name = "corner on corner", .motion = Motion::meets_a_corner},
      {.name = "corner beside corner", .motion = Motion::meets_a_corner, .ulps = 1},
      {.name = "sliding", .motion = Motion::along_an_edge},
      {.name = "sliding an ulp off", .motion = Motion::along_an_edge, .ulps = 1},
      {.name = "through corners", .motion = Motion::through_corners},
      {.name = "past corners", .motion = Motion::through_corners, .ulps = 1},
      {.name = "through corners, any numbers", .motion = Motion::through_corners, .whole = false},
      {.name = "no relative motion", .motion = Motion::none},
      {.name = "no relative motion, an ulp off", .motion = Motion::none, .ulps = 1},
      {.name = "far", .motion = Motion::meets_a_corner, .offset = 1e7},
      {.name = "far, any numbers", .motion = Motion::meets_a_corner, .whole = false, .offset = 1e7},
      {.name = "small", .motion = Motion::meets_a_corner, .scale = -300},
      {.name = "large", .motion = Motion::meets_a_corner, .scale = 200},
      {.name = "aged", .motion = Motion::meets_a_corner, .ages = 64},
      {.name = "aged, any numbers", .whole = false, .ages = 1e6},
      {.name = "short lives", .motion = Motion::meets_a_corner, .lives = true},
      {.name = "lives that no double measures", .motion = Motion::meets_a_corner, .now = 0.1, .lives = true},
      {.name = "slides that no double measures", .motion = Motion::along_an_edge, .now = 0.1, .lives = true},
      {.name = "turned", .motion = Motion::meets_a_corner, .turned = -1},
      {.name = "turned by 90", .motion = Motion::along_an_edge, .turned = 90},
      {.name = "turned by 30", .motion = Motion::along_an_edge, .turned = 30},
  };
  return families;
}

OutlineScene draw_scene(const OutlineFamily& family, OutlinePairing pairing, std::uint64_t seed) {
  return Draw(family, pairing, seed).scene();
}

std::optional<ContactTimes> outline_contact(const OutlineScene& scene) {
  NeverInterrupt never;
  return outline_contact(scene, never);
}

std::optional<ContactTimes> outline_contact(const OutlineScene& scene, Interrupt& interrupt) {
  const std::vector<double> row_a = scene.a.row.row(), row_b = scene.b.row.row();
  const Setup setup{
      {scene.a.row.layout, row_a.data(), 1},
      {scene.b.row.layout, row_b.data(), 1},
      scene.question.horizon,
      PairRule(scene.a.row.layout, scene.b.row.layout, scene.question.within, scene.question.within_z)};
  const OneOutline a(scene.a.outline), b(scene.b.outline);
  const int degree = scene.a.row.layout.law == Law::uniform ? 1 : 2;
  const auto contact = make_outline_contact(setup, {&a, &b}, degree);
  contact->set_interrupt(interrupt);
  return answer_of(*contact);
}

std::string described(const OutlineScene& scene) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const OutlinedObject* o : {&scene.a, &scene.b}) {
    out << "t " << o->row.t << " until " << o->row.until << " half " << o->row.half[0] << ' '
        << o->row.half[1];
    for (int j = 0; j < 2; ++j) out << " axis " << o->row.x[j] << ' ' << o->row.v[j] << ' ' << o->row.a[j];
    for (std::size_t r = 0; r < o->outline.rings(); ++r) {
      out << " ring";
      for (const Corner& c : o->outline.ring(r)) out << " (" << c.x << ' ' << c.y << ')';
    }
    out << '\n';
  }
  return out.str();
}

}  // namespace foresee::testing_by_hand
