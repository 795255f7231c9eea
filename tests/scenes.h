// Seeded random scenes of every layout, the same on every compiler and machine.
//
//   RandomScene scene = random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball},
//                                     .kind = SceneKind::clustered, .count = 1000, .seed = 7});
//   Bodies bodies = scene.bodies();                      // query with scene.now, scene.h, scene.within
//
// A uniform scene has about one true pair per object (objects in motion for h, `within` as given). The other
// kinds move some objects together and have more. Times, where declared, straddle `now`: some objects start
// later, some have ended before.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "sanitized.h"
#include "shape/bodies.h"

namespace foresee::testing {

/// splitmix64: small, seeded, and written out here so that the numbers depend on no library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double in(double lower, double upper) { return lower + (upper - lower) * unit(); }
  /// In [0, bound).
  std::uint64_t below(std::uint64_t bound) { return next() % bound; }

 private:
  std::uint64_t state_;
};

enum class SceneKind {
  uniform,            ///< the same density everywhere
  clustered,          ///< eight crowds
  one_giant,          ///< uniform, and one object as large as the space
  one_fast,           ///< uniform, and one object that crosses the space a hundred times over
  one_spot,           ///< every centre at one place
  identical_motions,  ///< one motion for all; neighbours on a lattice that touch, or narrowly do not
  zero_extents,       ///< points; centres and motions on a lattice, so that some do meet
};

inline constexpr SceneKind all_scene_kinds[] = {
    SceneKind::uniform,  SceneKind::clustered,         SceneKind::one_giant,   SceneKind::one_fast,
    SceneKind::one_spot, SceneKind::identical_motions, SceneKind::zero_extents};

inline std::string name_of(SceneKind kind) {
  const char* names[] = {"uniform",  "clustered",         "one giant",   "one fast",
                         "one spot", "identical motions", "zero extents"};
  return names[static_cast<int>(kind)];
}

inline std::string name_of(const Layout& layout) {
  const char* laws[] = {"rest", "uniform", "accelerated", "forced"};
  const char* shapes[] = {"point", "box", "ball", "cylinder"};
  return std::to_string(layout.axes) + " axes, " + laws[static_cast<int>(layout.law)] + ", " +
         shapes[static_cast<int>(layout.shape)] + (layout.has_t ? ", t" : "") +
         (layout.has_until ? ", until" : "") + (layout.has_growth ? ", growth" : "") +
         (layout.has_growth_z ? ", growth_z" : "") + (layout.starts_as_point ? ", a point at first" : "") +
         (layout.has_category ? ", category" : "") + (layout.has_mask ? ", mask" : "");
}

/// Layouts with growing extents: every axes x shape x law, t and until declared by turns.
inline std::vector<Layout> growing_layouts() {
  std::vector<Layout> layouts;
  const auto add = [&layouts](Layout layout) {
    for (const Law law : {Law::rest, Law::uniform, Law::accelerated, Law::forced}) {
      const std::size_t turn = layouts.size() + layouts.size() / 4;
      layout.law = law, layout.has_t = (turn & 1) != 0, layout.has_until = (turn & 2) != 0;
      layouts.push_back(layout);
    }
  };
  for (int axes = 1; axes <= 3; ++axes) {
    add({.axes = axes, .shape = Shape::ball, .has_growth = true, .starts_as_point = true});
    add({.axes = axes, .shape = Shape::box, .has_growth = true});
    if (axes > 1) add({.axes = axes, .shape = Shape::ball, .has_growth = true});
  }
  add({.axes = 3, .shape = Shape::box, .has_growth_z = true});
  add({.axes = 3, .shape = Shape::cylinder, .has_growth = true});
  add({.axes = 3,
       .shape = Shape::cylinder,
       .has_growth = true,
       .has_growth_z = true,
       .starts_as_point = true});
  return layouts;
}

