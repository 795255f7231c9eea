// The intruders that one motion touches, decided by exact contact for the motion as it would be stored.
//
//   ExactAvoidance exact(question, intruders, interrupt);
//   exact.touching(record, spared).empty()             // clear
//
// It decides k = 0 and queries of a single change, and names the intruder at the end of a row. Extents grow
// from the stored t, whichever t the motion has: a change continues, without a new report, what is known now.
//
// Intruders that touch at the first time of the object are exempt as Touching says. With `ignore` they never
// count. With `part` they do not count if the distance of the centres never decreases and they do not touch
// again. That is decided exactly if neither path is bent and both shapes are convex; else it is proven, or
// the intruder counts.
// Cost: some 100 ns per intruder.
#pragma once

#include <functional>
#include <vector>

#include "base/error.h"
#include "contact/contact.h"
#include "query/avoid/question.h"

namespace foresee {

/// An intruder: its table, and its row there.
struct Intruder {
  int table;
  std::uint32_t row;

  friend bool operator==(const Intruder&, const Intruder&) = default;
};

class ExactAvoidance {
 public:
  using Scenes = std::vector<std::shared_ptr<const Scene>>;  ///< one per table

  ExactAvoidance(const AvoidQuestion& question, Scenes near, Interrupt& interrupt);
  ~ExactAvoidance();

  /// The intruders that touch at the first time of the object, whatever follows.
  std::vector<Intruder> touching_at_start(const std::vector<double>& record);

  /// The intruders that the motion touches. `first`: those that touch when the change is made, if these are not
  /// the ones that this motion touches at its first time.
  std::vector<Intruder> touching(const std::vector<double>& record,
                                 const std::vector<Intruder>* first = nullptr);

  /// An intruder relative to the object at its first time: position and velocity in the nearest doubles, with
  /// errors. `square_gap`, for balls, discs and upright shapes: the squared distance of the centres on the
  /// round axes, less the squared reach, rounded down; 0 if that is not above 0.
  struct InitialState {
    std::array<double, 3> x{}, ex{}, v{}, ev{};
    double square_gap = 0;
  };
  InitialState initial_state(const std::vector<double>& record, const Intruder& intruder);

  /// The one of these that is touched first; ties by table, then by id.
  std::optional<Blocker> first_touching(const std::vector<double>& record,
                                        const std::vector<Intruder>& touching);

 private:
  void take(const std::vector<double>& record);
  /// Rotates the own form by the heading of the row.
  void take_form();
  std::unique_ptr<Contact> contact(std::size_t table, const Horizon& horizon) const;
  std::vector<Intruder> decided(std::vector<std::unique_ptr<Contact>>& contacts,
                                const std::vector<std::vector<std::uint8_t>>& left_out);
  bool touches(Contact& contact, const Intruder& intruder) const;
  bool touches_at_start(const Intruder& intruder);
  bool separates(const Intruder& intruder);

  const AvoidQuestion& question_;
  Interrupt& interrupt_;
  Scenes near_;
  Scene own_;  ///< one row, which take() changes
  std::vector<std::unique_ptr<Contact>> contacts_, at_first_;
  double start_ = 0, heading_ = 0;
};

}  // namespace foresee
