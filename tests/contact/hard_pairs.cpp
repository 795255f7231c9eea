#include "contact/hard_pairs.h"

namespace foresee::testing_by_hand {
namespace {

const Family families[] = {
    {.name = "random"},
    {.name = "random, crowded", .places = 4, .sizes = 2},
    {.name = "random, reference times", .ages = 50},
    {.name = "grazes and ties", .whole = true},
    {.name = "grazes and ties, crowded", .places = 3, .speeds = 2, .turns = 1, .sizes = 2, .whole = true},
    {.name = "almost grazes", .whole = true, .ulps = 3},
    {.name = "almost grazes, reference times", .whole = true, .ulps = 1, .ages = 4},
    {.name = "no extent", .places = 3, .speeds = 2, .turns = 1, .sizes = 0, .whole = true},
    {.name = "almost parallel", .speeds = 1e-7, .turns = 1e-9, .horizon = 1e9},
    {.name = "far from the origin", .whole = true, .ulps = 1, .offset = 1e15},
    {.name = "far and fine", .speeds = 1e3, .sizes = 1e-3, .offset = 1e15, .horizon = 1},
    {.name = "huge acceleration", .turns = 1e9},
    {.name = "instant", .whole = true, .ulps = 1, .horizon = 0},
    {.name = "same motion", .places = 3, .sizes = 1, .whole = true, .same_motion = true},
    {.name = "mixed scales", .spread = 30},
    {.name = "unix times", .whole = true, .ulps = 1, .now = 1.7e9, .ages = 600, .horizon = 600},
    {.name = "unix times, microseconds",
     .places = 1e-2,
     .speeds = 1e4,
     .sizes = 1e-3,
     .now = 1.7e9,
     .ages = 1},
    {.name = "lives", .places = 4, .whole = true, .horizon = 6, .lives = true},
    {.name = "lives, reference times", .places = 4, .ulps = 2, .now = 0.1, .ages = 3, .lives = true},
};

const Family growing[] = {
    {.name = "grows", .growths = 1},
    {.name = "grows, crowded", .places = 4, .sizes = 1, .ages = 4, .growths = 0.5},
    {.name = "grows, grazes and ties", .turns = 1, .sizes = 2, .whole = true, .growths = 2},
    {.name = "grows, almost grazes", .whole = true, .ulps = 3, .ages = 4, .growths = 1},
    {.name = "grows, without size", .speeds = 2, .sizes = 0, .whole = true, .growths = 2},
    {.name = "grows, far from the origin", .whole = true, .ulps = 1, .offset = 1e15, .growths = 2},
    {.name = "grows, unix times", .sizes = 1e-2, .now = 1.7e9, .ages = 600, .horizon = 600, .growths = 1e-2},
    {.name = "grows, mixed scales", .spread = 30, .growths = 1},
    {.name = "grows, lives", .places = 4, .whole = true, .horizon = 6, .lives = true, .growths = 1},
    {.name = "grows, denormal", .whole = true, .ulps = 2, .scale = -1060, .growths = 1},
    {.name = "grows, products underflow", .whole = true, .ulps = 1, .scale = -540, .growths = 1},
    {.name = "grows, products overflow", .whole = true, .ulps = 1, .scale = 700, .growths = 1},
    {.name = "grows, many scales", .spread = 200, .growths = 1},
};

const Family extremes[] = {
    {.name = "denormal", .whole = true, .ulps = 2, .scale = -1060},
    {.name = "products underflow", .whole = true, .ulps = 1, .scale = -540},
    {.name = "products overflow", .whole = true, .ulps = 1, .scale = 700},
    {.name = "many scales", .spread = 200},
};

const Family hostile[] = {
    {.name = "hostile scales", .horizon = 1, .spread = 300},
    {.name = "hostile scales, reference times", .ages = 1, .horizon = 1, .spread = 300},
};

void describe(std::ostream& out, const Object& o) {
  out << "  t " << o.t << " until " << o.until << " law " << static_cast<int>(o.layout.law) << " r " << o.r
      << " hz " << o.hz << " growth " << o.growth << " growth_z " << o.growth_z;
  for (int j = 0; j < o.layout.axes; ++j)
    out << "\n    " << o.x[j] << ", " << o.v[j] << ", " << o.a[j] << ", half " << o.half[j];
  out << "\n";
}

}  // namespace

std::span<const Family> ordinary_families() {
  return families;
}
std::span<const Family> growing_families() {
  return growing;
}
std::span<const Family> extreme_families() {
  return extremes;
}

std::span<const Family> hostile_families() {
  return hostile;
}

oracle::Rule rule_of(const Object& a, const Object& b, const ContactQuestion& question) {
  const auto is_box = [](const Object& o) { return o.layout.shape == Shape::box; };
  const auto is_round = [](const Object& o) { return o.layout.shape != Shape::box; };
  // For shapes of the kind: sizes at their t, and growth from then on.
  auto both = [&](auto of_kind, auto size, int axis) {
    oracle::Coefficients sum(2);
    for (const Object* o : {&a, &b}) {
      if (!of_kind(*o)) continue;
      const bool box = is_box(*o), apart = axis == 2 && (o->layout.has_growth_z || !box);
      const bool grows = apart ? o->layout.has_growth_z : o->layout.has_growth;
      const oracle::Exact rate(!grows ? 0 : apart ? o->growth_z : o->growth);
      sum[0] += oracle::Exact(size(*o)) + (oracle::Exact(question.horizon.now) - oracle::Exact(o->t)) * rate;
      sum[1] += rate;
    }
    return sum;
  };
  auto plus = [](oracle::Coefficients p, const oracle::Coefficients& more) {
    for (std::size_t k = 0; k < more.size(); ++k) p[k] += more[k];
    return p;
  };
  auto is = [&](Shape shape) { return a.layout.shape == shape || b.layout.shape == shape; };
  const bool boxes = a.layout.shape == Shape::box && b.layout.shape == Shape::box;
  const bool upright = is(Shape::cylinder) || question.within_z.has_value();
  oracle::Rule rule;
  if (!boxes)
    rule.radius =
        plus(both(
                 is_round, [](const Object& o) { return o.layout.shape == Shape::point ? 0 : o.r; }, 0),
             {question.within});
  for (int j = 0; j < a.layout.axes; ++j) {
    rule.axes.push_back(oracle::relative_axis(a, b, j, question.horizon.now));
    rule.half.push_back(both(
        is_box, [j](const Object& o) { return o.half[j]; }, j));
    if (boxes) {
      rule.half.back()[0] += question.within;
    } else if (upright && j == 2) {
      rule.half.back()[0] += question.within_z.value_or(0);
      const auto height = [](const Object& o) { return o.layout.shape == Shape::cylinder ? o.hz : 0; };
      rule.half.back() = plus(rule.half.back(), both(is_round, height, j));
    } else {
      rule.round.push_back(j);
    }
  }
  return rule;
}

Case make_case(Generator& generate, const Family& family, Shapes shapes, int axes) {
  const bool box_a = shapes == Shapes::boxes || shapes == Shapes::box_and_ball ||
                     shapes == Shapes::cylinder_and_box || shapes == Shapes::box_and_point_within;
  const bool cylinders = shapes == Shapes::cylinders || shapes == Shapes::cylinder_and_box;
  const bool points = shapes == Shapes::points_within || shapes == Shapes::box_and_point_within;
  const Shape round = points ? Shape::point : cylinders ? Shape::cylinder : Shape::ball;
  const Shape shape_a = box_a ? Shape::box : round, shape_b = shapes == Shapes::boxes ? Shape::box : round;
  Case c{generate.object(axes, shape_a), generate.object(axes, shape_b), {}};
  if (family.same_motion)
    for (int j = 0; j < axes; ++j) c.b.v[j] = c.a.v[j], c.b.a[j] = c.a.a[j], c.b.layout = c.a.layout;
  c.b.layout.shape = shapes == Shapes::cylinders && generate.chance(4) ? Shape::point : shape_b;
  if (c.b.layout.shape == Shape::point) c.b.layout.has_growth = c.b.layout.has_growth_z = false;
  if (generate.chance(2)) std::swap(c.a, c.b);
  c.question.horizon = generate.horizon();
  if (generate.chance(2)) generate.aim(c.a, c.b, c.question.horizon);
  if (points || generate.chance(2)) c.question.within = generate.size();
  if (axes == 3 && (cylinders || points) && generate.chance(2)) c.question.within_z = generate.size();
  return c;
}

std::ostream& operator<<(std::ostream& out, const Case& c) {
  out.precision(17);
  describe(out, c.a);
  describe(out, c.b);
  return out << "  now " << c.question.horizon.now << " h " << c.question.horizon.h << " within "
             << c.question.within << " within_z " << c.question.within_z.value_or(-1);
}

}  // namespace foresee::testing_by_hand
