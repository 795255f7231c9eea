// Window query over the legs of plans: the rows of each mover, from the contacts of its legs with the window.
//
//   MoverWindow movers(legs, window, {.now = 600, .h = 300}, {.wants = wants}, interrupt);
//   while (movers.next(rows)) …
//
// Guarantee: for every object of the scene the first contact of the union of its legs, or each of them, as
// mover_contacts.h defines them. Cost: a binary search per object, and a contact test per leg of the horizon.
#pragma once

#include "query/legs/mover_contacts.h"
#include "query/window/window.h"

namespace foresee {

/// What MoverWindow computes, of a WindowQuestion.
struct MoverWants {
  std::optional<KindTest> test = {};
  WindowWants wants = {};
  bool all_contacts = false;
};

class MoverWindow {
 public:
  /// `scene`: with or without plans. `window` and `interrupt` must outlive this.
  MoverWindow(std::shared_ptr<const Scene> scene, const MovingWindow& window, const Horizon& horizon,
              const MoverWants& wants, Interrupt& interrupt);

  /// Appends the rows of the next objects, a few hundred pairs of legs at once; false at the end.
  bool next(std::vector<WindowRow>& rows);

 private:
  void take_pairs();
  void add_rows(std::size_t first, std::size_t last, std::vector<WindowRow>& rows);
  /// Appends the contacts of all hits from `first` to before `last`.
  void take_contacts(std::size_t first, std::size_t last);
  bool can_meet_again() const;

  std::shared_ptr<const Scene> scene_;
  Bodies bodies_;
  Horizon horizon_;
  MoverWants wants_;
  Interrupt& interrupt_;
  bool has_zone_;
  std::unique_ptr<Contact> contact_;
  std::size_t next_ = 0;  ///< object
  std::vector<Pair> pairs_, hits_, again_;
  std::vector<ContactTimes> times_, times_again_;
  std::vector<LegContact> contacts_;
};

}  // namespace foresee
