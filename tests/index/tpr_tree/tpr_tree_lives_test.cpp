// Objects that exist for a limited time: all answers and invariants hold at any life, and objects without an end
// are stored as in a table without `until`.
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "tests/index/tpr_tree/schedule.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::legs;
using testing::Random;
using testing::random_scene;
using testing::RandomScene;
using testing::TreeModel;

/// All nodes beneath `number`, in an order that does not depend on their numbers; without `until`.
void append_nodes(MemoryPages& pages, NodeNumber number, std::vector<double>& numbers) {
  const auto node = pages.read(number);
  numbers.insert(numbers.end(), {static_cast<double>(number), static_cast<double>(node->level), node->epoch});
  for (const std::int64_t key : node->keys) numbers.push_back(static_cast<double>(key));
  const std::size_t stride = node->values.size() / std::max<std::size_t>(1, node->size());
  for (std::size_t i = 0; i < node->values.size(); ++i)
    if (!node->is_leaf() || !pages.layout().has_until || i % stride + 1 != stride)
      numbers.push_back(node->values[i]);
  if (!node->is_leaf())
    for (const std::int64_t child : node->keys) append_nodes(pages, child, numbers);
}

TEST(TprTreeLives, WithoutAnEndTheNodesAreThoseOfATableWithoutUntil) {
  for (const Law law : {Law::rest, Law::uniform, Law::accelerated}) {
    Layout plain{.axes = 2, .law = law, .shape = Shape::box, .has_t = true}, timed = plain;
    timed.has_until = true;
    const RandomScene scene = random_scene({.layout = plain, .count = 2000, .seed = 4});
    const std::size_t size = scene.records.size() / scene.size();
    TreeModel one(plain, 60, 12), other(timed, 60, 12);
    const auto with_end = [&](std::vector<double> record) { return record.push_back(no_end), record; };
    const auto record = [&](std::size_t i) {
      const auto from = scene.records.begin() + static_cast<std::ptrdiff_t>(i * size);
      return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(size));
    };
    const auto expect_equal = [&](const char* after) {
      std::vector<double> nodes, others;
      append_nodes(one.pages, one.pages.find_root(), nodes);
      append_nodes(other.pages, other.pages.find_root(), others);
      ASSERT_EQ(nodes.size(), others.size()) << after;
      EXPECT_EQ(std::memcmp(nodes.data(), others.data(), nodes.size() * sizeof(double)), 0) << after;
    };
    std::vector<std::int64_t> ids(scene.ids.begin(), scene.ids.begin() + 1000);
    std::vector<double> records, ended;
    for (std::size_t i = 0; i < 1000; ++i) {
      const std::vector<double> plain_record = record(i), timed_record = with_end(plain_record);
      records.insert(records.end(), plain_record.begin(), plain_record.end());
      ended.insert(ended.end(), timed_record.begin(), timed_record.end());
    }
    one.tree->bulk_load(ids, records, one.never), other.tree->bulk_load(ids, ended, other.never);
    expect_equal("a load");
    for (std::size_t i = 1000; i < 1500; ++i)
      one.tree->insert(scene.ids[i], record(i)), other.tree->insert(scene.ids[i], with_end(record(i)));
    for (std::size_t i = 0; i < 1500; i += 2) {
      const std::size_t from = (7 * i + 3) % 2000;
      one.tree->update(scene.ids[i], record(from)), other.tree->update(scene.ids[i], with_end(record(from)));
    }
    expect_equal("changes one by one");
    one.tree->merge(ids, records, one.never), other.tree->merge(ids, ended, other.never);
    expect_equal("a merge");
  }
}

/// A time that is extreme, or one of a schedule.
double some_time(Random& random) {
  const double extreme[] = {0, 5e-324, -1e-300, 1e15, -1e154, 1e300, -1.7e308, 1.7e308};
  return random.below(6) == 0 ? extreme[random.below(8)] : random.in(-100, 100);
}

std::vector<double> some_life(Random& random) {
  const double t = some_time(random), extreme_place = random.below(8) == 0 ? some_time(random) : 0;
  const double ends[] = {no_end,
                         t,
                         std::nextafter(t, no_end),
                         std::max(t, some_time(random)),
                         t + random.unit(),
                         t + 10 * random.unit()};
  return {t,
          random.in(-50, 50) + extreme_place,
          random.in(-50, 50),
          random.in(-2, 2),
          random.below(4) == 0 ? 0 : random.in(-2, 2),
          random.in(0, 2),
          ends[random.below(6)]};
}

/// The walk finds just the objects whose own boxes meet the window during their lives.
void expect_windows(TreeModel& model, Random& random) {
  const Vec<2> still = Vec<2>::zero();
  for (int i = 0; i < 8; ++i) {
    const Horizon horizon{some_time(random), random.below(2) ? 0 : random.in(0, 200)};
    const Vec<2> lower(random.in(-60, 60), random.in(-60, 60));
    const MovingBox<2> window = moving_window<2>(lower, lower + 25, still, horizon);
    std::set<std::int64_t> found, expected;
    WindowWalk<2> walk(model.pages, window, horizon, still, model.never);
    for (LeafHits hits; walk.next(hits);)
      for (const std::uint32_t slot : hits.slots) EXPECT_TRUE(found.insert(hits.leaf->keys[slot]).second);
    const LeafReader<2> reader(model.pages.layout());
    for (const auto& [id, record] : model.objects) {
      const MovingBox<2> box = Mover<2>(reader, record.data()).box(horizon, still);
      SharedInterval span = shared_span(box, window);
      if (!span.is_empty() && narrow_to_contact(box, window, span)) expected.insert(id);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(TprTreeLives, RandomLivesAreFoundHoweverTheyWereWritten) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    TreeModel model(legs, seed % 3 == 0 ? 0 : 60, 6 + seed % 5);
    for (int round = 0; round < 3; ++round) {
      std::vector<std::int64_t> ids;
      std::vector<double> records;
      std::map<std::int64_t, std::vector<double>> batch;
      for (int i = 0; i < 150; ++i) batch[static_cast<std::int64_t>(random.below(600))] = some_life(random);
      for (const auto& [id, record] : batch) {
        ids.push_back(id), records.insert(records.end(), record.begin(), record.end());
        model.objects[id] = record;
      }
      model.tree->merge(ids, records, model.never);
      for (int i = 0; i < 150; ++i) {
        const auto id = static_cast<std::int64_t>(random.below(600));
        if (!model.objects.contains(id))
          model.insert(id, some_life(random));
        else
          random.below(4) == 0 ? model.erase(id) : model.update(id, some_life(random));
      }
      model.expect_sound();
      expect_windows(model, random);
      model.tree->rebuild(model.never);
      model.expect_sound();
      expect_windows(model, random);
    }
  }
}

}  // namespace
}  // namespace foresee
