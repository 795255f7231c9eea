// The intruders that one motion touches, decided by exact contact for the motion as it would be stored.
//
//   ExactAvoidance exact(manoeuvre, interrupt);
//   exact.touching({record}, exact.touching_at_start({record})).empty()          // clear
//
// It says what touches at the change, decides k = 0 and queries of a single change, and names the intruder at the end
// of a row. Extents grow
// from the stored t, whichever t the motion has: a change continues, without a new report, what is known now.
//
// Intruders that touch at the first time of the object are exempt as Touching says. With `ignore` they never
// count. With `part` they do not count if the distance of the centres never decreases and they do not touch
// again. That is decided exactly if neither path is bent and both shapes are convex; else it is proven, or
// the intruder counts. A leg that starts while they touch counts as touching again.
// Cost: some 100 ns per intruder.
#pragma once

#include <functional>
#include <vector>

#include "base/error.h"
#include "contact/contact.h"
#include "query/avoid/manoeuvre_case.h"

namespace foresee {

/// An intruder: its table, and its row there.
struct Intruder {
  std::size_t table;
  std::uint32_t row;

  friend bool operator==(const Intruder&, const Intruder&) = default;
};

class ExactAvoidance {
 public:
  using Records = OwnState::Records;  ///< of the legs of one motion, in order of time

  /// `manoeuvre` must outlive this. Motions that are tested have at most as many legs as it, or as its object.
  ExactAvoidance(const ManoeuvreCase& manoeuvre, Interrupt& interrupt);
  ~ExactAvoidance();

  /// The intruders that touch at the first time of the object, whatever follows.
  std::vector<Intruder> touching_at_start(const Records& legs);

  /// The intruders that the motion touches. `exempt`: those that touch when the change is made.
  std::vector<Intruder> touching(const Records& legs, const std::vector<Intruder>& exempt);

  /// An intruder relative to the object at its first time: position and velocity in the nearest doubles, with
  /// errors. `square_gap`, for balls, discs and upright shapes: the squared distance of the centres on the
  /// round axes, less the squared reach, rounded down; 0 if that is not above 0.
  struct InitialState {
    std::array<double, 3> x{}, ex{}, v{}, ev{};
    double square_gap = 0;
  };
  InitialState initial_state(const Records& legs, const Intruder& intruder);

  /// The one of these that is touched first; ties by table, then by id.
  std::optional<Blocker> first_touching(const Records& legs, const std::vector<Intruder>& touching);

 private:
  void take(const Records& legs);
  void take_row(std::size_t leg, const std::vector<double>& record);
  /// Rotates the own form by the heading of each row.
  void take_forms();
  std::unique_ptr<Contact> contact(std::size_t table, const Horizon& horizon) const;
  /// Whether the leg and the intruder's row exist at one time; true where this is not worth a test.
  bool may_meet(std::uint32_t leg, std::size_t table, std::uint32_t row) const;
  /// The intruders that these contacts find during the horizon.
  std::vector<Intruder> decided(std::vector<std::unique_ptr<Contact>>& contacts, const Horizon& horizon,
                                const std::vector<std::vector<std::uint8_t>>& left_out);
  /// Appends all legs of the objects of which one leg is in the list.
  void complete(std::vector<Intruder>& touching) const;
  bool touches(Contact& contact, std::uint32_t leg, const Intruder& intruder) const;
  bool touches_at_start(std::uint32_t leg, const Intruder& intruder);
  bool separates(std::uint32_t leg, const Intruder& intruder);
  /// Each leg separates from the intruder or never touches it.
  bool all_separate(const Intruder& intruder);

  std::size_t tables() const { return manoeuvre_.near.size(); }
  const Scene& near(std::size_t table) const { return *manoeuvre_.near[table].scene; }

  const ManoeuvreCase& manoeuvre_;
  const AvoidQuestion& question_;
  Interrupt& interrupt_;
  Scene moved_;             ///< the object: a row for each leg, which take() changes
  std::uint32_t legs_ = 1;  ///< rows in use
  std::vector<std::unique_ptr<Contact>> contacts_, start_contacts_;
  double start_ = 0;
  std::vector<double> headings_;
};

}  // namespace foresee
