// Laws of avoidance: a scene rotated by right angles, or in other units, has the same rows. A shorter horizon
// and smaller shapes never block what was clear.
#include <functional>

#include "query/avoid/avoid_cases.h"

namespace foresee {
namespace {

using testing::avoid_question;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::rows_of;

/// The quantity of a number of a row.
enum class Of : std::uint8_t { time, place, speed, acceleration, force, size, growth };
using Change = std::function<void(double& number, Of what)>;

void change_numbers(const Offsets& at, int axes, double* numbers, const Change& change) {
  const auto each = [&](int place, int count, Of what) {
    for (int i = 0; i < count && place != Offsets::absent; ++i) change(numbers[place + i], what);
  };
  each(at.t, 1, Of::time), each(at.until, 1, Of::time);
  each(at.x, axes, Of::place), each(at.v, axes, Of::speed), each(at.a, axes, Of::acceleration);
  each(at.force, axes, Of::force);
  each(at.half, axes, Of::size), each(at.r, 1, Of::size), each(at.hz, 1, Of::size);
  each(at.growth, 1, Of::growth), each(at.growth_z, 1, Of::growth);
}

RandomScene changed(RandomScene scene, const Change& change) {
  const auto all = [&](std::vector<double>& numbers, const Offsets& at) {
    for (std::size_t i = 0; i < scene.size(); ++i)
      change_numbers(at, scene.layout.axes, numbers.data() + i * static_cast<std::size_t>(at.size), change);
  };
  all(scene.records, record_offsets(scene.layout));
  all(scene.rows, row_offsets(scene.layout));
  change(scene.now, Of::time), change(scene.h, Of::time), change(scene.within, Of::size);
  return scene;
}

/// x east and y north become y and -x, exactly.
RandomScene turned_right(RandomScene scene) {
  const auto all = [&](std::vector<double>& numbers, const Offsets& at) {
    for (std::size_t i = 0; i < scene.size(); ++i) {
      double* const row = numbers.data() + i * static_cast<std::size_t>(at.size);
      for (const int place : {at.x, at.v, at.a, at.force})
        if (place != Offsets::absent) row[place] = std::exchange(row[place + 1], -row[place]);
      if (at.half != Offsets::absent) std::swap(row[at.half], row[at.half + 1]);
    }
  };
  all(scene.records, record_offsets(scene.layout));
  all(scene.rows, row_offsets(scene.layout));
  return scene;
}

std::vector<AvoidRow> queried(const RandomScene& scene, std::size_t i, Manoeuvre how, double hi) {
  AvoidQuestion question = avoid_question(scene, i, testing::as_scene(scene));
  question.how = how, question.lo = -hi, question.hi = hi;
  question.wants_ends = question.wants_motion = false;
  return rows_of(question);
}

void expect_same_rows(const std::vector<AvoidRow>& rows, const std::vector<AvoidRow>& others, double unit) {
  ASSERT_EQ(rows.size(), others.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].clear, others[i].clear);
    EXPECT_NEAR(unit * rows[i].k_to, others[i].k_to, 1e-8 * std::abs(unit * rows.back().k_to));
  }
}

/// use(scene, number of an object) for scenes of every layout.
template <class Use>
void for_each_scene(Use&& use) {
  Random random(9);
  for (const Layout& layout : testing::varied_layouts()) {
    if (layout.law == Law::rest) continue;
    const RandomScene scene = random_scene({.layout = layout, .count = 15, .seed = random.below(1 << 20)});
    SCOPED_TRACE(testing::name_of(layout));
    use(scene, random.below(scene.size()));
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(AvoidLaws, ASceneTurnedByRightAnglesHasTheSameRows) {
  for_each_scene([](const RandomScene& scene, std::size_t i) {
    if (scene.layout.axes == 1) return;
    for (const Manoeuvre how : {Manoeuvre::turn, Manoeuvre::speed})
      expect_same_rows(queried(scene, i, how, 4), queried(turned_right(scene), i, how, 4), 1);
  });
}

TEST(AvoidLaws, OtherUnitsChangeNothing) {
  const double length = 0x1p20, time = 0x1p-7;
  const Change units = [=](double& number, Of what) {
    switch (what) {
      case Of::time:
        return void(number *= time);
      case Of::place:
      case Of::size:
        return void(number *= length);
      case Of::speed:
      case Of::growth:
        return void(number *= length / time);
      case Of::acceleration:
      case Of::force:
        return void(number *= length / time / time);
    }
  };
  for_each_scene([&](const RandomScene& scene, std::size_t i) {
    const RandomScene other = changed(scene, units);
    const double speed = length / time;
    expect_same_rows(queried(scene, i, Manoeuvre::speed, 4), queried(other, i, Manoeuvre::speed, 4 * speed),
                     speed);
    if (scene.layout.axes > 1)
      expect_same_rows(queried(scene, i, Manoeuvre::turn, 180), queried(other, i, Manoeuvre::turn, 180), 1);
  });
}

/// What is clear of larger shapes for longer is clear of smaller ones.
TEST(AvoidLaws, AShorterHorizonAndSmallerShapesBlockNoMore) {
  for_each_scene([](const RandomScene& scene, std::size_t i) {
    RandomScene shorter = scene;
    shorter.h = scene.h / 2;
    const RandomScene smaller = changed(scene, [](double& number, Of what) {
      if (what == Of::size || what == Of::growth) number *= 0.5;
    });
    for (const RandomScene* less : {&std::as_const(shorter), &smaller}) {
      AvoidQuestion question = avoid_question(*less, i, testing::as_scene(*less));
      question.touching = Touching::ignore;
      AvoidQuestion whole = avoid_question(scene, i, testing::as_scene(scene));
      whole.how = Manoeuvre::speed, whole.lo = -4, whole.hi = 4, whole.wants_ends = false;
      for (const AvoidRow& row : rows_of(whole))
        for (const double k : {row.k_from, row.k, row.k_to}) {
          if (!row.clear) continue;
          EXPECT_TRUE(testing::is_clear(question, Manoeuvre::speed, k)) << k;
        }
    }
  });
}

}  // namespace
}  // namespace foresee
