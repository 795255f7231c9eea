// Objects that come and go without reports: what has dispersed is packed again, and the tree remains sound.

#include <gtest/gtest.h>

#include "base/repeatable_choice.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::boats;
using testing::leaves_against_packed;
using testing::name_of;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::TreeModel;
using testing::varied_layouts;

constexpr std::size_t always = 1 << 30;  ///< so many changes that nodes are examined
constexpr double side = 400;

/// The ids in the order of leaves.
std::vector<std::int64_t> order_of(TreeModel& model) {
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(model.pages, ids, records, model.never);
  return ids;
}

std::vector<double> boat(Random& random, double t, double x, double y) {
  return {t, x, y, random.in(-3, 3), random.in(-3, 3), 0.5};
}

TEST(DispersedObjects, ArePackedSoundInEveryLayout) {
  std::size_t packed = 0;
  for (const Layout& layout : varied_layouts())
    for (const std::size_t count : {4, 150, 400}) {
      SCOPED_TRACE(name_of(layout) + ", " + std::to_string(count));
      const RandomScene scene = random_scene({.layout = layout, .count = count, .seed = 3});
      TreeModel model(layout, 3);
      model.load(scene);
      Random random(9);
      double clock = 0;
      for (std::uint64_t round = 0; round < 4; ++round) {
        model.churn(scene, static_cast<int>(count), random, clock);
        clock += 20;
        const auto before = order_of(model);
        model.tree->repack_dispersed(always, round);
        packed += order_of(model) != before;
        model.expect_sound();
      }
    }
  EXPECT_GT(packed, 10u);
}

/// Each object lives for 60 seconds; in every batch the oldest ones go. Returns the leaves that windows read after two
/// lives, as a multiple of those of a packed tree.
testing::LeavesInWindows leaves_after_lives(std::size_t batch, bool packs) {
  constexpr std::size_t count = 8000;
  constexpr double life = 60;
  TreeModel model(boats, 10, 40);
  Random random(6);
  std::vector<std::int64_t> ids, gone;
  std::vector<double> records;
  std::int64_t next = 0;
  const auto add = [&](double t) {
    const double y = random.in(0, side), x = random.in(0, side);  // one scene for every compiler
    const auto& record = model.objects[next] = boat(random, t, x, y);
    ids.push_back(next++), records.insert(records.end(), record.begin(), record.end());
  };
  const auto born = [&](std::size_t i) { return life * static_cast<double>(i) / count; };
  for (std::size_t i = 0; i < count; ++i) add(born(i));
  model.tree->bulk_load(ids, records, model.never);
  std::size_t done = count;
  for (; done < 3 * count; done += batch) {
    ids.clear(), records.clear(), gone.clear();
    for (std::size_t i = 0; i < batch; ++i) {
      gone.push_back(model.objects.begin()->first);
      model.objects.erase(gone.back());
      add(born(done + i));
    }
    model.tree->erase_all(gone, always, model.never);
    model.tree->merge(ids, records, model.never);
    if (packs) model.tree->repack_dispersed(2 * batch, hash_of(done));
  }
  model.expect_sound();
  return leaves_against_packed(model, side, born(done));
}

TEST(DispersedObjects, ArePackedWhileObjectsComeAndGo) {
  for (const std::size_t batch : {1, 20, 50}) {
    const auto dispersed = leaves_after_lives(batch, false), packed = leaves_after_lives(batch, true);
    EXPECT_GT(dispersed.read, 10) << batch;
    EXPECT_GT(dispersed.with_hits, 3.3) << batch;
    EXPECT_LT(packed.read, 0.25 * dispersed.read) << batch;
    EXPECT_LT(packed.with_hits, 2.4) << batch;
  }
}

TEST(DispersedObjects, AreNotPackedWhereTheyRest) {
  TreeModel model(boats, 60);
  const RandomScene scene = random_scene({.layout = boats, .count = 500, .seed = 4});
  model.load(scene);
  const auto before = order_of(model);
  for (std::uint64_t draw = 0; draw < 20; ++draw) model.tree->repack_dispersed(always, draw);
  EXPECT_EQ(order_of(model), before);
  TreeModel empty(boats, 60);
  empty.tree->repack_dispersed(always, 1);
  empty.insert(1, {0, 1, 2, 3, 4, 5});
  empty.tree->repack_dispersed(always, 1);
  empty.expect_sound();
}

TEST(DispersedObjects, OfADamagedTreeAreLeftAlone) {
  TreeModel model(boats, 60);
  Random random(7);
  for (std::int64_t id = 0; id < 200; ++id)
    model.insert(id, boat(random, 0, random.in(0, side), random.in(0, side)));
  for (std::int64_t id = 200; id < 240; ++id)
    model.insert(id, boat(random, 500, random.in(0, side), random.in(0, side)));
  NodeNumber number = model.pages.find_root();
  while (model.pages.read(number)->level > 1) number = model.pages.read(number)->keys[0];
  Node& parent = model.pages.modify(number);
  const auto entry = std::vector<double>(parent.values.begin(), parent.values.begin() + entry_size(2));
  parent.keys.push_back(parent.keys[0]);
  parent.values.insert(parent.values.end(), entry.begin(), entry.end());
  const auto before = order_of(model);
  for (std::uint64_t draw = 0; draw < 100; ++draw) model.tree->repack_dispersed(always, draw);
  EXPECT_EQ(order_of(model), before);
}

}  // namespace
}  // namespace foresee
