#include "query/window/object_candidates.h"

#include <algorithm>
#include <numeric>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/window_walk.h"

namespace foresee {
namespace {

constexpr std::uint32_t batch_size = 256;

class AllOfScene final : public ObjectCandidates {
 public:
  AllOfScene(std::shared_ptr<const Scene> scene, Interrupt& interrupt)
      : scene_(std::move(scene)), bodies_(scene_->bodies()), interrupt_(interrupt) {}

  const Bodies& bodies() const override { return bodies_; }
  std::int64_t id(std::uint32_t row) const override { return scene_->ids[row]; }

  bool next(CandidateBatch& batch) override {
    interrupt_.check();
    batch.clear();
    const auto count = static_cast<std::uint32_t>(scene_->size());
    batch.doubtful.resize(std::min(batch_size, count - next_));
    std::iota(batch.doubtful.begin(), batch.doubtful.end(), next_);
    next_ += static_cast<std::uint32_t>(batch.doubtful.size());
    return !batch.empty();
  }

 private:
  std::shared_ptr<const Scene> scene_;
  Bodies bodies_;
  Interrupt& interrupt_;
  std::uint32_t next_ = 0;
};

template <int D>
Vec<D> vector_of(const std::array<double, 3>& values) {
  return Eigen::Map<const Vec<D>>(values.data());
}

/// Leaf by leaf; the rows of a batch are decoded into one buffer.
template <int D>
class WindowOfTree final : public ObjectCandidates {
 public:
  WindowOfTree(std::shared_ptr<NodeSource> tree, const WindowFaces& faces, bool is_zone,
               const Horizon& horizon, Interrupt& interrupt)
      : tree_(std::move(tree)),
        interrupt_(interrupt),
        is_zone_(is_zone),
        walk_(*tree_,
              moving_window<D>(vector_of<D>(faces.lower), vector_of<D>(faces.upper),
                               vector_of<D>(faces.velocity), horizon),
              horizon, Vec<D>::Zero(), interrupt),
        reader_(tree_->layout()),
        lower_(vector_of<D>(faces.lower)),
        upper_(vector_of<D>(faces.upper)),
        now_(horizon.now) {
    const Layout& layout = tree_->layout();
    rows_.resize(batch_size * static_cast<std::size_t>(row_offsets(layout).size));
    ids_.resize(batch_size);
    bodies_ = Bodies(layout, rows_.data(), batch_size);
    if (tree_->forms()) forms_.lend(bodies_);
  }

  const Bodies& bodies() const override { return bodies_; }
  std::int64_t id(std::uint32_t row) const override { return ids_[row]; }

  bool next(CandidateBatch& batch) override {
    const FloatEnvironment environment;
    batch.clear();
    std::uint32_t row = 0;
    for (; row < batch_size; ++row) {
      if (slot_ == hits_.slots.size()) {
        slot_ = 0;
        if (!walk_.next(hits_)) break;
      }
      const std::uint32_t slot = hits_.slots[slot_++];
      const double* record = reader_.record(*hits_.leaf, slot);
      ids_[row] = hits_.leaf->keys[slot];
      row_from_record(bodies_.layout, record, rows_.data() + row * static_cast<std::size_t>(bodies_.at.size));
      (is_inside(record) ? batch.inside : batch.doubtful).push_back(row);
    }
    if (FormSource* const source = tree_->forms()) {
      bodies_.count = row;
      forms_.assign(bodies_, *source, interrupt_);
    }
    return !batch.empty();
  }

 private:
  /// Where its centre is within the faces, any shape touches the window; of an outline or a mesh, which may
  /// lie beside its centre, the box must be. False where that is not certain.
  [[gnu::flatten]] bool is_inside(const double* record) const {
    const Motion<D> motion = reader_.motion(record);
    if (is_zone_ || now_ < motion.t || motion.until < now_) return false;
    const Extents<D> extents =
        is_stored_apart(bodies_.layout.shape) ? reader_.extents(record) : Extents<D>::none();
    const Bounds<D> all = bounds_at<D>(motion, extents, now_);
    return (lower_ <= all.x_lower && all.x_upper <= upper_).all();
  }

  std::shared_ptr<NodeSource> tree_;
  Interrupt& interrupt_;
  bool is_zone_;
  WindowWalk<D> walk_;
  LeafHits hits_;
  std::size_t slot_ = 0;
  LeafReader<D> reader_;
  Vec<D> lower_, upper_;  ///< the faces at `now`
  double now_;
  std::vector<double> rows_;
  std::vector<std::int64_t> ids_;
  Bodies bodies_;
  RowForms forms_;  ///< of the rows of this batch, where the layout has any
};

}  // namespace

std::unique_ptr<ObjectCandidates> window_candidates(const Searched& objects, const WindowFaces& faces,
                                                    bool is_zone, const Horizon& horizon,
                                                    Interrupt& interrupt) {
  const FloatEnvironment environment;
  if (objects.scene) return std::make_unique<AllOfScene>(objects.scene, interrupt);
  return with_axes(objects.layout().axes, [&]<int D>(Axes<D>) -> std::unique_ptr<ObjectCandidates> {
    return std::make_unique<WindowOfTree<D>>(objects.tree, faces, is_zone, horizon, interrupt);
  });
}

}  // namespace foresee
