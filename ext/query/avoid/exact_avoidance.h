// The near objects that one motion touches, decided by exact contact for the motion as it would be stored.
//
//   ExactAvoidance exact(manoeuvre, interrupt);
//   exact.touching({record}, exact.touching_at_start({record})).empty()          // clear
//
// It says what touches at the start of the manoeuvre, decides k = 0 and queries of a single change, and names the
// near object at the end of a row. Extents grow from the stored t, whichever t the motion has: a change continues,
// without a new report, what is known now.
//
// Near objects that touch at the first time of the object are exempt as Touching says. With `ignore` they never
// count. With `part` they do not count if the distance of the centres never decreases and they do not touch
// again. That is decided exactly if neither path is bent and both shapes are convex; else it is proven, or
// the near object counts. A leg that starts while they touch counts as touching again.
// Cost: some 100 ns per near object.
#pragma once

#include <vector>

#include "base/error.h"
#include "base/interval_tree.h"
#include "contact/contact.h"
#include "query/avoid/manoeuvre_case.h"

namespace foresee {

/// A near object, or one leg of its plan: a row of ManoeuvreCase::near_objects.
struct NearRow {
  std::size_t table;
  std::uint32_t row;

  friend bool operator==(const NearRow&, const NearRow&) = default;
};

class ExactAvoidance {
 public:
  using Records = OwnState::Records;  ///< of the legs of one motion, in order of time

  /// `manoeuvre` must outlive this. Motions that are tested have at most as many legs as it, or as its object.
  ExactAvoidance(const ManoeuvreCase& manoeuvre, Interrupt& interrupt);
  ~ExactAvoidance();

  /// The near objects that touch at the first time of the object, whatever follows.
  std::vector<NearRow> touching_at_start(const Records& legs);

  /// The near objects that the motion touches. `exempt`: those that touch when the manoeuvre starts.
  std::vector<NearRow> touching(const Records& legs, const std::vector<NearRow>& exempt);

  /// A near object relative to the object at its first time: position and velocity in the nearest doubles, with
  /// errors. `square_gap`, for balls, discs and upright shapes: the squared distance of the centres on the
  /// round axes, less the squared reach, rounded down; 0 if that is not above 0.
  struct InitialState {
    std::array<double, 3> x{}, ex{}, v{}, ev{};
    double square_gap = 0;
  };
  InitialState initial_state(const Records& legs, const NearRow& near_row);

  /// The one of these that is touched first; ties by table, then by id.
  std::optional<Blocker> first_touching(const Records& legs, const std::vector<NearRow>& touching);

 private:
  /// Fills moved_ with these legs: contacts then test them.
  void set_motion(const Records& legs);
  void set_row(std::size_t leg, const std::vector<double>& record);
  /// Rotates the own form by the heading of each row.
  void set_forms();
  std::unique_ptr<Contact> contact(std::size_t table, const Horizon& horizon) const;
  /// The rows of a table that exist together with the leg, ascending; all if there is one leg.
  void find_rows(std::uint32_t leg, std::size_t table, std::vector<std::uint32_t>& rows) const;
  /// The near objects that these contacts find during the horizon.
  std::vector<NearRow> decided(std::vector<std::unique_ptr<Contact>>& contacts, const Horizon& horizon,
                               const std::vector<std::vector<std::uint8_t>>& left_out);
  /// Appends all legs of the objects of which one leg is in the list.
  void add_other_legs_of(std::vector<NearRow>& touching) const;
  bool touches(Contact& contact, std::uint32_t leg, const NearRow& near_row) const;

  // From the first time of the object on (exact_start.cpp, as initial_state()):
  bool touches_at_start(std::uint32_t leg, const NearRow& near_row);
  /// Whether it is certain that the leg separates from a near object that touches: the distance of the centres never
  /// decreases, and the two do not touch again. Outlines that are apart at the first time: whether they never touch.
  bool separates(std::uint32_t leg, const NearRow& near_row);
  /// Each leg separates from the near object or never touches it.
  bool all_separate(const NearRow& near_row);

  std::size_t tables() const { return manoeuvre_.near_objects.size(); }
  const Scene& near_scene(std::size_t table) const { return *manoeuvre_.near_objects[table].scene; }

  const ManoeuvreCase& manoeuvre_;
  const AvoidQuestion& question_;
  Interrupt& interrupt_;
  Scene moved_;             ///< the object: a row for each leg, which set_motion() sets
  std::uint32_t legs_ = 1;  ///< rows in use
  std::vector<std::unique_ptr<Contact>> contacts_, start_contacts_;
  std::vector<IntervalTree> lives_;  ///< of the rows of each table
  double start_ = 0;
  std::vector<double> headings_;
};

}  // namespace foresee
