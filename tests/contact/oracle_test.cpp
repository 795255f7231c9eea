// The catalogue of hard cases: seeded families of pairs, every answer compared with the exact one: contact or
// none, and dt, dt_end, t, t_end each the nearest double.
//
// FORESEE_LONG=1 multiplies the number of cases by 50.
#include "contact/oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <span>
#include <sstream>

namespace foresee {
namespace {

using namespace testing_pairs;

/// How the numbers of a family look.
struct Family {
  const char* name;
  double places = 8, speeds = 3, turns = 2, sizes = 3;  ///< ranges of x, v, a, extents
  bool whole = false;        ///< halves of whole numbers: exact touches, ties, grazes
  int ulps = 0;              ///< then moved by up to so many units in the last place
  double offset = 0;         ///< far from the origin
  double now = 0, ages = 0;  ///< reference times lie up to `ages` before now
  double horizon = 8;
  int scale = 0;   ///< lengths times 2^scale
  int spread = 0;  ///< each number times its own power of two within +-spread
  bool same_motion = false;
  bool lives = false;  ///< until, and beginnings within the horizon
};

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

/// Families in which products leave the range of doubles.
const Family extremes[] = {
    {.name = "denormal", .whole = true, .ulps = 2, .scale = -1060},
    {.name = "products underflow", .whole = true, .ulps = 1, .scale = -540},
    {.name = "products overflow", .whole = true, .ulps = 1, .scale = 700},
    {.name = "many scales", .spread = 200},
};

enum class Shapes {
  boxes,
  balls,
  box_and_ball,
  cylinders,
  cylinder_and_box,
  points_within,
  box_and_point_within
};

class Generator {
 public:
  Generator(const Family& family, std::uint64_t seed) : family_(family), random_(seed) {}

  double number(double range) {
    double value = std::uniform_real_distribution<double>(-range, range)(random_);
    if (family_.whole) value = std::round(2 * value) / 2;
    if (family_.spread > 0)
      value = std::ldexp(value, static_cast<int>(random_() % (2 * family_.spread + 1)) - family_.spread);
    for (int i = family_.ulps > 0 ? static_cast<int>(random_() % (family_.ulps + 1)) : 0; i > 0; --i)
      value = std::nextafter(value, random_() % 2 ? 1e300 : -1e300);
    return value;
  }
  double length(double range) { return std::ldexp(number(range), family_.scale); }
  double size() { return std::abs(length(family_.sizes)); }
  bool chance(int in) { return random_() % in == 0; }

  Object object(int axes, Shape shape) {
    Object o = testing_pairs::object(axes, shape);
    o.layout.law = static_cast<Law>(std::min<int>(2, static_cast<int>(random_() % 4)));
    for (int j = 0; j < axes; ++j) {
      o.x[j] = length(family_.places) + family_.offset;
      o.v[j] = length(family_.speeds), o.a[j] = length(family_.turns);
      o.half[j] = size();
    }
    o.r = size(), o.hz = size();
    o.t = family_.now;
    if (family_.ages > 0) o.t -= std::abs(number(family_.ages));
    if (family_.lives && chance(2)) o.t = family_.now + number(family_.horizon);
    if (family_.lives && chance(2)) o.until = o.t + std::abs(number(family_.horizon));
    return o;
  }

  /// Moves b so that it comes near a at some moment of the horizon: otherwise rare families never meet.
  void aim(const Object& a, Object& b, const Horizon& horizon) {
    const double meet = horizon.now + std::abs(number(horizon.h));
    auto displacement = [meet](const Object& o, int j) {
      const double s = meet - o.t;
      const double v = o.layout.law == Law::rest ? 0 : o.v[j],
                   a = o.layout.law < Law::accelerated ? 0 : o.a[j];
      return s * v + s * s * a / 2;
    };
    for (int j = 0; j < b.layout.axes; ++j)
      b.x[j] = a.x[j] + displacement(a, j) - displacement(b, j) + (chance(3) ? 0 : length(2 * family_.sizes));
  }

  Horizon horizon() {
    return {family_.now,
            family_.horizon == 0 || chance(3) ? family_.horizon : std::abs(number(family_.horizon))};
  }

