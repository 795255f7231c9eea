#include "contact/growing/separation.h"

#include <optional>

#include "contact/growing/separation_case.h"

namespace foresee {

namespace {

template <int D>
Judgement judged(const SeparationCase<D>& question, const ChangedWays<D>& ways) {
  if (question.never_together()) return Judgement::clear;
  if (!question.is_finite()) return Judgement::blocked;
  double tau = 0;
  std::optional<double> nearest[2];  // of the first and the last change, once known
  const RoughWay<D>* const ends[] = {&ways.first, &ways.last};
  switch (question.look(ways.middle, tau)) {
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
  if (!question.bends() && !ways.one_interval)
    for (int i = 0; i < 2; ++i) {
      const double near = nearest[i] ? *nearest[i] : question.nearest_moment(*ends[i]);
      if (question.ends_touch_about(near)) return Judgement::blocked;
    }
  const bool one_interval = ways.one_interval && !question.bends();
  if (one_interval && question.touches(ways.first) && question.touches(ways.last)) return Judgement::blocked;
  return Judgement::open;
}

}  // namespace

template <int D>
Judgement judge(const Encounter<D>& met, const ChangedWays<D>& ways, std::uint64_t& looks) {
  const SeparationCase<D> question(met, ways);
  const Judgement judgement = judged(question, ways);
  looks += 1 + question.parts();
  return judgement;
}

template Judgement judge<1>(const Encounter<1>&, const ChangedWays<1>&, std::uint64_t&);
template Judgement judge<2>(const Encounter<2>&, const ChangedWays<2>&, std::uint64_t&);
template Judgement judge<3>(const Encounter<3>&, const ChangedWays<3>&, std::uint64_t&);

}  // namespace foresee
