// Wrong scenes, numbers and missing parts: each is an Error that names what is wrong, and nothing else happens.
#include <gtest/gtest.h>

#include <functional>

#include "never_interrupt.h"
#include "query/avoid/avoid.h"
#include "query/join_cases.h"
#include "query/memory_table.h"
#include "query/nearest/nearest.h"
#include "query/position/tracks.h"
#include "query/sweep/sweep.h"
#include "query/watch/memory_watch.h"
#include "query/watch/pair_update.h"
#include "query/window/window.h"

namespace foresee::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

const std::vector<double> rows_of_two{0, 0, 1, 0, 1, 10, 0, -1, 0, 1};

std::shared_ptr<const Scene> two_discs() {
  return scene_of(discs, {1, 2}, rows_of_two);
}

constexpr Layout kinds_of_discs{.axes = 2,
                                .law = Law::uniform,
                                .shape = Shape::ball,
                                .has_t = true,
                                .has_until = true,
                                .has_category = true,
                                .has_mask = true};

TEST(CheckNumbers, NameSceneIdAndNumber) {
  const std::vector<double> valid{0, 1, 2, 3, 4, 5, inf, 1, 4294967295};  // t, x, y, vx, vy, r, until, kinds
  const auto with = [&](std::size_t place, double number) {
    std::vector<double> rows = valid;
    rows.insert(rows.end(), valid.begin(), valid.end());
    rows[valid.size() + place] = number;
    return message_of([&] { check_numbers(*scene_of(kinds_of_discs, {6, 7}, rows)); });
  };
  EXPECT_EQ(with(0, 0), "no error");
  EXPECT_EQ(with(6, 0), "no error");
  EXPECT_EQ(with(1, nan), "ships: row 7: x is nan; write a finite number");
  EXPECT_EQ(with(4, -inf), "ships: row 7: vy is -inf; write a finite number");
  EXPECT_EQ(with(5, -1), "ships: row 7: r is -1; write a finite number >= 0");
  EXPECT_EQ(with(5, inf), "ships: row 7: r is inf; write a finite number >= 0");
  EXPECT_EQ(with(6, nan), "ships: row 7: until is nan; write a time, or +infinity");
  EXPECT_EQ(with(6, -1), "ships: row 7: until is -1, before t, which is 0; write a later time");
  for (const double kind : {nan, -1.0, 0.5, 4294967296.0, 1e30, inf}) {
    EXPECT_NE(with(7, kind).find("row 7: category is "), std::string::npos) << kind;
    EXPECT_NE(with(8, kind).find("row 7: mask is "), std::string::npos) << kind;
  }
}

TEST(CheckNumbers, KindsThatAreNoBitsMeetNothing) {
  for (const double kind : {nan, -1.0, 4294967296.0, 1e30, inf, -inf}) EXPECT_EQ(kind_bits(kind), 0u) << kind;
  EXPECT_EQ(kind_bits(4294967295.0), every_kind);
  for (const double kind : {nan, 1e30}) {
    const auto scene = scene_of(kinds_of_discs, {1, 2},
                                {0, 0, 0, 0, 0, 1, inf, kind, 1,  //
                                 0, 0, 0, 0, 0, 1, inf, 1, 1});
    EXPECT_TRUE(rows_of({.a = scene, .h = 1}).empty());
  }
}

TEST(WrongScenes, AreErrorsOfEveryQuery) {
  const auto message = [](const Layout& layout, const std::vector<double>& rows) {
    const auto scene = scene_of(layout, {1, 2}, rows);
    const std::string of_join = message_of([&] { Join({.a = scene, .h = 1}, never); });
    EXPECT_EQ(of_join, message_of([&] { Join({.a = two_discs(), .b = scene, .h = 1}, never); }));
    EXPECT_EQ(of_join, message_of([&] { Window({.objects = {"ships", scene, nullptr}}, never); }));
    EXPECT_EQ(of_join, message_of([&] { nearest({.objects = {"ships", scene, nullptr}}, never); }));
    EXPECT_EQ(of_join, message_of([&] { Positions(scene, 0); }));
    EXPECT_EQ(of_join, message_of([&] { Tracks(scene, {0, 1, 1}, never); }));
    EXPECT_EQ(of_join, message_of([&] { check_numbers(*scene); }));
    return of_join;
  };
  const auto of_layout = [&](const Layout& layout) {
    return message(layout, std::vector<double>(2 * static_cast<std::size_t>(row_offsets(layout).size)));
  };
  EXPECT_EQ(message(discs, {rows_of_two.begin(), rows_of_two.end() - 1}),
            "ships: 2 ids need 10 numbers in rows, not 9; a row has 5");
  EXPECT_EQ(message(discs, {}), "ships: 2 ids need 10 numbers in rows, not 0; a row has 5");
  for (const int axes : {0, 4, -1}) {
    Layout wrong = discs;
    wrong.axes = axes;
    EXPECT_EQ(message(wrong, rows_of_two), "ships: a layout has 1, 2 or 3 axes, not " + std::to_string(axes));
  }
  EXPECT_EQ(of_layout({.axes = 2, .law = Law::uniform, .shape = Shape::cylinder}),
            "ships: the shape of the layout needs 3 axes, not 2");
  EXPECT_NE(of_layout({.axes = 2, .law = Law::uniform, .has_plan = true}).find("has_t, has_until"),
            std::string::npos);
  const Layout of_plans{.axes = 2, .law = Law::uniform, .has_t = true, .has_until = true, .has_plan = true};
  EXPECT_NE(of_layout(of_plans).find("find_movers()"), std::string::npos);
}

