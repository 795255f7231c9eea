// Avoidance of movers with plans, 'wait' and resume, against the plain join over the legs of single manoeuvres.
// FORESEE_LONG=1: 100 times as many scenes.
#include <cstdlib>

#include "query/avoid/plan_scenes.h"
#include "query/memory_table.h"

namespace foresee {
namespace {

using avoid_oracle::legs_after;
using avoid_oracle::meets;
using avoid_oracle::plan_scene;
using avoid_oracle::PlanScene;
using testing::Random;
using testing::rows_of;
using testing::text_of;

const int plan_rounds = std::getenv("FORESEE_LONG") ? 100 : 1;

/// Any manoeuvre that the object can make, with a range.
void choose_manoeuvre(AvoidQuestion& question, Random& random) {
  const Layout& layout = question.own_scene->layout;
  const double t = question.record[static_cast<std::size_t>(record_offsets(layout).t)];
  std::vector<QueriedChanges> queried{{Manoeuvre::wait, 0, 12}, {Manoeuvre::wait, 2, 8}};
  double lo = question.now - t;
  if (t + lo < question.now) lo = std::nextafter(lo, HUGE_VAL);
  if (t >= question.now && t + lo >= question.now) queried.push_back({Manoeuvre::delay, lo, lo + 9});
  if (!question.plan) {
    queried.push_back({Manoeuvre::speed, -3, 3});
    if (layout.axes > 1) queried.push_back({Manoeuvre::turn, -180, 180});
    if (layout.axes > 1) queried.push_back({Manoeuvre::turn, -60, 90});
    if (layout.axes > 2) queried.push_back({Manoeuvre::climb, -3, 3});
  }
  const QueriedChanges& one = queried[random.below(queried.size())];
  question.how = one.manoeuvre, question.lo = one.lo, question.hi = one.hi;
  const bool turns = *question.how != Manoeuvre::wait && *question.how != Manoeuvre::delay;
  if (turns && random.below(4) != 0)
    question.resume = random.below(2) ? 1 + random.below(6) : random.in(0.1, 9);
  question.touching = random.below(2) ? Touching::part : Touching::ignore;
}

/// The plain answer for one object.
class PlainAnswer {
 public:
  explicit PlainAnswer(const AvoidQuestion& question) : question_(question), how_(*question.how) {
    // At the change: the object where it stands; before a delayed start the stored one.
    std::vector<Leg> first = avoid_oracle::stored_legs(question);
    std::erase_if(first, [&](const Leg& leg) { return leg.until < question.now; });
    if (first.empty()) return;
    is_there_ = true;
    const double s = std::max(question.now, first[0].t);
    if (how_ != Manoeuvre::delay) {
      std::vector<Leg> here;
      for (const Leg& leg : first)
        if (leg.t <= s) here.push_back(avoid_oracle::leg_from(leg, s));
      first = here;
    }
    meets(question, first, {s, 0}, {}, &touching_);
    if (s > question.now + question.h) touching_.clear();
  }

  bool is_there() const { return is_there_; }
  bool touches_first() const { return !touching_.empty(); }
  bool is_clear(double k) const { return is_clear_of(question_, k); }
  /// Also of objects that are larger by 10^-12 of the lengths at hand.
  bool is_surely_clear(double k) const {
    AvoidQuestion larger = question_;
    larger.within += 1e-12 * (100 + question_.within);
    return is_clear(k) && is_clear_of(larger, k);
  }

 private:
  bool is_clear_of(const AvoidQuestion& question, double k) const {
    const auto spared = question.touching == Touching::ignore ? touching_ : std::vector<std::int64_t>{};
    return !meets(question, legs_after(question, how_, k), {question.now, question.h}, spared);
  }

