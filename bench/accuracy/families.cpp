#include "accuracy/families.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/error.h"
#include "scenes.h"

namespace foresee::bench {
namespace {

using testing::Random;

/// A pair in the making: the numbers of a and those of b relative to a. Relative numbers on a lattice of
/// sixteenths stay exact when they are added to those of a.
struct Draft {
  double x[3] = {}, v[3] = {}, a[3] = {};                 ///< of a
  double to_x[3] = {}, to_v[3] = {}, to_a[3] = {};        ///< of b, less those of a
  double half[2][3] = {{1, 1, 1}, {1, 1, 1}}, r[2] = {};  ///< r of balls
};

class Maker {
 public:
  Maker(Random& random, double h) : random(random), h(h) {}

  double lattice(double range) { return std::floor(random.in(-16 * range, 16 * range)) / 16; }
  bool chance(std::uint64_t in) { return random.below(in) == 0; }

  Draft anything(double places, double speeds, double turns) {
    Draft d;
    for (int j = 0; j < 3; ++j) {
      d.x[j] = random.in(-places, places), d.to_x[j] = random.in(-places, places);
      d.v[j] = random.in(-speeds, speeds), d.to_v[j] = random.in(-speeds, speeds);
      d.a[j] = random.in(-turns, turns), d.to_a[j] = random.in(-turns, turns);
      d.half[0][j] = random.in(0.25, 1), d.half[1][j] = random.in(0.25, 1);
    }
    d.r[0] = random.in(0.25, 1), d.r[1] = random.in(0.25, 1);
    return d;
  }

  /// On the lattice: sums and small products are exact.
  Draft plain(double places = 8) {
    Draft d;
    for (int j = 0; j < 3; ++j) {
      d.x[j] = lattice(places), d.v[j] = lattice(3), d.a[j] = lattice(1);
      d.half[0][j] = 0.5 + std::abs(lattice(1)), d.half[1][j] = 0.5 + std::abs(lattice(1));
    }
    return d;
  }

  /// The moment at which something exact is to happen: strictly inside the horizon.
  double moment() { return (1 + static_cast<double>(random.below(14))) / 16 * h; }

  /// Lets b be at `place` of axis j at the moment t0, with the relative speed v and acceleration a of then.
  void pass(Draft& d, int j, double place, double t0, double v, double a) {
    d.to_x[j] = place - v * t0 + a * t0 * t0 / 2;
    d.to_v[j] = v - a * t0;
    d.to_a[j] = a;
  }

