// Whom does one motion touch? Asked of exact contact, about a motion as it would be stored: the word on k =
// 0, on a question about one change, and on who stands at the end of a row.
//
//   ExactAvoidance touched(question, intruders, interrupt);
//   touched.by(record, spared).empty()                 // clear
//
// What grows has grown since the stored t, whichever t the motion has: so a change goes on, without a new
// report, from what is known now.
//
// Who is touched at the object's first moment is not counted if Touching says so: never for ignore; for part
// if the distance of the centres never shrinks and they do not touch again, decided exactly where neither
// path is bent and both shapes are convex (else proven, or counted). Cost: some 100 ns an intruder.
#pragma once

#include <functional>
#include <vector>

#include "base/error.h"
#include "contact/contact.h"
#include "query/avoid/question.h"

namespace foresee {

/// One of the intruders: of which table, and its row there.
struct Intruder {
  int table;
  std::uint32_t row;

  friend bool operator==(const Intruder&, const Intruder&) = default;
};

class ExactAvoidance {
 public:
  using Scenes = std::vector<std::shared_ptr<const Scene>>;  ///< one a table

  ExactAvoidance(const AvoidQuestion& question, Scenes near, Interrupt& interrupt);
  ~ExactAvoidance();

  /// Those touched at the object's first moment, whatever comes then.
  std::vector<Intruder> at_first(const std::vector<double>& record);

  /// Those that make the motion touch. `first`: who is touched when the change is made, where that is not
  /// whom this motion touches at first.
  std::vector<Intruder> by(const std::vector<double>& record, const std::vector<Intruder>* first = nullptr);

  /// How an intruder is met at the object's first moment, where and how fast, in the nearest doubles and
  /// how far they are off; and of balls, discs and what is upright the square of the distance of the centres,
  /// on the axes that are round, less that of their reach, rounded down, or 0 where that is not above 0.
  struct First {
    std::array<double, 3> x{}, ex{}, v{}, ev{};
    double square_gap = 0;
  };
  First first(const std::vector<double>& record, const Intruder& intruder);

  /// Of those of by() the one that is touched first: ties by table, then by id.
  std::optional<Blocker> first_of(const std::vector<double>& record, const std::vector<Intruder>& touched);

  /// The object's motion in a record of its table, and back.
  static OwnMotion motion_in(const Layout& layout, const std::vector<double>& record);
  static std::vector<double> with_motion(const Layout& layout, std::vector<double> record,
                                         const OwnMotion& motion);

 private:
  void take(const std::vector<double>& record);
  /// The own row's form, turned by the row's heading.
  void take_form();
  std::unique_ptr<Contact> contact(std::size_t table, const Horizon& horizon) const;
  std::vector<Intruder> decided(std::vector<std::unique_ptr<Contact>>& contacts,
                                const std::vector<std::vector<std::uint8_t>>& left_out);
  bool touches(Contact& contact, const Intruder& intruder) const;
  bool touches_first(const Intruder& intruder);
  bool separates(const Intruder& intruder);

  const AvoidQuestion& question_;
  Interrupt& interrupt_;
  Scenes near_;
  Scene own_;  ///< of one row, which take() changes
  std::vector<std::unique_ptr<Contact>> contacts_, at_first_;
  double start_ = 0, heading_ = 0;
};

}  // namespace foresee