/// Every axes x law x shape x (t or not) x (until or not) that can be declared, and some growing_layouts().
inline std::vector<Layout> all_layouts() {
  std::vector<Layout> layouts;
  for (int axes = 1; axes <= 3; ++axes)
    for (Law law : {Law::rest, Law::uniform, Law::accelerated, Law::forced})
      for (Shape shape : {Shape::point, Shape::box, Shape::ball, Shape::cylinder})
        for (int times = 0; times < 4; ++times)
          if (shape != Shape::cylinder || axes == 3)
            layouts.push_back({axes, law, shape, (times & 1) != 0, (times & 2) != 0});
  const std::vector<Layout> growing = growing_layouts();
  layouts.insert(layouts.end(), growing.begin(), growing.end());
  return layouts;
}

/// All layouts; under sanitizers each axes x law x shape once, t and until declared by turns.
inline std::vector<Layout> varied_layouts() {
  const std::vector<Layout> all = all_layouts();
  if (!sanitized) return all;
  std::vector<Layout> some;
  for (std::size_t i = 0; i < all.size() / 4; ++i) some.push_back(all[4 * i + i % 4]);
  return some;
}

struct SceneSpec {
  Layout layout;
  SceneKind kind = SceneKind::uniform;
  std::size_t count = 100;
  std::uint64_t seed = 1;
};

struct RandomScene {
  Layout layout;
  std::vector<std::int64_t> ids;  ///< 1 to count, shuffled
  std::vector<double> records;    ///< in the order of record_offsets(layout)
  std::vector<double> rows;       ///< in the order of row_offsets(layout)
  double side = 0;                ///< centres start in [0, side] on every axis
  double now = 0, h = 3, within = 0;

  std::size_t size() const { return ids.size(); }
  Bodies bodies() const { return {layout, rows.data(), ids.size()}; }
  Horizon horizon() const { return {now, h}; }
};

/// Fills one record after another; each part of a record has its own function.
class SceneMaker {
 public:
  explicit SceneMaker(const SceneSpec& spec)
      : spec_(spec), at_(record_offsets(spec.layout)), random_(spec.seed) {
    const double room_at_rest[] = {1, 2, 4}, room_in_motion[] = {4, 14, 40};  // per object, for one pair each
    const double room = (spec.layout.law == Law::rest ? room_at_rest : room_in_motion)[spec.layout.axes - 1];
    side_ = std::floor(std::pow(room * static_cast<double>(spec.count), 1.0 / spec.layout.axes)) + 1;
    for (double& c : crowd_) c = random_.in(0, side_);
    for (double& c : common_) c = random_.in(-1, 1);
  }

  RandomScene make() {
    RandomScene scene;
    scene.layout = spec_.layout;
    scene.side = side_;
    scene.within = spec_.layout.shape == Shape::point && spec_.kind != SceneKind::zero_extents ? 1 : 0;
    scene.ids.resize(spec_.count);
    std::iota(scene.ids.begin(), scene.ids.end(), std::int64_t{1});
    for (std::size_t i = spec_.count; i > 1; --i) std::swap(scene.ids[i - 1], scene.ids[random_.below(i)]);

    const auto stored = static_cast<std::size_t>(at_.size);
    const auto read = static_cast<std::size_t>(row_offsets(spec_.layout).size);
    scene.records.resize(spec_.count * stored);
    scene.rows.resize(spec_.count * read);
    for (std::size_t i = 0; i < spec_.count; ++i) {
      double* record = scene.records.data() + i * stored;
      fill(record, i == spec_.count / 2);
      row_from_record(spec_.layout, record, scene.rows.data() + i * read);
    }
    return scene;
  }

