// Contact of pairs of moving objects: which pairs touch during the horizon, when, and their closest approach.
// The public interface of the module.
//
//   const ContactQuestion question{.horizon = {.now = 600, .h = 600}, .within = 926};
//   auto contact = make_contact(ships, ships, question, "ships", "ships");
//   contact->decide(candidates, hits);        // keeps the pairs that touch at some time of the horizon
//   contact->first_contacts(candidates, TimesWanted::both, hits, times);        // the same, with the times
//
// A pair of layouts and a ContactQuestion become typed code, once per statement. Contact is closed: touching
// counts. A pair is examined only while both objects exist: during [max(now, t_a, t_b), min(now + h, until_a,
// until_b)]. Objects may have different reference times and different laws of motion.
//
// The answers obey sixteen laws, which stand above the class Contact. An object of this type has scratch
// space and is used by one thread at a time; several may share the same bodies.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "shape/bodies.h"

namespace foresee {

struct ContactQuestion {
  Horizon horizon;
  double within = 0;                     ///< the distance that counts as touching; >= 0, finite
  std::optional<double> within_z = {};   ///< on three axes: a separate limit along z; >= 0, finite
  bool rectangles_for_outlines = false;  ///< replace each outline by the smallest rectangle around it
};

/// Start and end of the first contact within the lifetime of the pair: absolute, and measured from `now`.
struct ContactTimes {
  double t, t_end;
  double dt, dt_end;
};

/// Which times are requested; ends cost as much as starts.
enum class TimesWanted : std::uint8_t { starts, both };

/// The closest approach of the two centres while both exist in the horizon; the earliest time on ties.
struct ClosestApproach {
  double t, dt;
  double d;
};

/// The laws of contact, for every pair of shapes, bit for bit. A law applies only
/// if the change of the numbers is exact in doubles.
/// tests/contact/laws_test.cpp and laws_of_order_test.cpp check each law by its number.
///
/// Law 1 (symmetry): exchanging a and b changes no answer.
/// Law 2 (mirrors): negating all numbers along one axis changes no answer.
/// Law 3 (axes): exchanging two axes changes no answer; of upright shapes, x and y.
/// Law 4 (lengths): scaling all lengths by a power of two scales d and changes no time.
/// Law 5 (durations): scaling all times by a power of two scales all times of the answer.
/// Law 6 (place): adding one amount to all places changes no answer.
/// Law 7 (time): adding one amount to now, t and until moves t and t_end, and changes neither dt nor d.
/// Law 8 (reference time): the same motion, given at another reference time, has the same answers.
/// Law 9 (reversal): running the horizon backwards changes neither whether a pair touches nor d.
/// Law 10 (splitting): the first contact is that of the first half of the horizon, else of the second.
/// Law 11 (size): greater `within` or extents lose no pair, and no pair touches later.
/// Law 12 (growth): faster growth loses no pair, and no pair touches later.
/// Law 13 (horizon): a longer horizon loses no pair, keeps its t, and no contact ends earlier.
/// Law 14 (order): max(now, t_a, t_b) <= t <= t_end <= min(now + h, until_a, until_b), and
/// 0 <= dt <= dt_end <= h.
/// Law 15 (distance): balls that do not grow touch if and only if d <= r_a + r_b + within, exactly.
/// Law 16 (independence): neither the other pairs of a call nor their order change an answer.
class Contact {
 public:
  Contact() = default;
  virtual ~Contact() = default;
  Contact(const Contact&) = delete;
  Contact& operator=(const Contact&) = delete;

  /// Appends to `hits` the pairs that touch, in the order of `pairs`. The answer is that of the real numbers
  /// which the stored doubles are, without a tolerance, whichever stage decides (docs/explanation/exactness.md). Cost:
  /// some tens of nanoseconds for most pairs; microseconds, rarely more, for pairs that doubles cannot decide
  /// (docs/explanation/accuracy.md). No interrupt is polled unless set_interrupt() says so: pass some hundred pairs per
  /// call.
  virtual void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) = 0;

  /// As decide(), and appends the times of each hit to `times`: each is the exact time, rounded once. End times
  /// are unspecified unless requested. Costs more than decide(), which searches any time of contact.
  virtual void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                              std::vector<ContactTimes>& times) = 0;

  /// Appends every contact of each pair, in order of time: the pair to `hits` and the times of the contact to `times`.
  /// The first one has the times of first_contacts(). Paths that do not bend meet once at most; others may touch, part
  /// and touch again. Contacts that touch each other are one. Throws Error for outlines and meshes. Cost: that of
  /// first_contacts(), and some ten microseconds for a pair that touches on bent paths.
  virtual void all_contacts(std::span<const Pair> pairs, std::vector<Pair>& hits,
                            std::vector<ContactTimes>& times);

  /// Closest approach of pairs that decide() has kept; `out` has one place for each.
  virtual void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) = 0;

  /// Contacts whose single pairs may take long poll `interrupt` within a pair from now on. It must outlive
  /// this.
  virtual void set_interrupt(Interrupt& /*interrupt*/) {}

  /// The work spent on the pairs so far, in words; "" if it is not counted.
  virtual std::string effort() const { return ""; }
};

/// The contact of two tables. `name_a` and `name_b` are their names in messages. The table of
/// docs/explanation/semantics.md says which distance decides: by the layouts, and by whether anything is
/// round (`within` or a radius above 0, now or later). Throws Error for pairs without a distance
/// (docs/reference/predictive_join.md#distances). These are a cylinder and a ball of any r; within_z on fewer
/// than three axes; within_z if neither table has points, cylinders or prisms. Requires: a and b have the
/// same number of axes and outlive the contact.
std::unique_ptr<Contact> make_contact(const Bodies& a, const Bodies& b, const ContactQuestion& question,
                                      const std::string& name_a, const std::string& name_b);

struct Setup;  // contact/setup.h

/// The closest approach of two centres (closest_approach.cpp). Cost: about a microsecond; tens of them in exact
/// arithmetic. Requires: both objects exist together at some time of the horizon.
template <int D>
ClosestApproach closest_approach_of(const Setup& setup, const double* row_a, const double* row_b);

}  // namespace foresee
