#include "contact/clearance/bent_parting.h"

#include <algorithm>

#include "contact/clearance/parting_course.h"
#include "contact/clearance/separation_case.h"

namespace foresee {
namespace {

/// One judgement.
template <int D>
class BentParting {
 public:
  BentParting(const Encounter<D>& encounter, const TrajectoryFamily<D>& family, std::uint64_t& evaluations)
      : encounter_(encounter),
        family_(family),
        looks_(evaluations),
        question_(encounter, family),
        spread_(encounter, family),
        course_(encounter.extents, relative(encounter, family.middle), question_.end()) {}

  ClearanceVerdict judgement() {
    looks_ += sampled_times;
    const double end = question_.end(), leaves = course_.leaves();
    if (course_.shrinks_most() < 0 && course_.touches_again() < 0) {
      if (leaves < end && is_proven_at(0.5)) return ClearanceVerdict::clear;
      if (course_.stays_until() == end && (leaves == end || course_.is_ball()) && parts_until(end))
        return ClearanceVerdict::clear;
      return all_shrink_at(course_.shrinks_next()) ? ClearanceVerdict::blocked : ClearanceVerdict::open;
    }
    return all_shrink_at(course_.shrinks_most()) || all_touch_again() ? ClearanceVerdict::blocked
                                                                      : ClearanceVerdict::open;
  }

 private:
  static constexpr AxisRange all_axes{0, D};

  /// Both proofs meet at this share of the time that the middle leaves for it, or near an end of that.
  bool is_proven_at(double share) {
    const double time = course_.leaves() + share * (course_.stays_until() - course_.leaves());
    const bool parts = parts_until(time);
    if (parts && question_.is_proven_after(time)) return true;
    return share == 0.5 && is_proven_at(parts ? 0.9 : 0.1);
  }

  /// Until then the distance does not shrink, and who leaves does not come back.
  bool parts_until(double end) {
    if (!spread_.never_shrinks(all_axes, 0, end, looks_)) return false;
    if (course_.is_ball()) return true;
    for (const LeftTogether& group : course_.groups())
      if (!leaves_once(group, end)) return false;
    return true;
  }
  /// Inside at first, and then ever farther.
  bool leaves_once(const LeftTogether& group, double end) {
    const AxisRange& axes = group.axes;
    if (spread_.never_shrinks(axes, 0, end, looks_)) return true;
    if (group.exits >= end && stays_within(group, end)) return true;
    const double exits = std::min(group.exits, end), from = std::min(group.grows_from, exits),
                 time = from + 0.5 * (exits - from);
    return stays_within(group, time) && spread_.never_shrinks(axes, time, end, looks_);
  }
  bool stays_within(const LeftTogether& group, double end) const {
    return group.axes.end - group.axes.begin > 1 ? spread_.stays_within_disc(group.half, end)
                                                 : spread_.stays_within(group.axes.begin, group.half, end);
  }

  /// At one moment all touch, or are not told from that, while the distance shrinks.
  bool all_shrink_at(double tau) const {
    return tau >= 0 && spread_.slope(all_axes, tau).high <= 0 && question_.all_touch_about(tau);
  }
  /// All touch, at one moment or each at its own, that were apart at another.
  bool all_touch_again() const {
    const double again = course_.touches_again();
    if (again < 0 || !question_.none_touches_about(course_.farthest_before())) return false;
    if (question_.all_touch_about(again)) return true;
    const auto again_of = [&](const TrajectoryEstimate<D>& own) {
      return PartingCourse<D>(encounter_.extents, relative(encounter_, own), question_.end()).touches_again();
    };
    const double first = again_of(family_.first), last = first < 0 ? -1 : again_of(family_.last);
    return last >= 0 && std::min(first, last) > course_.farthest_before() &&
           question_.all_touch_between(first, last);
  }

  const Encounter<D>& encounter_;
  const TrajectoryFamily<D>& family_;
  std::uint64_t& looks_;
  SeparationCase<D> question_;
  SpreadOfChanges<D> spread_;
  PartingCourse<D> course_;
};

}  // namespace

template <int D>
ClearanceVerdict judge_bent_parting(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                    std::uint64_t& evaluations) {
  return BentParting<D>(encounter, family, evaluations).judgement();
}

template ClearanceVerdict judge_bent_parting<1>(const Encounter<1>&, const TrajectoryFamily<1>&,
                                                std::uint64_t&);
template ClearanceVerdict judge_bent_parting<2>(const Encounter<2>&, const TrajectoryFamily<2>&,
                                                std::uint64_t&);
template ClearanceVerdict judge_bent_parting<3>(const Encounter<3>&, const TrajectoryFamily<3>&,
                                                std::uint64_t&);

}  // namespace foresee
