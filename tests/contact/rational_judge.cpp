#include "contact/rational_judge.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foresee::oracle {
namespace {

bool starts_before(const RationalInterval& s, const RationalInterval& t) {
  return s.begin < t.begin;
}

/// A little more than half an ulp before or after, where another double is the nearest.
Rational beside(double time, int side) {
  const double next = std::nextafter(time, side * HUGE_VAL);
  return Rational(time) + (Rational(next) - Rational(time)) * Rational(513, 1024);
}

using Touch = std::function<bool(const Rational&)>;

/// Two contacts may be less than an ulp apart: then the second holds beside the double at which the first
/// ends.
bool ends_within_half_an_ulp(const Touch& touch, double end) {
  const Rational half_an_ulp = beside(end, 1) - Rational(end);
  for (int i = -64; i < 64; ++i)
    if (!touch(Rational(end) + half_an_ulp * i / 64)) return true;
  return false;
}

}  // namespace

std::optional<RationalInterval> first_of(std::vector<RationalInterval> contacts) {
  if (contacts.empty()) return {};
  std::sort(contacts.begin(), contacts.end(), starts_before);
  RationalInterval first = contacts[0];
  for (const RationalInterval& s : contacts)
    if (s.begin <= first.end && first.end < s.end) first.end = s.end;
  return first;
}

std::vector<RationalInterval> gaps_between(std::vector<RationalInterval> contacts,
                                           const RationalInterval& queried) {
  std::sort(contacts.begin(), contacts.end(), starts_before);
  std::vector<RationalInterval> gaps;
  Rational reached = queried.begin;
  for (const RationalInterval& s : contacts) {
    if (reached < s.begin) gaps.push_back({reached, s.begin});
    reached = std::max(reached, s.end);
  }
  if (reached < queried.end || contacts.empty()) gaps.push_back({reached, queried.end});
  return gaps;
}

bool is_rounded(double value, const Rational& exact) {
  const double inf = std::numeric_limits<double>::infinity();
  const Rational here(value);
  const Rational low = (here + Rational(std::nextafter(value, -inf))) / 2;
  const Rational high = (here + Rational(std::nextafter(value, inf))) / 2;
  const bool even = std::bit_cast<std::uint64_t>(value) % 2 == 0;
  return even ? low <= exact && exact <= high : low < exact && exact < high;
}

RationalInterval Encounter::queried() const {
  const Rational now(question.horizon.now);
  RationalInterval queried{0, Rational(question.horizon.h)};
  for (const auto* o : {&a, &b}) {
    queried.begin = std::max<Rational>(queried.begin, Rational(o->t) - now);
    if (std::isfinite(o->until)) queried.end = std::min<Rational>(queried.end, Rational(o->until) - now);
  }
  return queried;
}

Rational Encounter::place(int axis, const Rational& time) const {
  const auto at = [&](const testing_by_hand::Object& o) -> Rational {
    const Rational s = time + Rational(question.horizon.now) - Rational(o.t);
    return Rational(o.x[axis]) + s * (Rational(o.v[axis]) + s * Rational(o.a[axis]) / 2);
  };
  return at(b) - at(a);
}

Rational Encounter::velocity(int axis) const {
  return Rational(b.v[axis]) - Rational(a.v[axis]);
}

Rational Encounter::radius(const Rational& time) const {
  Rational radius(question.within);
  for (const auto* o : {&a, &b}) {
    radius += Rational(o->r);
    const Rational age = time + Rational(question.horizon.now) - Rational(o->t);
    if (o->layout.has_growth) radius += age * Rational(o->growth);
  }
  return radius;
}

std::string compared(const std::optional<RationalInterval>& exact, const std::optional<ContactTimes>& answer,
                     double now) {
  if (exact.has_value() != answer.has_value()) return exact ? "missed" : "invented";
  if (!exact) return {};
  if (!is_rounded(answer->dt, exact->begin)) return "wrong dt";
  if (!is_rounded(answer->t, exact->begin + Rational(now))) return "wrong t";
  if (!is_rounded(answer->dt_end, exact->end)) return "wrong dt_end";
  if (!is_rounded(answer->t_end, exact->end + Rational(now))) return "wrong t_end";
  return {};
}

std::string judged_by_times(const std::function<bool(const Rational&)>& touch, double h,
                            const std::optional<ContactTimes>& answer) {
  const double begin = answer ? answer->dt : 2 * h, end = answer ? answer->dt_end : 2 * h;
  for (int i = 0; i <= 16; ++i) {
    const double time = h * i / 16;
    if (time < begin && touch(time)) return answer ? "starts earlier" : "missed";
    if (begin < time && time < end && !touch(time)) return "ends earlier";
  }
  if (!answer) return {};
  // Between neighbouring doubles rounding decides no time.
  const bool has_inside = std::nextafter(begin, end) < end;
  if (begin > 0 && touch(beside(begin, -1))) return "starts earlier by an ulp";
  if (has_inside && !touch(beside(begin, 1))) return "starts later";
  if (end < h && touch(beside(end, 1)) && !ends_within_half_an_ulp(touch, end)) return "ends later";
  if (has_inside && !touch(beside(end, -1))) return "ends earlier by an ulp";
  return {};
}

}  // namespace foresee::oracle
