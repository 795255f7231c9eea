#include "contact/growing/changed_ways.h"

namespace foresee::contact {

template <int D>
RoughWay<D> rough_way(const OwnMotion& base, const Change& change, double k) {
  const MotionSet<D> one = motions_between<D>(base, change, k, k);
  return {one.place.centre, one.velocity.centre, one.acceleration.centre, one.begin, one.end};
}

template <int D>
ChangedWays<D> changed_ways(const OwnMotion& base, const Change& change, double p, double q) {
  ChangedWays<D> ways;
  ways.all = motions_between<D>(base, change, p, q);
  const auto& all = ways.all;
  ways.middle = {all.place.centre, all.velocity.centre, all.acceleration.centre, all.begin, all.end};
  ways.first = rough_way<D>(base, change, p), ways.last = rough_way<D>(base, change, q);
  const VectorSet<D>* const parts[] = {&all.place, &all.velocity, &all.acceleration};
  for (int part = 0; part < 3; ++part)
    for (int axis = 0; axis < D; ++axis) {
      ways.most[part][axis] = parts[part]->greatest(axis);
      ways.least[part][axis] = parts[part]->least(axis);
    }
  const auto off_chord = [](const VectorSet<D>& set) {
    return set.turns ? (1 - (set.whole_circle ? -1 : set.cosine)) * set.radius : 0;
  };
  ways.turned[0] = (change.manoeuvre == Manoeuvre::delay ? all.place.pad.sum() : 0);
  ways.turned[1] = off_chord(all.velocity), ways.turned[2] = off_chord(all.acceleration);
  // Turned by more than a third of a circle, the middle stands for few of them: none moves on the whole.
  if (all.velocity.turns && all.velocity.cosine < 0.5) ways.middle.v *= all.velocity.cosine > 0 ? 0.5 : 0;
  ways.bends = (ways.most[2] != 0).any() || (ways.least[2] != 0).any();
  ways.one_interval = change.manoeuvre != Manoeuvre::turn && p < q;
  return ways;
}

template RoughWay<1> rough_way<1>(const OwnMotion&, const Change&, double);
template RoughWay<2> rough_way<2>(const OwnMotion&, const Change&, double);
template RoughWay<3> rough_way<3>(const OwnMotion&, const Change&, double);
template ChangedWays<1> changed_ways<1>(const OwnMotion&, const Change&, double, double);
template ChangedWays<2> changed_ways<2>(const OwnMotion&, const Change&, double, double);
template ChangedWays<3> changed_ways<3>(const OwnMotion&, const Change&, double, double);

}  // namespace foresee::contact
