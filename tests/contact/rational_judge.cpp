#include "contact/rational_judge.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foresee::oracle {
namespace {

bool starts_before(const SlopeSign& s, const SlopeSign& t) {
  return s.begin < t.begin;
}

/// A little more than half an ulp before or after, where another double would be the nearest.
Rational beside(double time, int side) {
  const double next = std::nextafter(time, side * HUGE_VAL);
  return Rational(time) + (Rational(next) - Rational(time)) * Rational(513, 1024);
}

using Touch = std::function<bool(const Rational&)>;

/// Two contacts may be less than an ulp apart: the first ends at a double beside which the second holds.
bool ends_within_half_an_ulp(const Touch& touch, double end) {
  const Rational half_an_ulp = beside(end, 1) - Rational(end);
  for (int i = -64; i < 64; ++i)
    if (!touch(Rational(end) + half_an_ulp * i / 64)) return true;
  return false;
}

}  // namespace

std::optional<SlopeSign> first_of(std::vector<SlopeSign> contacts) {
  if (contacts.empty()) return {};
  std::sort(contacts.begin(), contacts.end(), starts_before);
  SlopeSign first = contacts[0];
  for (const SlopeSign& s : contacts)
    if (s.begin <= first.end && first.end < s.end) first.end = s.end;
  return first;
}

std::vector<SlopeSign> gaps_between(std::vector<SlopeSign> contacts, const SlopeSign& queried) {
  std::sort(contacts.begin(), contacts.end(), starts_before);
  std::vector<SlopeSign> gaps;
  Rational reached = queried.begin;
  for (const SlopeSign& s : contacts) {
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

SlopeSign Encounter::queried() const {
  const Rational now(question.horizon.now);
  SlopeSign queried{0, Rational(question.horizon.h)};
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

std::string compared(const std::optional<SlopeSign>& exact, const std::optional<ContactTimes>& answer,
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
    if (time < begin && touch(time)) return answer ? "begins earlier" : "missed";
    if (begin < time && time < end && !touch(time)) return "ends earlier";
  }
  if (!answer) return {};
  // Between neighbours there is no moment of which rounding leaves no doubt.
  const bool has_inside = std::nextafter(begin, end) < end;
  if (begin > 0 && touch(beside(begin, -1))) return "begins earlier by an ulp";
  if (has_inside && !touch(beside(begin, 1))) return "begins later";
  if (end < h && touch(beside(end, 1)) && !ends_within_half_an_ulp(touch, end)) return "ends later";
  if (has_inside && !touch(beside(end, -1))) return "ends earlier by an ulp";
  return {};
}

}  // namespace foresee::oracle