  Random& random;
  double h;
};

double total(const Draft& d, int j) {
  return d.half[0][j] + d.half[1][j];
}

/// One random number a statement: the order in which arguments are evaluated is the compiler's choice.
void drift(Maker& m, Draft& d, double t0, double places, double speeds) {
  for (int j = 0; j < 3; ++j) {
    const double place = m.lattice(places), speed = m.lattice(speeds);
    m.pass(d, j, place, t0, speed, 0);
  }
}

Draft graze(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.moment();
  const int axis = static_cast<int>(m.random.below(3));
  drift(m, d, t0, 0.5, 0.5);
  const double side = m.chance(2) ? 1 : -1, bend = 0.25 + std::abs(m.lattice(2));
  m.pass(d, axis, side * total(d, axis), t0, 0, side * bend);
  return d;
}

Draft simultaneous(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.moment();
  drift(m, d, t0, 0.5, 0.25);
  const int leaves = static_cast<int>(m.random.below(3)), enters = (leaves + 1) % 3;
  const double out = 0.5 + std::abs(m.lattice(2)), in = 0.5 + std::abs(m.lattice(2));
  const double bend_out = m.lattice(0.25), bend_in = m.lattice(0.25);
  m.pass(d, leaves, total(d, leaves), t0, out, bend_out);
  m.pass(d, enters, total(d, enters), t0, -in, bend_in);
  return d;
}

/// Radii 5 k in all, b passing 3 k, 4 k to the side: the distance is least, and exactly 5 k, at t0.
Draft tangent(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.moment(), k = 0.125 * static_cast<double>(1 + m.random.below(4));
  d.r[0] = k, d.r[1] = 4 * k;
  const double speed = 0.25 + std::abs(m.lattice(1)), bend = std::abs(m.lattice(0.5));
  const double climb = m.lattice(1), turn = m.lattice(0.5);
  m.pass(d, 0, 3 * k, t0, -4 * speed, 3 * bend);
  m.pass(d, 1, 4 * k, t0, 3 * speed, 4 * bend);
  m.pass(d, 2, 0, t0, climb, turn);
  return d;
}

Draft in_out_in(Maker& m) {
  Draft d = m.anything(8, 1, 0.25);
  const double size = d.r[0] + d.r[1], t0 = m.random.in(0.3, 0.7) * m.h;
  const double depth = m.random.in(1.01, 1.5), bend = m.random.in(4, 8);
  m.pass(d, 0, -size * depth, t0, 0, bend);
  for (int j = 1; j < 3; ++j) {
    const double aside = m.random.in(-0.4, 0.4), speed = m.random.in(-0.1, 0.1);
    m.pass(d, j, size * aside, t0, speed, 0);
  }
  return d;
}

Draft meeting_points(Maker& m) {
  Draft d = m.plain();
  const double t0 = m.moment();
  d.r[0] = m.chance(16) ? 0.0625 : 0;
  for (int j = 0; j < 3; ++j) {
    d.half[0][j] = d.half[1][j] = 0;
    const double place = m.chance(16) ? 0.0625 : 0, speed = m.lattice(2), bend = m.lattice(1);
    m.pass(d, j, place, t0, speed, bend);
  }
  return d;
}

Draft still(Maker& m) {
  Draft d = m.plain();
  const bool touching = m.chance(2);
  for (int j = 0; j < 3; ++j) d.to_x[j] = m.lattice(1.5);
  const double size = d.half[0][0] + d.half[1][0];
  if (touching) d.to_x[0] = size;
  d.r[0] = d.half[0][0], d.r[1] = d.half[1][0];
  return d;
}

Draft near_parallel(Maker& m) {
  Draft d = m.anything(8, 3, 0);
  for (int j = 0; j < 3; ++j) {
    d.to_v[j] = m.random.in(-1e-7, 1e-7);
    d.to_a[j] = m.random.in(-1e-15, 1e-15);
  }
  return d;
}

Draft far_away(Maker& m) {
  Draft d = m.plain(16);
  for (int j = 0; j < 3; ++j) {
    d.x[j] = 1e15 + std::floor(d.x[j] * 2), d.to_x[j] = std::floor(m.lattice(8));
    d.to_v[j] = m.lattice(6), d.to_a[j] = m.lattice(2);
  }
  d.r[0] = d.half[0][0], d.r[1] = d.half[1][0];
  return d;
}

Draft cancelling(Maker& m) {
  Draft d = m.plain();
  for (int j = 0; j < 3; ++j) m.pass(d, j, 0, 0, 0, 0);
  d.to_x[0] = total(d, 0) * (1 + 0x1p-30);
  d.to_v[0] = -1e7 * m.random.in(1, 2);
  d.to_a[0] = m.random.in(0.5, 1);
  return d;
}

Draft mixed(Maker& m) {
  Draft d = m.anything(8, 3, 1);
  auto shift = [&](double& value) { value = std::ldexp(value, static_cast<int>(m.random.below(61)) - 30); };
  for (int j = 0; j < 3; ++j) {
    shift(d.to_x[j]), shift(d.to_v[j]), shift(d.to_a[j]);
    shift(d.half[0][j]), shift(d.half[1][j]);
  }
  shift(d.r[0]), shift(d.r[1]);
  return d;
}

/// Millimetres at ten kilometres a second: an encounter lasts less than a microsecond.
Draft unix_times(Maker& m) {
  Draft d = m.anything(1e-2, 1e4, 10);
  const double meet = m.random.in(0, m.h);
  for (int j = 0; j < 3; ++j) {
    d.to_x[j] = m.random.in(-3e-3, 3e-3) - d.to_v[j] * meet - d.to_a[j] * meet * meet / 2;
    d.half[0][j] = d.half[1][j] = 1e-3;
  }
  d.r[0] = d.r[1] = 1e-3;
  return d;
}

struct Recipe {
  const char* name;
  double h;
  Draft (*draft)(Maker&);
  int scale = 0;       ///< lengths times 2^scale
  bool moved = false;  ///< one number by one to three units in the last place
  double now = 0;
  double ages = 0;  ///< reference times up to this much before now, each its own
};

Draft sparse(Maker& m) {
  return m.anything(16, 3, 0.5);
}
Draft dense(Maker& m) {
  return m.anything(3, 3, 0.5);
}
Draft accelerated(Maker& m) {
  return m.anything(4, 3, 1e9);
}

const Recipe recipes[] = {
    {"box random", 3, sparse},
    {"box dense", 3, dense},
    {"box reference-times", 3, dense, 0, false, 100, 50},
    {"box graze-exact", 8, graze},
    {"box graze-near", 8, graze, 0, true},
    {"box simultaneous-exact", 8, simultaneous},
    {"box simultaneous-near", 8, simultaneous, 0, true},
    {"box near-parallel", 1e8, near_parallel},
    {"box huge-offset", 3, far_away},
    {"box huge-acceleration", 3, accelerated},
    {"box denormal", 8, graze, -1060},
    {"box overflow", 8, graze, 700, true},
    {"box instant", 0, still, 0, true},
    {"box same-motion", 3, still},
    {"box zero-extent", 8, meeting_points},
    {"box cancelling-root", 3, cancelling},
    {"box mixed-scale", 3, mixed},
    {"box unix-times", 1, unix_times, 0, false, 1.7e9, 1},
    {"ball random", 3, sparse},
    {"ball dense", 3, dense},
    {"ball reference-times", 3, dense, 0, false, 100, 50},
    {"ball in-out-in", 4, in_out_in},
    {"ball tangent-exact", 8, tangent},
    {"ball tangent-near", 8, tangent, 0, true},
    {"ball point-meets-point", 8, meeting_points},
    {"ball huge-offset", 3, far_away},
    {"ball near-parallel", 1e8, near_parallel},
    {"ball mixed-scale", 3, mixed},
    {"ball overflow", 8, tangent, 700, true},
    {"ball unix-times", 1, unix_times, 0, false, 1.7e9, 1},
};

/// One number of the row, but not a time, by one to three units in the last place.
void move_one(Random& random, const Family& family, double* row) {
  const Offsets at = row_offsets(family.layout);
  const int sizes = family.balls() ? 1 : 3, first = family.balls() ? at.r : at.half;
  const auto pick = static_cast<int>(random.below(static_cast<std::uint64_t>(6 + sizes)));
  double& number = row[pick < 3 ? at.x + pick : pick < 6 ? at.v + pick - 3 : first + pick - 6];
  const double towards = random.below(2) ? std::numeric_limits<double>::max() : 0;
  for (std::uint64_t steps = 1 + random.below(3); steps > 0; --steps)
    number = std::nextafter(number, towards);
}

/// The draft says where things are at `now`; the row, where they were `age` before.
void write_row(const Family& family, const Draft& d, int side, double age, int scale, double* row) {
  const Offsets at = row_offsets(family.layout);
  row[at.t] = family.horizon.now - age;
  for (int j = 0; j < 3; ++j) {
    const double x = d.x[j] + side * d.to_x[j], v = d.v[j] + side * d.to_v[j], a = d.a[j] + side * d.to_a[j];
    row[at.x + j] = std::ldexp(x - age * (v - 0.5 * a * age), scale);
    row[at.v + j] = std::ldexp(v - a * age, scale);
    row[at.a + j] = std::ldexp(a, scale);
    if (!family.balls()) row[at.half + j] = std::ldexp(d.half[side][j], scale);
  }
  if (family.balls()) row[at.r] = std::ldexp(d.r[side], scale);
}

void fill(Family& family, const Recipe& recipe, std::uint64_t seed) {
  Random random(seed);
  Maker maker(random, recipe.h);
  const auto size = static_cast<std::size_t>(row_offsets(family.layout).size);
  family.rows_a.resize(family.count * size), family.rows_b.resize(family.count * size);
  for (std::size_t i = 0; i < family.count; ++i) {
    const Draft draft = recipe.draft(maker);
    double* rows[] = {family.rows_a.data() + i * size, family.rows_b.data() + i * size};
    for (int side = 0; side < 2; ++side)
      write_row(family, draft, side, recipe.ages > 0 ? recipe.ages * random.unit() : 0, recipe.scale,
                rows[side]);
    if (recipe.moved) move_one(random, family, rows[random.below(2)]);
  }
}

}  // namespace

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes) names.push_back(recipe.name);
  return names;
}

Family make_family(const std::string& name, std::size_t count, std::uint64_t seed) {
  const auto recipe =
      std::find_if(std::begin(recipes), std::end(recipes), [&](const Recipe& r) { return r.name == name; });
  if (recipe == std::end(recipes)) throw Error("there is no family '" + name + "'");
  Family family{name, {.axes = 3, .law = Law::accelerated, .has_t = true}, {recipe->now, recipe->h}, {}, {},
                count};
  family.layout.shape = name.starts_with("ball") ? Shape::ball : Shape::box;
  fill(family, *recipe, seed);
  return family;
}

}  // namespace foresee::bench
