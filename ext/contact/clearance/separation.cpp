#include "contact/clearance/separation.h"

#include <optional>

#include "contact/clearance/separation_case.h"

namespace foresee {

namespace {

template <int D>
ClearanceVerdict judged(const SeparationCase<D>& question, const TrajectoryFamily<D>& family) {
  if (question.never_together()) return ClearanceVerdict::clear;
  if (!question.is_finite()) return ClearanceVerdict::blocked;
  double tau = 0;
  std::optional<double> nearest[2];  // of the first and the last change, once known
  const TrajectoryEstimate<D>* const ends[] = {&family.first, &family.last};
  switch (question.probe(family.middle, tau)) {
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
  if (!question.bends() && !family.one_interval)
    for (int i = 0; i < 2; ++i) {
      const double near = nearest[i] ? *nearest[i] : question.nearest_time(*ends[i]);
      if (question.ends_touch_about(near)) return ClearanceVerdict::blocked;
    }
  const bool one_interval = family.one_interval && !question.bends();
  if (one_interval && question.touches(family.first) && question.touches(family.last))
    return ClearanceVerdict::blocked;
  return ClearanceVerdict::open;
}

}  // namespace

template <int D>
ClearanceVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                   std::uint64_t& evaluations) {
  const SeparationCase<D> question(encounter, family);
  const ClearanceVerdict judgement = judged(question, family);
  evaluations += 1 + question.parts();
  return judgement;
}

template ClearanceVerdict certify_clearance<1>(const Encounter<1>&, const TrajectoryFamily<1>&,
                                               std::uint64_t&);
template ClearanceVerdict certify_clearance<2>(const Encounter<2>&, const TrajectoryFamily<2>&,
                                               std::uint64_t&);
template ClearanceVerdict certify_clearance<3>(const Encounter<3>&, const TrajectoryFamily<3>&,
                                               std::uint64_t&);

}  // namespace foresee
