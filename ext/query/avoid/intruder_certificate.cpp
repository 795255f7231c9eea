#include "query/avoid/intruder_certificate.h"

#include <algorithm>

#include "contact/growing/parting.h"

namespace foresee {
namespace {

/// How far, in shares of its distance from the middle, what turns by at most `degrees` comes: twice the sine
/// of half of it.
double chord_of(double degrees) {
  if (degrees >= 180) return 2;
  return 2 * (quick_sine_cosine(0.5 * degrees).sine * (1 + 0x1p-40) + 0x1p-1000);
}

}  // namespace

template <int D>
IntruderCertificate<D>::IntruderCertificate(const Encounter<D>& met, bool touches_first,
                                            std::shared_ptr<const OutlinePair> outlines)
    : met_(met),
      touches_first_(touches_first),
      stage_(outlines ? Stage::whole : Stage::simple),
      outlines_(std::move(outlines)),
      round_(met.extents.radius) {
  if (outlines_) met_.extents.radius += outlines_->reach() * (1 + 0x1p-50);
}

template <int D>
Judgement IntruderCertificate<D>::certify(const ChangedWays<D>& ways, double p, double q,
                                          std::uint64_t& looks) const {
  if (touches_first_) ++looks;
  if (stage_ == Stage::simple)
    return touches_first_ ? judge_parting<D>(met_, ways) : foresee::judge<D>(met_, ways, looks);
  if (has_parts())
    return foresee::judge<D>(turning_ ? encounter_between(p, q) : met_, ways, looks) == Judgement::clear
               ? Judgement::clear
               : Judgement::open;
  const Encounter<D> turned = turning_ ? encounter_between(p, q) : met_;
  if (!touches_first_) return foresee::judge<D>(turned, ways, looks);
  const bool surely_first = outlines_->is_sole() && !outlines_->turns();
  return surely_first ? judge_parting<D>(turned, ways) : judge_parting_of_piece<D>(turned, ways, looks);
}

template <int D>
Encounter<D> IntruderCertificate<D>::encounter_between(double p, double q) const {
  Encounter<D> met = met_;
  if (!turning_) return met;
  const double middle = p + 0.5 * (q - p), half = std::max(middle - p, q - middle);
  const double chord = half > 0 ? chord_of(half * (1 + 0x1p-50)) : 0;
  if (stage_ == Stage::boxes && chord > 0.5) return met;
  turning_->turn(middle);
  met.extents.sum = turning_.get(), met.extents.radius = round_;
  met.chord = chord, met.play = turning_->own_reach() * chord;
  return met;
}

template <int D>
bool IntruderCertificate<D>::is_worth_splitting(const ChangedWays<D>& ways) const {
  if (!has_parts()) return false;
  const double end = std::min(met_.end, ways.all.end);
  const Vec<D> apart = (ways.most[0] - ways.least[0]) +
                       end * ((ways.most[1] - ways.least[1]) + (0.5 * end) * (ways.most[2] - ways.least[2]));
  const double size = stage_ == Stage::boxes ? outlines_->size_of(part_) : 0;
  return touches_first_ || 4 * (size + 2 * met_.extents.after(end).radius) >= apart.maxCoeff();
}

template <int D>
std::vector<IntruderCertificate<D>> IntruderCertificate<D>::parts() const {
  std::vector<IntruderCertificate> parts;
  for (const OutlinePair::Part& part :
       stage_ == Stage::whole ? outlines_->parts() : outlines_->parts(part_)) {
    IntruderCertificate one = *this;
    one.stage_ = part.pieces ? Stage::pieces : Stage::boxes;
    one.part_ = part;
    one.sum_ = outlines_->sum_of(part);
    if (outlines_->turns()) one.turning_ = part.pieces ? one.sum_ : outlines_->turning_sum_of(part);
    one.met_.extents.sum = one.sum_.get();
    one.met_.extents.radius = round_ + outlines_->more_round(part) * (1 + 0x1p-50);
    parts.push_back(std::move(one));
  }
  return parts;
}

template <int D>
bool is_clear_of(const IntruderCertificate<D>& intruder, const ChangedWays<D>& ways, double k) {
  std::uint64_t looks = 0;
  const Judgement judgement = intruder.certify(ways, k, k, looks);
  if (judgement != Judgement::open || !intruder.has_parts()) return judgement == Judgement::clear;
  const std::vector<IntruderCertificate<D>> parts = intruder.parts();
  return std::all_of(parts.begin(), parts.end(),
                     [&](const IntruderCertificate<D>& part) { return is_clear_of<D>(part, ways, k); });
}

template class IntruderCertificate<1>;
template class IntruderCertificate<2>;
template class IntruderCertificate<3>;
template bool is_clear_of<1>(const IntruderCertificate<1>&, const ChangedWays<1>&, double);
template bool is_clear_of<2>(const IntruderCertificate<2>&, const ChangedWays<2>&, double);
template bool is_clear_of<3>(const IntruderCertificate<3>&, const ChangedWays<3>&, double);

}  // namespace foresee
