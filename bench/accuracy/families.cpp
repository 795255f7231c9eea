#include "accuracy/families.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "accuracy/pair_drafts.h"
#include "base/error.h"

namespace foresee::bench {
namespace {

struct Recipe {
  const char* name;
  double h;
  Draft (*draft)(Maker&);
  int scale = 0;       ///< lengths times 2^scale
  bool moved = false;  ///< one number by one to three units in the last place
  double now = 0;
  double ages = 0;  ///< reference times up to this much before now, each its own
};

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

/// A draft has the positions at `now`; a row has those `age` seconds before.
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
