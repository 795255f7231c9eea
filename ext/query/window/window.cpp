#include "query/window/window.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/search/window_walk.h"
#include "query/distinct_contacts.h"
#include "query/input_checks.h"
#include "query/legs/leg_scene.h"
#include "query/window/mover_window.h"

namespace foresee {

namespace {

constexpr std::uint32_t batch_size = 256;

class AllOfScene final : public ObjectCandidates {
 public:
  AllOfScene(std::shared_ptr<const Scene> scene, Interrupt& interrupt, const std::optional<KindTest>& test)
      : scene_(std::move(scene)), bodies_(scene_->bodies()), interrupt_(interrupt), test_(test) {}

  const Bodies& bodies() const override { return bodies_; }
  std::int64_t id(std::uint32_t row) const override { return scene_->ids[row]; }

  bool next(CandidateBatch& batch) override {
    interrupt_.check();
    batch.clear();
    const auto count = static_cast<std::uint32_t>(scene_->size());
    batch.doubtful.resize(std::min(batch_size, count - next_));
    std::iota(batch.doubtful.begin(), batch.doubtful.end(), next_);
    next_ += static_cast<std::uint32_t>(batch.doubtful.size());
    const bool more = !batch.empty();
    if (test_) std::erase_if(batch.doubtful, [this](std::uint32_t row) { return !accepts(row); });
    return more;
  }

 private:
  bool accepts(std::uint32_t row) const { return test_->accepts(kinds_of(bodies_.row(row), bodies_.at)); }

  std::shared_ptr<const Scene> scene_;
  Bodies bodies_;
  Interrupt& interrupt_;
  std::optional<KindTest> test_;
  std::uint32_t next_ = 0;
};

/// Reads one leaf after another; the rows of a batch are decoded into one buffer.
template <int D>
class WindowOfTree final : public ObjectCandidates {
 public:
  WindowOfTree(std::shared_ptr<NodeSource> tree, const WindowFaces& faces, bool is_zone,
               const Horizon& horizon, Interrupt& interrupt, const std::optional<KindTest>& test)
      : tree_(std::move(tree)),
        interrupt_(interrupt),
        is_zone_(is_zone),
        walk_(*tree_,
              moving_window<D>(vector_of<D>(faces.lower), vector_of<D>(faces.upper),
                               vector_of<D>(faces.velocity), horizon),
              horizon, Vec<D>::zero(), interrupt, test),
        reader_(tree_->layout()),
        lower_(vector_of<D>(faces.lower)),
        upper_(vector_of<D>(faces.upper)),
        now_(horizon.now) {
    const Layout& layout = tree_->layout();
    rows_.resize(batch_size * static_cast<std::size_t>(row_offsets(layout).size));
    ids_.resize(batch_size);
    bodies_ = Bodies(layout, rows_.data(), batch_size);
    if (tree_->forms()) forms_.attach_to(bodies_);
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
  /// Whether the object is certainly inside the window at `now`. It is if its centre is within the faces; for
  /// an outline or a mesh, which need not contain its centre, the box must be within them.
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
  RowForms forms_;  ///< of the rows of this batch, if the layout has outlines or meshes
};

}  // namespace

std::unique_ptr<ObjectCandidates> window_candidates(const SearchTarget& objects, const WindowFaces& faces,
                                                    bool is_zone, const Horizon& horizon,
                                                    Interrupt& interrupt,
                                                    const std::optional<KindTest>& test) {
  const FloatEnvironment environment;
  if (objects.scene) return std::make_unique<AllOfScene>(objects.scene, interrupt, test);
  return with_axes(objects.layout().axes, [&]<int D>(Axes<D>) -> std::unique_ptr<ObjectCandidates> {
    return std::make_unique<WindowOfTree<D>>(objects.tree, faces, is_zone, horizon, interrupt, test);
  });
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_axis(const WindowFaces& faces, int axis) {
  const auto j = static_cast<std::size_t>(axis);
  const std::string letter(1, "xyz"[axis]);
  require_lower_bound((letter + "0").c_str(), faces.lower[j]);
  require_upper_bound((letter + "1").c_str(), faces.upper[j]);
  require_order((letter + "0").c_str(), faces.lower[j], (letter + "1").c_str(), faces.upper[j]);
  require_finite(("wv" + letter).c_str(), faces.velocity[j]);
}

/// Throws Error for a bound or a velocity on an axis that the objects do not have.
void require_no_axis(const WindowQuestion& question, int axis) {
  const auto j = static_cast<std::size_t>(axis);
  const std::string letter(1, "xyz"[axis]);
  const WindowFaces& faces = question.faces;
  const std::string given = faces.lower[j] != -infinity  ? letter + "0"
                            : faces.upper[j] != infinity ? letter + "1"
                            : faces.velocity[j] != 0     ? "wv" + letter
                                                         : "";
  if (!given.empty()) reject_axis(question.objects, given);
}

void require_only_zone(const WindowQuestion& question) {
  if (question.objects.layout().axes < 2)
    throw Error("zone: " + question.objects.name + " has one axis: write x0 and x1 in place of zone");
  for (const int axis : {0, 1}) {
    const std::string letter(1, "xyz"[axis]);
    if (question.faces.has_lower(axis) || question.faces.has_upper(axis))
      throw Error("zone says where the window is in x and y: leave out " + letter +
                  (question.faces.has_lower(axis) ? "0" : "1") + ", or zone");
  }
}

/// Faces around all that may touch the window: for a zone those of its bounding box.
WindowFaces faces_around(const WindowQuestion& question) {
  WindowFaces faces = question.faces;
  if (!question.zone) return faces;
  const Extents<2> around = question.zone->outline().extents();
  for (const std::size_t j : {0, 1}) faces.lower[j] = around.lower[j], faces.upper[j] = around.upper[j];
  return faces;
}

WindowQuestion checked(WindowQuestion question) {
  require_target(question.objects, "a window query has no objects", "WindowQuestion::objects");
  if (question.objects.scene) require_forms(*question.objects.scene);
  if (question.zone) require_only_zone(question);
  if (question.all_contacts) {
    refuse_all_contacts_of_forms(question.objects.layout());
    if (question.zone) throw Error("contacts = 'all' is not for zones: leave it out");
  }
  require_not_negative("h", question.h);
  require_finite("now", question.now);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis < question.objects.layout().axes)
      require_axis(question.faces, axis);
    else
      require_no_axis(question, axis);
  }
  return question;
}

}  // namespace