 private:
  /// `special` is the giant of one_giant and the racer of one_fast.
  void fill(double* record, bool special) {
    if (at_.t != Offsets::absent) record[at_.t] = on_lattice() ? 0 : random_.in(-2, 1);
    fill_centre(record + at_.x);
    if (at_.v != Offsets::absent) fill_velocity(record + at_.v, special);
    if (at_.a != Offsets::absent) fill_acceleration(record + at_.a, 1);
    if (at_.force != Offsets::absent) {
      const double mass = on_lattice() ? 2 : random_.in(0.5, 4);
      fill_acceleration(record + at_.force, mass);
      record[at_.mass] = mass;
    }
    fill_extents(record, special);
    if (at_.until != Offsets::absent) {
      const double t = at_.t != Offsets::absent ? record[at_.t] : 0;
      const double infinity = std::numeric_limits<double>::infinity();
      record[at_.until] = random_.below(2) ? infinity : t + random_.in(0, 6);
    }
    for (const int place : {at_.category, at_.mask})
      if (place != Offsets::absent) record[place] = kinds();
  }

  void fill_centre(double* x) {
    const std::uint64_t crowd = random_.below(8);
    for (int axis = 0; axis < spec_.layout.axes; ++axis) {
      const double place = random_.in(0, side_);
      switch (spec_.kind) {
        case SceneKind::clustered:
          x[axis] = crowd_[crowd * 3 + static_cast<std::uint64_t>(axis)] + (place - side_ / 2) / 8;
          break;
        case SceneKind::one_spot:
          x[axis] = side_ / 2;
          break;
        case SceneKind::identical_motions:
        case SceneKind::zero_extents:
          x[axis] = std::floor(place);
          break;
        default:
          x[axis] = place;
      }
    }
  }

  void fill_velocity(double* v, bool special) {
    for (int axis = 0; axis < spec_.layout.axes; ++axis) {
      v[axis] = random_.in(-3, 3);
      if (spec_.kind == SceneKind::identical_motions) v[axis] = common_[axis];
      if (spec_.kind == SceneKind::zero_extents) v[axis] = std::floor(v[axis] / 2);
      if (spec_.kind == SceneKind::one_fast && special) v[axis] = (axis % 2 ? -100 : 100) * side_;
    }
  }

  /// An acceleration, or the force that gives it to a mass.
  void fill_acceleration(double* a, double mass) {
    for (int axis = 0; axis < spec_.layout.axes; ++axis) {
      a[axis] = random_.in(-0.5, 0.5) * mass;
      if (spec_.kind == SceneKind::identical_motions) a[axis] = common_[3 + axis] * mass;
      if (spec_.kind == SceneKind::zero_extents) a[axis] = (random_.unit() < 0.5 ? 0 : 2) * mass;
    }
  }

  void fill_extents(double* record, bool special) {
    auto extent = [&] {
      if (spec_.kind == SceneKind::zero_extents) return 0.0;
      if (spec_.kind == SceneKind::one_giant && special) return side_;
      return on_lattice() ? 0.5 : random_.in(0.25, 0.75);
    };
    if (at_.half != Offsets::absent)
      for (int axis = 0; axis < spec_.layout.axes; ++axis) record[at_.half + axis] = extent();
    if (at_.r != Offsets::absent) record[at_.r] = extent();
    if (at_.hz != Offsets::absent) record[at_.hz] = extent();
    for (const int place : {at_.growth, at_.growth_z})
      if (place != Offsets::absent) record[place] = extent() / 4;
  }

  /// Bits of a category or a mask: none, all, one, or several of few.
  double kinds() {
    constexpr double some[] = {0, 4294967295, 1, 2, 2147483648, 3, 6, 5};
    return some[random_.below(8)];
  }

  bool on_lattice() const {
    return spec_.kind == SceneKind::identical_motions || spec_.kind == SceneKind::zero_extents;
  }

  SceneSpec spec_;
  Offsets at_;
  Random random_;
  double side_ = 0;
  double crowd_[24], common_[6];
};

inline RandomScene random_scene(const SceneSpec& spec) {
  return SceneMaker(spec).make();
}

}  // namespace foresee::testing
