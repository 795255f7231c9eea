#include "query/join/pair_kinds.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "base/interrupt_steps.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/tile/tile.h"

namespace foresee {
namespace {

std::shared_ptr<SceneKinds> kinds_of(const Scene& scene) {
  if (scene.kinds && scene.kinds->of.size() == scene.size()) return scene.kinds;  // else rows were added
  auto kinds = std::make_shared<SceneKinds>();
  const Bodies bodies = scene.bodies();
  kinds->of.reserve(bodies.count);
  for (std::size_t i = 0; i < bodies.count; ++i) {
    kinds->of.push_back(foresee::kinds_of(bodies.row(i), bodies.at));
    kinds->all.include(kinds->of.back());
    kinds->common.category &= kinds->of.back().category, kinds->common.mask &= kinds->of.back().mask;
  }
  return scene.kinds = std::move(kinds);
}

/// The objects of a scene whose kinds `meets` accepts. Leaves of the tree without such an object stay, empty.
template <class Meets>
std::shared_ptr<const Scene> some_of(const Scene& scene, const std::vector<Kinds>& kinds, std::size_t count,
                                     Meets meets, Interrupt& interrupt) {
  const auto row_size = static_cast<std::size_t>(row_offsets(scene.layout).size);
  auto some = std::make_shared<Scene>();
  some->name = scene.name;
  some->layout = scene.layout;
  some->levels = scene.levels;
  some->legs_during = scene.legs_during;
  some->ids.reserve(count);
  some->rows.reserve(count * row_size);
  const auto of_leaves = some->levels ? std::span(some->levels->starts.at(0)) : std::span<std::uint32_t>();
  auto start = of_leaves.begin();
  Steps steps(interrupt);
  for (std::size_t i = 0; i <= scene.size(); ++i) {
    steps();
    for (; start != of_leaves.end() && *start == i; ++start)
      *start = static_cast<std::uint32_t>(some->size());
    if (i == scene.size() || !meets(kinds[i])) continue;
    some->ids.push_back(scene.ids[i]);
    const double* const row = scene.rows.data() + i * row_size;
    some->rows.insert(some->rows.end(), row, row + row_size);
  }
  some->find_movers();
  return some;
}

/// The objects of a scene that may meet one of `partner_kinds`; the scene itself if all may.
std::shared_ptr<const Scene> active(const std::shared_ptr<const Scene>& scene, Kinds partner_kinds,
                                    Interrupt& interrupt) {
  if (scene->forms) return scene;
  const std::shared_ptr<SceneKinds> kinds = kinds_of(*scene);
  if (kinds->active && kinds->partner_kinds == partner_kinds) return kinds->active;
  const auto meets = [&](Kinds one) { return may_meet(one, partner_kinds); };
  const auto count = static_cast<std::size_t>(std::count_if(kinds->of.begin(), kinds->of.end(), meets));
  if (count == scene->size()) return scene;
  kinds->active = some_of(*scene, kinds->of, count, meets, interrupt);
  kinds->partner_kinds = partner_kinds;
  return kinds->active;
}

/// Whether the kinds of a pair may meet.
class MayMeet {
 public:
  explicit MayMeet(std::shared_ptr<const PairKinds> kinds)
      : kinds_(std::move(kinds)), a_(kinds_->a->of.data()), b_(kinds_->b->of.data()) {}

  bool operator()(const Pair& pair) const { return may_meet(a_[pair.a], b_[pair.b]); }

 private:
  std::shared_ptr<const PairKinds> kinds_;
  const Kinds *a_, *b_;
};

/// Kinds, and how many objects have them.
struct Group {
  Kinds kinds;
  std::uint64_t count;
};

std::vector<Group> groups_of(const SceneKinds& scene, const std::vector<TileMarks>* marks,
                             Interrupt& interrupt) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> counts;
  Steps steps(interrupt);
  for (std::size_t i = 0; i < scene.of.size(); ++i) {
    steps();
    if (!marks || !((*marks)[i] & Tile::unneeded)) ++counts[{scene.of[i].category, scene.of[i].mask}];
  }
  std::vector<Group> groups;
  for (const auto& [kinds, count] : counts) groups.push_back({{kinds.first, kinds.second}, count});
  return groups;
}

}  // namespace

std::shared_ptr<const Scene> scene_without_inert(TableSource& table, TableSource& others, SceneNeeds needs) {
  if (has_kinds(table.layout()) && !table.layout().has_plan)
    needs.partner_kinds = kinds_of_all(*others.tree());
  return table.all(needs);
}

bool has_kinds(const JoinQuestion& question) {
  return has_kinds(question.a->layout) || (question.b && has_kinds(question.b->layout));
}

JoinQuestion without_inert(JoinQuestion question, Interrupt& interrupt) {
  if (!has_kinds(question)) return question;
  const bool itself = question.b == question.a;
  const auto a = kinds_of(*question.a), b = question.b ? kinds_of(*question.b) : a;
  question.a = active(question.a, b->all, interrupt);
  if (itself)
    question.b = question.a;
  else if (question.b)
    question.b = active(question.b, a->all, interrupt);
  return question;
}

JoinQuestion with_kinds(JoinQuestion question) {
  if (!has_kinds(question)) return question;
  const auto a = kinds_of(*question.a), b = question.b ? kinds_of(*question.b) : a;
  question.kinds = std::make_shared<PairKinds>(PairKinds{a, b});
  return question;
}

std::unique_ptr<Candidates> meeting_candidates(std::unique_ptr<Candidates> all,
                                               std::shared_ptr<const PairKinds> kinds) {
  return std::make_unique<FilteredCandidates<MayMeet>>(std::move(all), MayMeet(std::move(kinds)));
}

std::uint64_t count_meeting(const JoinQuestion& question, Interrupt& interrupt) {
  const Ownership* const own = question.own.get();
  const std::vector<TileMarks>* const marks_a = own ? &own->a : nullptr;
  const std::vector<TileMarks>* const marks_b = own && !own->b.empty() ? &own->b : marks_a;
  const std::vector<Group> a = groups_of(*question.kinds->a, marks_a, interrupt);
  const std::vector<Group> b = groups_of(*question.kinds->b, marks_b, interrupt);
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    interrupt.check();
    if (question.b) {
      for (const Group& other : b) pairs += may_meet(a[i].kinds, other.kinds) ? a[i].count * other.count : 0;
      continue;
    }
    if (may_meet(a[i].kinds, a[i].kinds)) pairs += a[i].count * (a[i].count - 1) / 2;
    for (std::size_t j = i + 1; j < a.size(); ++j)
      pairs += may_meet(a[i].kinds, a[j].kinds) ? a[i].count * a[j].count : 0;
  }
  return pairs;
}

}  // namespace foresee