  const AvoidQuestion& question_;
  Manoeuvre how_;
  bool is_there_ = false;
  std::vector<std::int64_t> touching_;
};

/// Changes of a clear row: its ends, the one nearest to 0, some inside and near the ends.
std::vector<double> changes_of_row(const AvoidRow& row, Random& random) {
  std::vector<double> changes{row.k_from, row.k_to, row.k};
  const double width = row.k_to - row.k_from;
  for (int i = 0; i < 6; ++i) changes.push_back(row.k_from + width * random.unit());
  for (int i = 0; i < 4; ++i) {
    const double near = width * std::exp2(-random.in(1, 45));
    changes.push_back(row.k_from + near), changes.push_back(row.k_to - near);
  }
  std::erase_if(changes, [&](double k) { return k < row.k_from || k > row.k_to; });
  return changes;
}

/// The plan of a row has the legs of its k, and k = 0 gives back the stored one.
void expect_plan(const AvoidQuestion& question, const AvoidRow& row) {
  const bool has_legs = question.plan || row.manoeuvre == Manoeuvre::wait || question.resume;
  if (!has_legs || (row.k == 0 && !question.plan)) {
    EXPECT_FALSE(row.plan);
    return;
  }
  ASSERT_TRUE(row.plan);
  check_plan(*row.plan);
  if (row.k == 0) {
    EXPECT_EQ(*row.plan, *question.plan);
    return;
  }
  std::vector<Leg> legs = legs_of(*row.plan);
  const double until = row.record[static_cast<std::size_t>(record_offsets(question.own_scene->layout).until)];
  std::erase_if(legs, [&](const Leg& leg) { return leg.t > until; });
  for (Leg& leg : legs) leg.until = std::min(leg.until, until);
  EXPECT_EQ(legs, legs_after(question, row.manoeuvre, row.k));
  const OwnMotion first = motion_in(question.own_scene->layout, row.record);
  EXPECT_EQ(first.t, legs[0].t);
  EXPECT_EQ(first.x, legs[0].x);
  EXPECT_EQ(first.v, legs[0].v);
}

TEST(AvoidPlans, IsSoundAndTightAgainstThePlainJoinOverLegs) {
  Random random(41);
  int clear = 0, blocked = 0;
  for (int round = 0; round < 600 * plan_rounds; ++round) {
    const PlanScene scene = plan_scene(random, 2 + random.below(8));
    AvoidQuestion question = scene.question(0);
    choose_manoeuvre(question, random);
    question.wants_plan = true;
    SCOPED_TRACE("round " + std::to_string(round) + " " + std::string(name_of(*question.how)));
    const PlainAnswer plain(question);
    const std::vector<AvoidRow> rows = rows_of(question);
    if (rows.empty() || !plain.is_there()) continue;
    const bool separates = question.touching == Touching::part && plain.touches_first();
    const double tolerance = 1e-6 * (rows.back().k_to - rows.front().k_from);
    const bool is_far = std::abs(question.now) > 1e6;  // a start is stored to a unit in its last place
    for (const AvoidRow& row : rows) {
      ASSERT_NO_FATAL_FAILURE(expect_plan(question, row));
      if (row.clear && !separates) {
        ++clear;
        for (const double k : changes_of_row(row, random))
          ASSERT_TRUE(plain.is_clear(k)) << shown(k) << " in\n" << text_of(rows);
      }
      if (row.clear || separates || is_far || !(row.k_to - row.k_from > 4 * tolerance)) continue;
      ++blocked;
      for (int i = 1; i < 40; ++i) {
        const double k = row.k_from + (row.k_to - row.k_from) * i / 40;
        bool touches = false;
        for (int step = -4; step <= 4; ++step) {
          const double near = std::clamp(k + 0.25 * step * tolerance, row.k_from, row.k_to);
          touches = touches || !plain.is_surely_clear(near);
        }
        ASSERT_TRUE(touches) << shown(k) << " seems clear in\n" << text_of(rows);
      }
    }
  }
  EXPECT_GT(clear, 200 * plan_rounds);
  EXPECT_GT(blocked, 100 * plan_rounds);
}

TEST(AvoidPlans, GivesTheSameRowsFromTreesAndFromAScene) {
  Random random(44);
  int blocked = 0;
  for (int round = 0; round < 300 * plan_rounds; ++round) {
    const PlanScene scene = plan_scene(random, 2 + random.below(30));
    AvoidQuestion question = scene.question(0);
    choose_manoeuvre(question, random);
    const std::string plain = text_of(rows_of(question));
    MemoryTable robots("robots", scene.scene->layout);
    for (std::size_t i = 0; i < scene.records.size(); ++i)
      robots.put(static_cast<std::int64_t>(i) + 1, scene.records[i],
                 scene.plans[i] ? legs_of(*scene.plans[i]) : std::vector<Leg>());
    question.others = trees_of(robots);
    EXPECT_EQ(text_of(rows_of(question)), plain) << round;
    blocked += plain.find("blocked") != std::string::npos;
  }
  EXPECT_GT(blocked, 100 * plan_rounds);
}

TEST(AvoidPlans, DecidesZeroAsTheJoin) {
  Random random(42);
  int touching = 0;
  for (int round = 0; round < 400 * plan_rounds; ++round) {
    const PlanScene scene = plan_scene(random, 2 + random.below(5));
    AvoidQuestion question = scene.question(0);
    question.how = Manoeuvre::wait, question.lo = question.hi = 0, question.touching = Touching::ignore;
    const PlainAnswer plain(question);
    const std::vector<AvoidRow> rows = rows_of(question);
    if (rows.empty()) continue;
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].clear, plain.is_clear(0)) << round;
    touching += !rows[0].clear;
  }
  EXPECT_GT(touching, 50 * plan_rounds);
}

TEST(AvoidPlans, RefusesOtherManoeuvresOfAPlan) {
  Random random(43);
  PlanScene scene = plan_scene(random, 3);
  while (!scene.plans[0]) scene = plan_scene(random, 3);
  scene.now = scene.records[0][0];
  AvoidQuestion question = scene.question(0);
  try {
    rows_of(question);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "robots: row 1 has a plan: write 'wait' or 'delay' with lo and hi, as in 'wait', 0, 600");
  }
}

}  // namespace
}  // namespace foresee