TEST(WrongScenes, HaveNoOutlines) {
  const Layout outlines{.axes = 2, .shape = Shape::outline};
  const auto scene =
      scene_of(outlines, {1}, std::vector<double>(static_cast<std::size_t>(row_offsets(outlines).size)));
  const char* const message = "ships: the scene has no outlines or meshes; call take_forms()";
  EXPECT_EQ(message_of([&] { Join({.a = scene}, never); }), message);
  EXPECT_EQ(message_of([&] { Window({.objects = {"ships", scene, nullptr}}, never); }), message);
  EXPECT_TRUE(Positions(scene, 0).next());  // only contact reads them
}

TEST(WrongScenes, HaveNoLevelsForTheMethodTree) {
  EXPECT_NE(
      message_of([] { Join({.a = two_discs(), .method = JoinMethod::tree}, never); }).find("needs levels"),
      std::string::npos);
  const auto stale = std::make_shared<Scene>();
  stale->name = "ships", stale->layout = discs, stale->ids = {1, 2}, stale->rows = rows_of_two;
  stale->levels = TreeLevels{{{0, 1}}};
  EXPECT_NE(message_of([&] { Join({.a = stale}, never); }).find("levels do not fit"), std::string::npos);
}

TEST(WrongScenes, RowsAddedAfterAJoinHaveTheirKinds) {
  const auto scene = std::make_shared<Scene>();
  scene->name = "ships", scene->layout = kinds_of_discs;
  const std::vector<double> record{0, 0, 0, 0, 0, 1, inf, 1, 1};
  for (std::int64_t id = 1; id <= 2; ++id) scene->add(id, record.data());
  EXPECT_EQ(rows_of({.a = scene, .h = 1}).size(), 1u);
  for (std::int64_t id = 3; id <= 40; ++id) scene->add(id, record.data());
  EXPECT_EQ(rows_of({.a = scene, .h = 1}).size(), 40u * 39 / 2);
}

TEST(MissingParts, AreErrors) {
  EXPECT_EQ(message_of([] { Join({}, never); }), "a join has no scene a; set JoinQuestion::a");
  EXPECT_EQ(message_of([] { Window({}, never); }),
            "a window query has no objects; set WindowQuestion::objects");
  EXPECT_EQ(message_of([] { nearest({}, never); }),
            "a nearest query has no objects; set NearestQuestion::objects");
  EXPECT_EQ(message_of([] { Sweep({}, never); }), "a sweep has no tree; set SweepQuestion::tree");
  EXPECT_NE(message_of([] { Positions(nullptr, 0); }), "no error");
  EXPECT_NE(message_of([] { Tracks(nullptr, {0, 1, 1}, never); }), "no error");
  MemoryWatch watch;
  EXPECT_EQ(message_of([&] { PairUpdate({}, {}, watch, {never}); }),
            "a watch has no table a; set JoinedTables::a");
}

TEST(MissingParts, OfAvoidAreErrors) {
  AvoidQuestion question;
  const auto message = [&] { return message_of([&] { avoid(question, never); }); };
  EXPECT_EQ(message(), "predictive_avoid has no object; set AvoidQuestion::own_scene");
  question.own_scene = scene_of(discs, {1}, {0, 0, 1, 0, 1});
  question.h = 10;
  const char* of_record = "ships: a record has 5 numbers, not ";
  EXPECT_NE(message().find(of_record), std::string::npos);
  question.record = {0, 0, 1, 0};
  EXPECT_NE(message().find(of_record), std::string::npos);
  question.record = {0, 0, 1, 0, 1, 0};
  EXPECT_NE(message().find(of_record), std::string::npos);
  question.record = {0, 0, 1, nan, 1};
  EXPECT_EQ(message(), "ships: row 1: vy is nan; write a finite number");
  question.record = {0, 0, 1, 0, 1};
  EXPECT_EQ(message(), "predictive_avoid has no objects to avoid; set AvoidQuestion::others");
  question.others = {"ships", two_discs(), nullptr};
  question.also.emplace();
  EXPECT_EQ(message(), "a second table has no objects; set AvoidQuestion::also");
  question.also.reset();
  EXPECT_EQ(message(), "no error");
}

struct Once final : Interrupt {
  void check() override {
    if (armed) armed = false, throw Interrupted();
  }
  bool armed = false;
};

/// The second call throws, and so do all later ones.
template <class Rows>
void expect_broken(Rows& rows, Once& once, const char* name) {
  once.armed = true;
  EXPECT_THROW(rows.next(), Interrupted) << name;
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(message_of([&] { rows.next(); }),
              std::string(name) + " failed before: its rows would be incomplete; start it again");
}

TEST(RowsAfterAnInterrupt, AreRefused) {
  const RandomScene random = random_scene({.layout = discs, .count = 600, .seed = 3});
  const auto scene = scene_of(random);
  MemoryTable table("ships", random.layout);
  const auto size = static_cast<std::size_t>(record_offsets(random.layout).size);
  for (std::size_t i = 0; i < random.ids.size(); ++i)
    table.put(random.ids[i], std::span(random.records).subspan(i * size, size));
  Once once;
  for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid}) {
    Join join({.a = scene, .now = random.now, .h = random.h, .within = 1, .method = method}, once);
    expect_broken(join, once, "the join");
  }
  for (const bool by_tree : {false, true}) {
    const SearchTarget objects = by_tree ? trees_of(table) : SearchTarget{"ships", scene, nullptr};
    Window window({.objects = objects, .now = random.now, .h = random.h}, once);
    expect_broken(window, once, "the window query");
  }
  Sweep sweep({.tree = table.tree(), .now = random.now, .h = random.h}, once);
  expect_broken(sweep, once, "the sweep");
  Tracks tracks(scene, {0, 10, 1}, once);
  expect_broken(tracks, once, "the track");
}

}  // namespace
}  // namespace foresee::testing
