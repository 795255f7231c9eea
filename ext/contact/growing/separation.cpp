#include "contact/growing/separation.h"

#include <optional>

#include "contact/growing/departure.h"
#include "contact/growing/seen_from_start.h"
#include "contact/growing/separation_case.h"

namespace foresee::contact {

namespace {

template <int D>
Judgement judged(SeparationCase<D>& question, const Encounter<D>& met, const ChangedWays<D>& ways) {
  if (question.never_together()) return Judgement::clear;
  if (!question.is_finite()) return Judgement::blocked;
  double tau = 0;
  std::optional<double> nearest[2];  // of the first and the last change, once known
  const RoughWay<D>* const ends[] = {&ways.first, &ways.last};
  const Look look = question.look(ways.middle, tau);
  if (met.beside && !ways.delayed && look != Look::proven) {
    const Departure leaving = departure_of<D>(met, ways);
    const double length = question.end() - question.begin();
    if (length <= 0 || leaving.away_until >= length) return Judgement::clear;
    const double begin = question.begin() + 0.5 * std::min(leaving.away_until, length);
    if (leaving.away_until > 0 && question.is_proven_after(begin)) return Judgement::clear;
    if (leaving.all_touch && question.all_start_together()) return Judgement::blocked;
    if (!leaving.all_approach) question.take_only_certain_touches();
  }
  switch (look) {
    case Look::proven:
      return Judgement::clear;
    case Look::touches:
      if (question.all_touch_about(tau)) return Judgement::blocked;
      break;
    case Look::open:
      for (int i = 0; i < 2; ++i) {
        double near = 0;
        if (question.look(*ends[i], near) == Look::proven) return Judgement::clear;
        nearest[i] = near;
      }
      if (question.all_touch_about(tau)) return Judgement::blocked;
      break;
  }
  if (question.ends_touch_about(tau)) return Judgement::blocked;
  if (question.bends()) {
    for (int i = 0; i < 2; ++i) {
      double near = 0;
      if (!nearest[i] && question.look(*ends[i], near) == Look::proven) return Judgement::clear;
      if (!nearest[i]) nearest[i] = near;
    }
    return question.all_touch_between(*nearest[0], *nearest[1]) ? Judgement::blocked : Judgement::open;
  }
  if (!ways.one_interval)
    for (int i = 0; i < 2; ++i) {
      const double near = nearest[i] ? *nearest[i] : question.nearest_moment(*ends[i]);
      if (question.ends_touch_about(near)) return Judgement::blocked;
    }
  if (ways.one_interval && question.touches(ways.first) && question.touches(ways.last))
    return Judgement::blocked;
  return Judgement::open;
}

template <int D>
Judgement judged(const Encounter<D>& met, const ChangedWays<D>& ways, std::uint64_t& looks) {
  SeparationCase<D> question(met, ways);
  const Judgement judgement = judged<D>(question, met, ways);
  looks += 1 + question.parts();
  return judgement;
}

}  // namespace

template <int D>
Judgement judge(const Encounter<D>& met, const ChangedWays<D>& ways, std::uint64_t& looks) {
  if (ways.delayed) {
    const SeenFromStart<D> seen = seen_from_start<D>(met, ways);
    const Judgement judgement = judged<D>(seen.met, seen.ways, looks);
    if (judgement != Judgement::open) return judgement;
  }
  return judged<D>(met, ways, looks);
}

template Judgement judge<1>(const Encounter<1>&, const ChangedWays<1>&, std::uint64_t&);
template Judgement judge<2>(const Encounter<2>&, const ChangedWays<2>&, std::uint64_t&);
template Judgement judge<3>(const Encounter<3>&, const ChangedWays<3>&, std::uint64_t&);

}  // namespace foresee::contact
