#include "boost_tree.h"
#include "compare/contestant.h"
#include "exact_answer.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/memory_pages.h"
#include "index/paper_grid/paper_candidates.h"
#include "index/tpr_tree/search/tree_join.h"
#include "index/tpr_tree/tpr_tree.h"

namespace foresee::bench {
namespace {

NeverInterrupt never;
const Vec<2> no_margin = Vec<2>::zero();
constexpr double step = 0.1;  // of time stepping

template <class Kind>
std::unique_ptr<Contestant> make(Workload& objects) {
  return std::make_unique<Kind>(objects);
}

std::unique_ptr<Contact> contact_within(const Bodies& bodies, double h) {
  return make_contact(bodies, bodies, {.horizon = {0, h}}, "objects", "objects");
}

/// The production grid, rebuilt for each join.
class GridContestant final : public Contestant {
 public:
  using Contestant::Contestant;
  Answer join() override {
    const Bodies bodies = objects_.bodies();
    const auto grid = make_gpcd_grid<2>({bodies, {0, objects_.h}, no_margin}, nullptr, never, space_);
    return exact_answer(*grid, *contact_within(bodies, objects_.h));
  }

 private:
  std::shared_ptr<GridSpace> space_ = std::make_shared<GridSpace>();
};

/// The reference implementation of the paper.
class GpcdContestant final : public Contestant {
 public:
  using Contestant::Contestant;
  Answer join() override {
    const Bodies bodies = objects_.bodies();
    const auto candidates =
        make_paper_candidates<2>(bodies, bodies, false, {0, objects_.h}, no_margin, never);
    return exact_answer(*candidates, *contact_within(bodies, objects_.h));
  }
};

/// foresee's TPR-tree, loaded at once and joined with itself.
class TreeContestant final : public Contestant {
 public:
  explicit TreeContestant(Workload& objects)
      : Contestant(objects), pages_(objects.layout), tree_(make_tpr_tree(pages_, objects.h)) {}

  void build() override {
    std::vector<std::int64_t> ids(objects_.count);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int64_t>(i);
    tree_->bulk_load(ids, objects_.rows, never);
  }
  void report(std::uint32_t row, const Report& report) override {
    write(row, report);
    tree_->update(row, {row_of(row), static_cast<std::size_t>(objects_.bodies().at.size)});
  }
  Answer join() override {
    const TreeScene scene = read_tree(pages_, never);
    const auto candidates =
        make_tree_join<2>(scene.bodies(), scene.levels, {0, objects_.h}, no_margin, never);
    return exact_answer(*candidates, *contact_within(scene.bodies(), objects_.h), nullptr,
                        [&](std::uint32_t row) { return static_cast<std::uint32_t>(scene.ids[row]); });
  }

 private:
  MemoryPages pages_;
  std::unique_ptr<TprTree> tree_;
};

class BoostContestant final : public Contestant {
 public:
  using Contestant::Contestant;
  void build() override { tree_ = std::make_unique<BoostTree<2>>(objects_); }
  void report(std::uint32_t row, const Report& report) override {
    write(row, report);
    tree_->move(row, swept_box<2>(objects_.bodies(), row, {0, objects_.h}, no_margin));
  }
  Answer join() override {
    PlainEmitter emitter(objects_);
    tree_->join(emitter);
    return emitter.finish();
  }

 private:
  std::unique_ptr<BoostTree<2>> tree_;
};

class PairsContestant final : public Contestant {
 public:
  using Contestant::Contestant;
  Answer join() override { return by_brute_force(objects_); }
};

class SteppingContestant final : public Contestant {
 public:
  using Contestant::Contestant;
  Answer join() override { return by_stepping(objects_, step); }
};

}  // namespace

std::vector<ContestantKind> contestants_in_memory() {
  return {
      {.name = "foresee grid", .keeps_index = false, .make = make<GridContestant>},
      {.name = "GPCD", .keeps_index = false, .make = make<GpcdContestant>},
      {.name = "foresee TPR-tree", .keeps_index = true, .make = make<TreeContestant>},
      {.name = "Boost R-tree", .keeps_index = true, .make = make<BoostContestant>},
#ifdef FORESEE_SPATIALINDEX
      spatialindex_contestant(),
#endif
      {.name = "time stepping",
       .keeps_index = false,
       .misses_pairs = true,
       .make = make<SteppingContestant>,
       .accepts = [](const Workload& objects) { return objects.layout.shape == Shape::box; }},
      {.name = "brute force", .keeps_index = false, .make = make<PairsContestant>},
  };
}

}  // namespace foresee::bench
