// Predictive window query: the objects that touch a moving window, and when. predictive_window as a library
// call.
//
//   Window window({.objects = {"ships", scene, nullptr}, .now = 600, .h = 300,
//                  .faces = {.lower = {0, 0, -infinity}, .upper = {100, 100, infinity}}}, interrupt);
//   for (auto rows = window.next(); !rows.empty(); rows = window.next())
//     for (const WindowRow& row : rows) use(row.id, row.contact.t);
//
// Guarantee: every object whose shape touches the closed window during [now, now + h] while it exists comes
// exactly once; with all_contacts once per contact. Scene and tree give the same rows. Decision and times are exact
// (contact/window_contact.h). An object with a plan is the union of its legs (legs/mover_contacts.h).
// Rows come in no particular order. Times are computed only where `wants` requests them. Cost: a tree reads
// the nodes that can intersect the window; a scene is scanned. Memory: some hundred rows, and the legs of the chunks
// that the window may meet, which the constructor reads.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "contact/window_contact.h"
#include "query/scene.h"
#include "shape/kinds.h"

namespace foresee {

// Candidate stage of a window query: objects of a scene or of a tree, divided into those that contact must
// decide and those that certainly touch the window.

/// Row numbers, a few hundred at most.
struct CandidateBatch {
  std::vector<std::uint32_t> doubtful;  ///< decided by the contact test
  std::vector<std::uint32_t> inside;    ///< exist at `now` and touch the window then

  bool empty() const { return doubtful.empty() && inside.empty(); }
  void clear() {
    doubtful.clear();
    inside.clear();
  }
};

class ObjectCandidates {
 public:
  virtual ~ObjectCandidates() = default;

  /// The rows of the latest batch; the same object for all batches.
  virtual const Bodies& bodies() const = 0;

  /// Replaces `batch` by the next one; false once there are no candidates left.
  virtual bool next(CandidateBatch& batch) = 0;

  /// The id of a row of the latest batch.
  virtual std::int64_t id(std::uint32_t row) const = 0;
};

/// Every object that can touch the window during the horizon, once, and others. `is_zone`: the window is a
/// zone that the faces enclose, so a point between the faces need not be in the window. `test`: only objects that
/// it accepts.
std::unique_ptr<ObjectCandidates> window_candidates(const SearchTarget& objects, const WindowFaces& faces,
                                                    bool is_zone, const Horizon& horizon,
                                                    Interrupt& interrupt,
                                                    const std::optional<KindTest>& test = {});

struct WindowWants {
  bool starts = true;  ///< t, dt
  bool ends = true;    ///< t_end, dt_end
};

struct WindowQuestion {
  SearchTarget objects = {};  ///< must be set
  double now = 0;
  double h = 0;
  WindowFaces faces = {};                               ///< infinite: no bound
  std::shared_ptr<const SharedOutline> zone = nullptr;  ///< replaces the faces in x and y; moves with them
  std::optional<std::uint32_t> mask = {};               ///< only objects whose category has a bit of it
  WindowWants wants = {};
  bool all_contacts =
      false;  ///< a row for each contact, not for outlines, meshes and zones; else for the first
};

struct WindowRow {
  std::int64_t id;
  ContactTimes contact;
};

class MoverWindow;

class Window {
 public:
  /// Throws Error if h is negative or not finite, if now or a velocity is not finite, or if a lower bound is
  /// above its upper one. Also for a bound or velocity on an axis that the objects do not have, and for a
  /// zone on one axis or together with a bound in x or y. Also without objects, or if a scene's sizes do not fit its
  /// layout. `interrupt` must outlive the window.
  Window(WindowQuestion question, Interrupt& interrupt);
  ~Window();

  /// The next rows, a few hundred at most; empty at the end. Valid until the next call. If it throws, as `interrupt`
  /// may, each later call throws Error.
  std::span<const WindowRow> next();

 private:
  void make_contact();
  void take_inside();
  void find_plans(const WindowFaces& faces, const std::optional<KindTest>& test);
  bool decide_batch();

  WindowQuestion question_;
  Interrupt& interrupt_;
  MovingWindow window_;
  std::unique_ptr<ObjectCandidates> candidates_;  ///< null: all objects are in movers_
  /// Where objects have plans: null until one without a plan is found.
  std::unique_ptr<Contact> contact_;
  std::unique_ptr<MoverWindow> movers_;  ///< of a layout with plans: those with plans, of a scene all
  CandidateBatch batch_;
  std::vector<Pair> pairs_, hits_;
  std::vector<ContactTimes> times_;
  std::vector<WindowRow> rows_;
  UnbrokenCalls unbroken_;
};

}  // namespace foresee
