#include "contact/growing/separation.h"

#include "contact/growing/separation_case.h"

namespace foresee::contact {

template <int D>
Judgement judge(const Encounter<D>& met, const ChangedWays<D>& ways) {
  const SeparationCase<D> question(met, ways);
  if (question.never_together()) return Judgement::clear;
  if (!question.is_finite()) return Judgement::blocked;
  double tau = 0;
  switch (question.look(ways.middle, tau)) {
    case Look::proven:
      return Judgement::clear;
    case Look::touches:
      if (question.all_touch_about(tau)) return Judgement::blocked;
      break;
    case Look::open:
      for (const RoughWay<D>* end : {&ways.first, &ways.last}) {
        double ignored = 0;
        if (question.look(*end, ignored) == Look::proven) return Judgement::clear;
      }
      if (question.all_touch_about(tau)) return Judgement::blocked;
      break;
  }
  if (question.ends_touch_about(tau)) return Judgement::blocked;
  if (!question.bends() && !ways.one_interval)
    for (const RoughWay<D>* end : {&ways.first, &ways.last})
      if (question.ends_touch_about(question.nearest_moment(*end))) return Judgement::blocked;
  const bool one_interval = ways.one_interval && !question.bends();
  if (one_interval && question.touches(ways.first) && question.touches(ways.last)) return Judgement::blocked;
  return Judgement::open;
}

template Judgement judge<1>(const Encounter<1>&, const ChangedWays<1>&);
template Judgement judge<2>(const Encounter<2>&, const ChangedWays<2>&);
template Judgement judge<3>(const Encounter<3>&, const ChangedWays<3>&);

}  // namespace foresee::contact
