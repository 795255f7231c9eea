// Contact with everything decided that can be decided before the first pair: shapes, axes, degree of the
// motion.
#pragma once

#include "contact/closest_approach.h"
#include "contact/crossing.h"

namespace foresee {

template <class Kind, int Degree>
class TypedContact final : public Contact {
 public:
  static constexpr int D = Kind::axes;

  explicit TypedContact(const Setup& setup) : setup_(setup) {}

  Reach reach() const override { return {setup_.within, setup_.within_z}; }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    for (const Pair& pair : pairs)
      if (touches(setup_.a.row(pair.a), setup_.b.row(pair.b))) hits.push_back(pair);
  }

  void times(std::span<const Pair> hits, std::span<ContactTimes> out) override {
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = times_of(setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

  void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) override {
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = closest_approach_of<D>(setup_, setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

 private:
  Track<Kind, Degree> track(const double* row_a, const double* row_b, const Moments& moments) const {
    return {relative_of<D, Degree>(setup_, row_a, row_b),
            Kind::template sizes<double>(raw_sizes_of<double, D>(setup_, row_a, row_b), setup_.within,
                                         setup_.within_z),
            moments};
  }

  bool touches(const double* row_a, const double* row_b) const {
    const Moments moments = moments_of(setup_, row_a, row_b);
    if (moments.none) return false;
    Bracket first;
    return track(row_a, row_b, moments).first_contact(first) != Verdict::no;
  }

  ContactTimes times_of(const double* row_a, const double* row_b) const {
    const Moments moments = moments_of(setup_, row_a, row_b);
    const auto track = this->track(row_a, row_b, moments);
    const Instant begin{moments.dt_begin, moments.t_begin}, end{moments.dt_end, moments.t_end};
    Instant from = begin, to = end;
    Bracket first, last;
    const Verdict verdict = track.first_contact(first);
    if (verdict == Verdict::uncertain) first.after = first.before;
    if (first.after > first.before || first.before > moments.dt_begin)
      from = settled<Way::in>(track, first, row_a, row_b, begin, end);
    const Verdict leaves = track.end_of_contact(first.after, last);
    if (leaves != Verdict::no) to = settled<Way::out>(track, last, row_a, row_b, from, end);
    return {from.t, to.t, from.dt, to.dt};
  }

  /// The crossing in the bracket, clipped to what was asked; the bracket's begin where doubles cannot settle
  /// it.
  template <Way way>
  Instant settled(const Track<Kind, Degree>& track, const Bracket& bracket, const double* row_a,
                  const double* row_b, const Instant& least, const Instant& most) const {
    using Wide = DoubleDouble;
    const CrossingVisitor<way, D, Degree> visitor(track.relative(), course_of<Wide, D>(setup_, row_a, row_b),
                                                  bracket, setup_.horizon.now);
    const auto sizes = Kind::template sizes<Wide>(raw_sizes_of<Wide, D>(setup_, row_a, row_b),
                                                  Wide{setup_.within, 0}, Wide{setup_.within_z, 0});
    Instant crossing = Kind::visit(sizes, visitor);
    if (!crossing.known()) crossing = {bracket.before, setup_.horizon.now + bracket.before};
    return earlier(later(crossing, least), most);
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
