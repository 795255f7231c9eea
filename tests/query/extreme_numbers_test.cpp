// Numbers from the whole range of doubles: every index finds all that a scan of all objects finds.
#include "extreme_numbers.h"

#include <gtest/gtest.h>

#include <map>

#include "query/join/join_scenes.h"
#include "query/join/question.h"
#include "query/nearest/nearest.h"
#include "query/search_cases.h"
#include "query/window/window.h"

namespace foresee {
namespace {

using testing::as_scene;
using testing::as_tree;
using testing::extreme_scene;
using testing::ExtremeNumbers;
using testing::numbers_of;
using testing::RandomScene;
using testing::rows_of;
using testing::tree_of;

constexpr std::uint64_t scenes = 1500;

/// The scene as its tree holds it.
std::shared_ptr<const Scene> with_levels(const RandomScene& scene) {
  NeverInterrupt never;
  TreeScene read = read_tree(*tree_of(scene), never);
  auto out = std::make_shared<Scene>();
  *out = {"ships", read.layout, std::move(read.ids), std::move(read.rows), std::move(read.levels)};
  return out;
}

JoinQuestion question_of_tree(const RandomScene& scene) {
  return {.a = with_levels(scene),
          .now = scene.now,
          .h = scene.h,
          .within = scene.within,
          .method = JoinMethod::scan};
}

TEST(ExtremeNumbers, EveryMethodOfAJoinFindsTheSamePairs) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    JoinQuestion question = question_of_tree(extreme_scene(seed));
    const auto all = numbers_of(rows_of(question));
    found += all.size();
    for (JoinMethod method : {JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd}) {
      question.method = method;
      EXPECT_EQ(numbers_of(rows_of(question)), all) << name_of(method) << ", scene " << seed;
    }
  }
  EXPECT_GT(found, scenes);
}

TEST(ExtremeNumbers, AJoinAboutOneIdFindsAllThatMeetIt) {
  NeverInterrupt never;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    const RandomScene scene = extreme_scene(seed);
    const JoinQuestion question = question_of_tree(scene);
    const auto tree = tree_of(scene);
    std::map<std::int64_t, std::vector<std::int64_t>> met;
    for (const JoinRow& row : rows_of(question)) met[row.a].push_back(row.b), met[row.b].push_back(row.a);
    for (std::size_t i = 0; i < scene.size(); ++i) {
      const Bodies body(scene.layout, scene.bodies().row(i), 1);
      const auto one =
          testing::scene_of(scene.layout, {scene.ids[i]}, {body.row(0), body.row(0) + body.at.size});
      const auto near = objects_near(*one, {"ships", nullptr, tree}, scene.horizon(), reach_of(question),
                                     never, [](std::int64_t) { return true; });
      for (const std::int64_t id : met[scene.ids[i]])
        EXPECT_EQ(std::count(near->ids.begin(), near->ids.end(), id), 1) << "scene " << seed;
    }
  }
}

/// By id.
std::map<std::int64_t, ContactTimes> rows_of(const WindowQuestion& question) {
  NeverInterrupt never;
  Window window(question, never);
  std::map<std::int64_t, ContactTimes> all;
  for (auto rows = window.next(); !rows.empty(); rows = window.next())
    for (const WindowRow& row : rows) all[row.id] = row.contact;
  return all;
}

TEST(ExtremeNumbers, AWindowFindsTheSameObjectsInATree) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 3 * scenes; ++seed) {
    const RandomScene scene = extreme_scene(seed / 3 * 2 + 1);
    ExtremeNumbers numbers(seed * 2 + 1);
    WindowQuestion question{as_scene(scene), scene.now, scene.h};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.layout.axes); ++axis) {
      const double one = numbers.length(), other = numbers.one_in(2) ? one : numbers.length();
      question.faces.lower[axis] = std::min(one, other), question.faces.upper[axis] = std::max(one, other);
      question.faces.velocity[axis] = numbers.one_in(2) ? 0 : numbers.speed();
    }
    const auto all = rows_of(question);
    question.objects = as_tree(scene);
    const auto by_tree = rows_of(question);
    found += all.size();
    EXPECT_EQ(by_tree.size(), all.size()) << "query " << seed;
    for (const auto& [id, times] : all) {
      ASSERT_TRUE(by_tree.contains(id)) << "query " << seed;
      EXPECT_EQ(by_tree.at(id).t, times.t);
      EXPECT_EQ(by_tree.at(id).dt_end, times.dt_end);
    }
  }
  EXPECT_GT(found, scenes);
}

TEST(ExtremeNumbers, TheNearestAreTheFirstOfAll) {
  NeverInterrupt never;
  for (std::uint64_t seed = 0; seed < 3 * scenes; ++seed) {
    const RandomScene scene = extreme_scene(seed / 3);
    ExtremeNumbers numbers(seed);
    NearestQuestion question{as_scene(scene), scene.now, scene.h, 1000};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.layout.axes); ++axis) {
      question.point[axis] = numbers.length();
      question.velocity[axis] = numbers.one_in(2) ? 0 : numbers.speed();
    }
    const auto all = nearest(question, never);  // fewer than k: no bound excludes an object
    for (const bool by_tree : {false, true})
      for (const std::size_t k : {1, 2}) {
        question.objects = by_tree ? as_tree(scene) : as_scene(scene);
        question.k = static_cast<std::int64_t>(k);
        const auto some = nearest(question, never);
        ASSERT_EQ(some.size(), std::min(k, all.size()));
        for (std::size_t i = 0; i < some.size(); ++i)
          EXPECT_TRUE(some[i].id == all[i].id && some[i].distance == all[i].distance)
              << "query " << seed << ", k = " << k << (by_tree ? ", tree" : ", scene");
      }
  }
}

}  // namespace
}  // namespace foresee
