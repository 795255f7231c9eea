#include "base/error.h"
#include "compare/contestant.h"
#include "core_emitter.h"
#include "spatialindex_tree.h"

namespace foresee::bench {
namespace {

/// Tools::Exception as Error, with the same text.
template <class Work>
void translated(Work&& work) {
  try {
    work();
  } catch (Tools::Exception& error) {
    throw Error(error.what());
  }
}

class SpatialindexContestant final : public Contestant {
 public:
  /// A query must end before the tree's horizon.
  explicit SpatialindexContestant(Workload& objects)
      : Contestant(objects), tree_(objects, 1.001 * objects.h) {}

  void build() override {
    translated([&] { tree_.insert_all(); });
  }
  Answer join() override {
    PlainEmitter emitter(objects_);
    translated([&] { tree_.join([&](std::uint32_t a, std::uint32_t b) { emitter.take(a, b); }); });
    return emitter.finish();
  }

 private:
  SpatialindexTree tree_;
};

}  // namespace

ContestantKind spatialindex_contestant() {
  return {.name = "libspatialindex TPR-tree",
          .keeps_index = true,
          .takes_reports = false,
          .make = [](Workload& objects) -> std::unique_ptr<Contestant> {
            return std::make_unique<SpatialindexContestant>(objects);
          },
          .accepts = [](const Workload& objects) { return objects.layout.law == Law::uniform; }};
}

}  // namespace foresee::bench