 private:
  Family family_;
  std::mt19937_64 random_;
};

struct Case {
  Object a, b;
  ContactQuestion question;
  oracle::Rule rule;
};

using oracle::Rational;

Case make_case(Generator& generate, const Family& family, Shapes shapes, int axes) {
  const bool box_a = shapes == Shapes::boxes || shapes == Shapes::box_and_ball ||
                     shapes == Shapes::cylinder_and_box || shapes == Shapes::box_and_point_within;
  const bool cylinders = shapes == Shapes::cylinders || shapes == Shapes::cylinder_and_box;
  const bool points = shapes == Shapes::points_within || shapes == Shapes::box_and_point_within;
  const Shape round = points ? Shape::point : cylinders ? Shape::cylinder : Shape::ball;
  const Shape shape_a = box_a ? Shape::box : round, shape_b = shapes == Shapes::boxes ? Shape::box : round;
  Case c{generate.object(axes, shape_a), generate.object(axes, shape_b), {}, {}};
  if (family.same_motion)
    for (int j = 0; j < axes; ++j) c.b.v[j] = c.a.v[j], c.b.a[j] = c.a.a[j], c.b.layout = c.a.layout;
  c.b.layout.shape = shape_b;
  if (generate.chance(2)) std::swap(c.a, c.b);
  c.question.horizon = generate.horizon();
  if (generate.chance(2)) generate.aim(c.a, c.b, c.question.horizon);
  if (points || generate.chance(2)) c.question.within = generate.size();
  if (cylinders && generate.chance(2)) c.question.within_z = generate.size();

  std::vector<oracle::Coefficients> along;
  std::vector<Rational> half;
  std::vector<int> rounds;
  Rational radius = c.question.within;
  for (const Object* o : {&c.a, &c.b})
    if (o->layout.shape == Shape::ball || o->layout.shape == Shape::cylinder) radius += Rational(o->r);
  for (int j = 0; j < axes; ++j) {
    along.push_back(oracle::relative_axis(c.a, c.b, j, c.question.horizon.now));
    half.emplace_back(0);
    for (const Object* o : {&c.a, &c.b})
      if (o->layout.shape == Shape::box) half.back() += Rational(o->half[j]);
    const bool alone = shapes == Shapes::boxes || (cylinders && j == 2);
    if (!alone) {
      rounds.push_back(j);
      continue;
    }
    half.back() +=
        shapes == Shapes::boxes ? Rational(c.question.within) : Rational(c.question.within_z.value_or(0));
    for (const Object* o : {&c.a, &c.b})
      if (o->layout.shape == Shape::cylinder) half.back() += Rational(o->hz);
  }
  c.rule = oracle::distance_rule(along, half, rounds, radius);
  return c;
}

void describe(std::ostream& out, const Object& o) {
  out << "  t " << o.t << " until " << o.until << " law " << static_cast<int>(o.layout.law) << " r " << o.r
      << " hz " << o.hz;
  for (int j = 0; j < o.layout.axes; ++j)
    out << "\n    " << o.x[j] << ", " << o.v[j] << ", " << o.a[j] << ", half " << o.half[j];
  out << "\n";
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// Sanitizers make the judge twenty times slower: they see fewer cases.
int scaled_count(int cases) {
  return std::getenv("FORESEE_LONG") ? cases * 50 : sanitized ? (cases + 19) / 20 : cases;
}

void check(const Family& family, Shapes shapes, int axes, int cases, std::uint64_t seed) {
  Generator generate(family, seed);
  int contacts = 0;
  for (int i = 0; i < scaled_count(cases); ++i) {
    const Case c = make_case(generate, family, shapes, axes);
    const auto answer = contact(c.a, c.b, c.question);
    contacts += answer.has_value();
    const std::string complaint = oracle::judge(c.rule, c.a, c.b, c.question.horizon, answer);
    if (complaint.empty()) continue;
    std::ostringstream story;
    story.precision(17);
    describe(story, c.a);
    describe(story, c.b);
    story << "  now " << c.question.horizon.now << " h " << c.question.horizon.h << " within "
          << c.question.within;
    if (answer)
      story << "\n  answer dt " << answer->dt << " dt_end " << answer->dt_end << " t " << answer->t
            << " t_end " << answer->t_end;
    FAIL() << family.name << ", axes " << axes << ", case " << i << ": " << complaint << "\n" << story.str();
  }
  // A family in which nothing ever meets would prove nothing.
  if (family.spread == 0 && scaled_count(cases) >= 50 && axes < 3) {
    EXPECT_GT(contacts, 0) << family.name;
  }
}

template <class Families>
void check_all(const Families& list, Shapes shapes, std::initializer_list<int> all_axes, int cases) {
  std::uint64_t seed = 1000 * (static_cast<int>(shapes) + 1);
  for (const Family& family : list)
    for (int axes : all_axes) check(family, shapes, axes, cases, seed++);
}

TEST(Oracle, BoxesInOneDimension) {
  check_all(families, Shapes::boxes, {1}, 400);
}
TEST(Oracle, BoxesInTwoDimensions) {
  check_all(families, Shapes::boxes, {2}, 400);
}
TEST(Oracle, BoxesInThreeDimensions) {
  check_all(families, Shapes::boxes, {3}, 300);
}
TEST(Oracle, BoxesOfExtremeNumbers) {
  check_all(extremes, Shapes::boxes, {1, 2, 3}, 60);
}
TEST(Oracle, BallsInOneDimension) {
  check_all(families, Shapes::balls, {1}, 50);
}
TEST(Oracle, BallsInTwoDimensions) {
  check_all(families, Shapes::balls, {2}, 120);
}
TEST(Oracle, BallsInThreeDimensions) {
  check_all(families, Shapes::balls, {3}, 60);
}
TEST(Oracle, BallsOfExtremeNumbers) {
  check_all(extremes, Shapes::balls, {2, 3}, 40);
}
TEST(Oracle, PointsWithinADistance) {
  check_all(families, Shapes::points_within, {1, 2, 3}, 20);
}
TEST(Oracle, BoxAndBall) {
  check_all(families, Shapes::box_and_ball, {1, 2}, 6);
}
TEST(Oracle, BoxAndBallInThreeDimensions) {
  check_all(std::span(families).first(5), Shapes::box_and_ball, {3}, 1);
}
TEST(Oracle, BoxAndPointWithinADistance) {
  check_all(families, Shapes::box_and_point_within, {2}, 3);
}
TEST(Oracle, Cylinders) {
  check_all(families, Shapes::cylinders, {3}, 60);
}
TEST(Oracle, CylinderAndBox) {
  check_all(families, Shapes::cylinder_and_box, {3}, 2);
}

}  // namespace
}  // namespace foresee
