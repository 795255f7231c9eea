#include "contact/clearance/separation.h"

#include <optional>

#include "contact/clearance/departure.h"
#include "contact/clearance/seen_from_start.h"
#include "contact/clearance/separation_case.h"

namespace foresee {

namespace {

template <int D>
ClearanceVerdict judged(SeparationCase<D>& question, const Encounter<D>& encounter,
                        const TrajectoryFamily<D>& family) {
  if (question.never_together()) return ClearanceVerdict::clear;
  if (!question.is_finite()) return ClearanceVerdict::blocked;
  double tau = 0;
  std::optional<double> nearest[2];  // of the first and the last change, once known
  const TrajectoryEstimate<D>* const ends[] = {&family.first, &family.last};
  const ProbeResult probe = question.probe(family.middle, tau);
  if (encounter.beside && !family.delayed && probe != ProbeResult::separated) {
    const Departure leaving = departure_of<D>(encounter, family);
    const double length = question.end() - question.begin();
    if (length <= 0 || leaving.away_until >= length) return ClearanceVerdict::clear;
    const double begin = question.begin() + 0.5 * std::min(leaving.away_until, length);
    if (leaving.away_until > 0 && question.is_proven_after(begin)) return ClearanceVerdict::clear;
    if (leaving.all_touch && question.all_start_together()) return ClearanceVerdict::blocked;
    if (!leaving.all_approach) question.take_only_certain_touches();
  }
  switch (probe) {
    case ProbeResult::separated:
      return ClearanceVerdict::clear;
    case ProbeResult::overlapping:
      if (question.all_touch_about(tau)) return ClearanceVerdict::blocked;
      break;
    case ProbeResult::inconclusive:
      for (int i = 0; i < 2; ++i) {
        double near = 0;
        if (question.probe(*ends[i], near) == ProbeResult::separated) return ClearanceVerdict::clear;
        nearest[i] = near;
      }
      if (question.all_touch_about(tau)) return ClearanceVerdict::blocked;
      break;
  }
  if (question.ends_touch_about(tau)) return ClearanceVerdict::blocked;
  if (question.bends()) {
    for (int i = 0; i < 2; ++i) {
      double near = 0;
      if (!nearest[i] && question.probe(*ends[i], near) == ProbeResult::separated)
        return ClearanceVerdict::clear;
      if (!nearest[i]) nearest[i] = near;
    }
    return question.all_touch_between(*nearest[0], *nearest[1]) ? ClearanceVerdict::blocked
                                                                : ClearanceVerdict::open;
  }
  if (!family.one_interval)
    for (int i = 0; i < 2; ++i) {
      const double near = nearest[i] ? *nearest[i] : question.nearest_time(*ends[i]);
      if (question.ends_touch_about(near)) return ClearanceVerdict::blocked;
    }
  if (family.one_interval && question.touches(family.first) && question.touches(family.last))
    return ClearanceVerdict::blocked;
  return ClearanceVerdict::open;
}

template <int D>
ClearanceVerdict judged(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                        std::uint64_t& evaluations) {
  SeparationCase<D> question(encounter, family);
  const ClearanceVerdict judgement = judged<D>(question, encounter, family);
  evaluations += 1 + question.parts();
  return judgement;
}

}  // namespace

template <int D>
ClearanceVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                   std::uint64_t& evaluations) {
  if (family.delayed) {
    const SeenFromStart<D> seen = seen_from_start<D>(encounter, family);
    const ClearanceVerdict judgement = judged<D>(seen.encounter, seen.family, evaluations);
    if (judgement != ClearanceVerdict::open) return judgement;
  }
  return judged<D>(encounter, family, evaluations);
}

template ClearanceVerdict certify_clearance<1>(const Encounter<1>&, const TrajectoryFamily<1>&,
                                               std::uint64_t&);
template ClearanceVerdict certify_clearance<2>(const Encounter<2>&, const TrajectoryFamily<2>&,
                                               std::uint64_t&);
template ClearanceVerdict certify_clearance<3>(const Encounter<3>&, const TrajectoryFamily<3>&,
                                               std::uint64_t&);

}  // namespace foresee
