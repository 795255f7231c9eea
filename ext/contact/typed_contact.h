// Contact with everything decided that can be decided before the first pair: shapes, axes, degree of the
// motion.
#pragma once

#include "contact/closest_approach.h"
#include "contact/crossing.h"
#include "contact/exact_contact.h"
#include "motion/float_environment.h"

namespace foresee {

template <class Kind, int Degree>
class TypedContact final : public Contact {
 public:
  static constexpr int D = Kind::axes;

  explicit TypedContact(const Setup& setup) : setup_(setup) {}

  Reach reach() const override { return {setup_.within, setup_.within_z}; }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      fetch_ahead(pairs, i);
      if (touches(setup_.a.row(pairs[i].a), setup_.b.row(pairs[i].b))) hits.push_back(pairs[i]);
    }
  }

  void times(std::span<const Pair> hits, std::span<ContactTimes> out, TimesWanted wanted) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      fetch_ahead(hits, i);
      out[i] = times_of(setup_.a.row(hits[i].a), setup_.b.row(hits[i].b), wanted);
    }
  }

  void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = closest_approach_of<D>(setup_, setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

 private:
  /// Asks for the rows of a later pair: neighbours in space are seldom neighbours in memory, and waiting for
  /// memory would be a quarter of a decision.
  void fetch_ahead(std::span<const Pair> pairs, std::size_t i) const {
    constexpr std::size_t ahead = 8, doubles_per_line = 8;
    if (i + ahead >= pairs.size()) return;
    const double* row_a = setup_.a.row(pairs[i + ahead].a);
    const double* row_b = setup_.b.row(pairs[i + ahead].b);
    __builtin_prefetch(row_a);
    __builtin_prefetch(row_a + doubles_per_line);
    __builtin_prefetch(row_b);
    __builtin_prefetch(row_b + doubles_per_line);
  }

  Track<Kind, Degree> track(const double* row_a, const double* row_b, const Moments& moments) const {
    return {setup_, row_a, row_b, moments};
  }

  [[gnu::flatten]] bool touches(const double* row_a, const double* row_b) const {
    const Moments moments = moments_of(setup_, row_a, row_b);
    if (moments.none) return false;
    const Verdict verdict = track(row_a, row_b, moments).touches();
    if (verdict != Verdict::uncertain) return verdict == Verdict::yes;
    return exactly<bool>(row_a, row_b, exact_touches);
  }

  ContactTimes times_of(const double* row_a, const double* row_b, TimesWanted wanted) const {
    Instant begin, end;
    if (filtered_times(row_a, row_b, wanted, begin, end)) return {begin.t, end.t, begin.dt, end.dt};
    return exactly<ContactTimes>(row_a, row_b, exact_times);
  }

  /// What double and DoubleDouble can vouch for; false where they cannot.
  [[gnu::flatten]] bool filtered_times(const double* row_a, const double* row_b, TimesWanted wanted,
                                       Instant& begin, Instant& end) const {
    const Moments moments = moments_of(setup_, row_a, row_b);
    const Instant first_moment{moments.dt_begin, moments.t_begin}, last_moment{moments.dt_end, moments.t_end};
    const auto track = this->track(row_a, row_b, moments);
    Bracket first, last;
    if (track.first_contact(first) != Verdict::yes) return false;
    begin = first_moment;
    if (first.after > moments.dt_begin) begin = later(crossing<Way::in>(track, first, row_a, row_b), begin);
    end = last_moment;
    if (wanted == TimesWanted::begins) return begin.known();
    const Verdict leaves = track.end_of_contact(first.after, last);
    if (leaves == Verdict::uncertain) return false;
    if (leaves == Verdict::yes) end = earlier(crossing<Way::out>(track, last, row_a, row_b), end);
    return begin.known() && end.known();
  }

  template <Way way>
  Instant crossing(const Track<Kind, Degree>& track, const Bracket& bracket, const double* row_a,
                   const double* row_b) const {
    const auto course = course_of<DoubleDouble, D>(setup_, row_a, row_b);
    return Kind::visit(
        sizes<DoubleDouble>(row_a, row_b),
        CrossingVisitor<way, D, Degree>(track.relative(), course, bracket, setup_.horizon.now));
  }

  template <class Answer>
  [[gnu::noinline]] Answer exactly(const double* row_a, const double* row_b,
                                   Answer (*ask)(Formula&, const ExactMoments&)) const {
    const PairPolynomials<Kind> polynomials(setup_, row_a, row_b);
    Formula formula;
    polynomials.formula(formula);
    return ask(formula, exact_moments_of(setup_, row_a, row_b));
  }

  template <class T>
  auto sizes(const double* row_a, const double* row_b) const {
    return Kind::template sizes<T>(raw_sizes_of<T, D>(setup_, row_a, row_b), setup_);
  }

  Setup setup_;
};

template <class Kind>
std::unique_ptr<Contact> make_typed(const Setup& setup, int degree) {
  if (degree < 2) return std::make_unique<TypedContact<Kind, 1>>(setup);
  return std::make_unique<TypedContact<Kind, 2>>(setup);
}

/// For kinds of two and three axes.
template <template <int> class Kind>
std::unique_ptr<Contact> make_typed_for_axes(const Setup& setup, int degree) {
  if (setup.a.layout.axes == 2) return make_typed<Kind<2>>(setup, degree);
  return make_typed<Kind<3>>(setup, degree);
}

}  // namespace foresee