Window::Window(WindowQuestion question, Interrupt& interrupt)
    : question_(checked(std::move(question))),
      interrupt_(interrupt),
      window_(question_.faces, question_.objects.layout(), question_.now, question_.zone) {
  const WindowFaces faces = faces_around(question_);
  const auto test = question_.mask ? std::optional(KindTest::of_categories(*question_.mask)) : std::nullopt;
  const Horizon horizon{question_.now, question_.h};
  if (question_.objects.layout().has_plan) find_plans(faces, test);
  if (movers_ && question_.objects.scene) return;
  candidates_ =
      window_candidates(question_.objects, faces, question_.zone != nullptr, horizon, interrupt, test);
  if (!movers_) make_contact();
}

Window::~Window() = default;

void Window::make_contact() {
  contact_ = make_window_contact(window_, candidates_->bodies(), {question_.now, question_.h});
  contact_->set_interrupt(interrupt_);
}

void Window::find_plans(const WindowFaces& faces, const std::optional<KindTest>& test) {
  const FloatEnvironment environment;
  const SearchTarget& objects = question_.objects;
  const Horizon horizon{question_.now, question_.h};
  std::shared_ptr<const Scene> legs = objects.scene;
  if (!legs)
    legs = with_axes(objects.layout().axes, [&]<int D>(Axes<D>) {
      const MovingBox<D> box = moving_window<D>(vector_of<D>(faces.lower), vector_of<D>(faces.upper),
                                                vector_of<D>(faces.velocity), horizon);
      return legs_near<D>(objects, box, horizon, Vec<D>::zero(), interrupt_, test);
    });
  const MoverWants wants{test, question_.wants, question_.all_contacts};
  movers_ = std::make_unique<MoverWindow>(std::move(legs), window_, horizon, wants, interrupt_);
}

std::span<const WindowRow> Window::next() {
  const FloatEnvironment environment;
  return unbroken_.run("the window query", [this]() -> std::span<const WindowRow> {
    rows_.clear();
    while (rows_.empty() && candidates_ && decide_batch()) {
    }
    while (rows_.empty() && movers_ && movers_->next(rows_)) {
    }
    return rows_;
  });
}

bool Window::decide_batch() {
  if (!candidates_->next(batch_)) return false;
  if (!contact_) make_contact();
  interrupt_.check();
  pairs_.clear();
  hits_.clear();
  times_.clear();
  for (const std::uint32_t row : batch_.doubtful) pairs_.push_back({0, row});
  take_inside();
  const WindowWants& wants = question_.wants;
  if (question_.all_contacts) {
    contact_->all_contacts(pairs_, hits_, times_);
    join_equal_contacts(0, hits_, times_);
  } else if (wants.starts || wants.ends) {
    contact_->first_contacts(pairs_, wants.ends ? TimesWanted::both : TimesWanted::starts, hits_, times_);
  } else {
    contact_->decide(pairs_, hits_);
  }
  times_.resize(hits_.size());
  for (std::size_t i = 0; i < hits_.size(); ++i) rows_.push_back({candidates_->id(hits_[i].b), times_[i]});
  return true;
}

/// Adds the objects inside the window at `now`: they touch from then on, and only an end has to be computed.
void Window::take_inside() {
  const double now = question_.now, nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::uint32_t row : batch_.inside)
    if (question_.wants.ends || question_.all_contacts)
      pairs_.push_back({0, row});
    else
      rows_.push_back({candidates_->id(row), {.t = now, .t_end = nan, .dt = 0, .dt_end = nan}});
}

}  // namespace foresee
