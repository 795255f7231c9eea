// Which objects touch a moving window, and when? predictive_window as a library call.
//
//   Window window({.objects = {"ships", scene, nullptr}, .now = 600, .h = 300,
//                  .faces = {.lower = {0, 0, -infinity}, .upper = {100, 100, infinity}}}, interrupt);
//   for (auto rows = window.next(); !rows.empty(); rows = window.next())
//     for (const WindowRow& row : rows) use(row.id, row.contact.t);
//
// Guarantee: every object whose shape touches the closed window at a moment of [now, now + h] at which it
// exists comes exactly once, whatever is searched; decision and times are exact (contact/window_contact.h).
// Rows come in no particular order. Times are computed only where `wants` asks for them. Cost: a tree reads
// the nodes that can meet the window; a scene is looked at whole. Memory: some hundred rows.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "contact/window_contact.h"
#include "query/search_target.h"

namespace foresee {

// Stage one of a window: which objects are worth a look, from a scene or from a tree, and which of them need
// none.

/// Row numbers, some hundreds at most.
struct CandidateBatch {
  std::vector<std::uint32_t> doubtful;  ///< contact decides
  std::vector<std::uint32_t> inside;    ///< exist at `now` and touch the window then

  bool empty() const { return doubtful.empty() && inside.empty(); }
  void clear() { doubtful.clear(), inside.clear(); }
};

class ObjectCandidates {
 public:
  virtual ~ObjectCandidates() = default;

  /// Where the rows of a batch are found: the same place for all batches.
  virtual const Bodies& bodies() const = 0;

  /// Replaces `batch` by the next one; false once there are no candidates left.
  virtual bool next(CandidateBatch& batch) = 0;

  /// Of a row of the latest batch.
  virtual std::int64_t id(std::uint32_t row) const = 0;
};

/// Every object that can touch the window during the horizon, once, and others. `is_zone`: what is between
/// the faces need not be in the window, which is a zone that they enclose.
std::unique_ptr<ObjectCandidates> window_candidates(const SearchTarget& objects, const WindowFaces& faces,
                                                    bool is_zone, const Horizon& horizon,
                                                    Interrupt& interrupt);

struct WindowWants {
  bool starts = true;  ///< t, dt
  bool ends = true;    ///< t_end, dt_end
};

struct WindowQuestion {
  SearchTarget objects;
  double now = 0;
  double h = 0;
  WindowFaces faces = {};  ///< infinite: no bound
  std::shared_ptr<const SharedOutline> zone =
      nullptr;  ///< in place of the faces across x and y; moves with them
  WindowWants wants = {};
};

struct WindowRow {
  std::int64_t id;
  ContactTimes contact;
};

class Window {
 public:
  /// Throws Error for a wrong question: h negative or not finite; now or a velocity not finite; a lower bound
  /// above its upper one; a bound or velocity on an axis that the objects do not have; a zone on one axis, or
  /// together with a bound in x or y. `interrupt` must outlive the window.
  Window(WindowQuestion question, Interrupt& interrupt);

  /// The next rows, some hundreds at most; empty once there are none left. Valid until the next call.
  std::span<const WindowRow> next();

 private:
  void take_inside();

  WindowQuestion question_;
  Interrupt& interrupt_;
  MovingWindow window_;
  std::unique_ptr<ObjectCandidates> candidates_;
  std::unique_ptr<Contact> contact_;
  CandidateBatch batch_;
  std::vector<Pair> pairs_, hits_;
  std::vector<ContactTimes> times_;
  std::vector<WindowRow> rows_;
};

}  // namespace foresee
