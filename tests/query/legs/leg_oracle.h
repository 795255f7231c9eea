// The oracle of movers with legs: their contacts in rational numbers, for boxes on two axes.
//
// It shares no code with the engine. The times at which two legs touch are rational where they are straight, and for
// bent legs whose discriminants are squares; others are refused. Ends are rounded by a search among all doubles.
#pragma once

#include <algorithm>
#include <optional>
#include <tuple>
#include <vector>

#include "motion/plan/plan.h"
#include "numbers/rationals.h"
#include "query/legs/meeting.h"

namespace foresee::leg_oracle {

using judge::Rational;

struct Span {
  Rational begin, end;
};
using Spans = std::vector<Span>;

inline std::optional<Rational> root_of_square(const Rational& square) {
  const judge::Whole top = sqrt(numerator(square)), bottom = sqrt(denominator(square));
  if (top * top != numerator(square) || bottom * bottom != denominator(square)) return std::nullopt;
  return Rational(top, bottom);
}

inline Spans common(const Spans& a, const Spans& b) {
  Spans both;
  for (const Span& one : a)
    for (const Span& other : b) {
      const Span meet{std::max(one.begin, other.begin), std::min(one.end, other.end)};
      if (meet.begin <= meet.end) both.push_back(meet);
    }
  return both;
}

/// When x + v s + a s^2 <= 0 within `life`; nothing if a time is not rational.
inline std::optional<Spans> spans_below(const Rational& x, const Rational& v, const Rational& a,
                                        const Span& life) {
  if (a == 0) {
    if (v == 0) return x <= 0 ? Spans{life} : Spans{};
    const Rational root = -x / v;
    return common({life}, {v > 0 ? Span{life.begin, root} : Span{root, life.end}});
  }
  const Rational discriminant = v * v - 4 * a * x;
  if (discriminant < 0) return a < 0 ? Spans{life} : Spans{};
  const auto root = root_of_square(discriminant);
  if (!root) return std::nullopt;
  const Rational one = (-v - *root) / (2 * a), other = (-v + *root) / (2 * a);
  const Rational first = std::min(one, other), last = std::max(one, other);
  if (a > 0) return common({life}, {{first, last}});
  if (first == last) return Spans{life};
  return common({life}, {{life.begin, first}, {last, life.end}});
}

/// When two legs touch, as time in absolute numbers: |b - a| <= reach on both axes. Nothing if a time is not rational.
inline std::optional<Spans> contacts_of_legs(const Leg& a, const Leg& b, double now, double h, double reach) {
  const auto r = [](double number) { return judge::rational(number); };
  Span life{std::max({r(now), r(a.t), r(b.t)}), r(now) + r(h)};
  for (const Leg* leg : {&a, &b})
    if (leg->until != no_end) life.end = std::min(life.end, r(leg->until));
  if (life.begin > life.end) return Spans{};
  Spans spans{life};
  for (std::size_t j = 0; j < 2; ++j) {
    Rational x = 0, v = 0, acceleration = 0;  // by powers of the absolute time
    for (const auto& [leg, sign] : {std::pair(&b, 1), std::pair(&a, -1)}) {
      const Rational t = r(leg->t), half = r(leg->a[j]) / 2;
      x += sign * (r(leg->x[j]) - r(leg->v[j]) * t + half * t * t);
      v += sign * (r(leg->v[j]) - 2 * half * t);
      acceleration += sign * half;
    }
    const auto above = spans_below(x - r(reach), v, acceleration, life);
    const auto below = spans_below(-x - r(reach), -v, -acceleration, life);
    if (!above || !below) return std::nullopt;
    spans = common(spans, common(*above, *below));
  }
  return spans;
}

/// The union of closed spans, in order.
inline Spans union_of(Spans spans) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
  Spans joined;
  for (const Span& span : spans) {
    if (joined.empty() || joined.back().end < span.begin)
      joined.push_back(span);
    else
      joined.back().end = std::max(joined.back().end, span.end);
  }
  return joined;
}

/// A contact of the oracle, with the pairs of legs that take part.
struct LegsInContact {
  std::vector<std::pair<std::size_t, std::size_t>> legs;
  ContactTimes times;
};

/// Rule 3 by the letter: joins two contacts of different pairs of legs that meet, until no two do. Nothing if a
/// time is not rational.
inline std::optional<std::vector<ContactTimes>> oracle_of(const Meeting& meeting, Spans* all) {
  std::vector<std::vector<LegsInContact>> groups;
  for (std::size_t i = 0; i < meeting.a.size(); ++i)
    for (std::size_t k = 0; k < meeting.b.size(); ++k) {
      const auto spans = contacts_of_legs(meeting.a[i], meeting.b[k], meeting.now, meeting.h, meeting.reach);
      if (!spans) return std::nullopt;
      for (const Span& span : union_of(*spans)) {
        const Rational now = judge::rational(meeting.now);
        groups.push_back(
            {{{{i, k}},
              {judge::nearest_double(span.begin), judge::nearest_double(span.end),
               judge::nearest_double(span.begin - now), judge::nearest_double(span.end - now)}}});
        all->push_back(span);
      }
    }
  const auto meet = [](const LegsInContact& one, const LegsInContact& other) {
    return one.legs != other.legs && one.times.t <= other.times.t_end && other.times.t <= one.times.t_end;
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < groups.size() && !more; ++i)
      for (std::size_t k = i + 1; k < groups.size() && !more; ++k)
        for (const LegsInContact& one : groups[i])
          for (const LegsInContact& other : groups[k]) more = more || meet(one, other);
    if (!more) break;
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t k = i + 1; k < groups.size();) {
        const bool joined = std::any_of(groups[i].begin(), groups[i].end(), [&](const LegsInContact& one) {
          return std::any_of(groups[k].begin(), groups[k].end(),
                             [&](const LegsInContact& other) { return meet(one, other); });
        });
        if (!joined) {
          ++k;
          continue;
        }
        groups[i].insert(groups[i].end(), groups[k].begin(), groups[k].end());
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(k));
      }
  }
  std::vector<ContactTimes> contacts;
  for (const auto& group : groups) {
    ContactTimes whole = group.front().times;
    for (const LegsInContact& one : group) {
      whole.t = std::min(whole.t, one.times.t), whole.dt = std::min(whole.dt, one.times.dt);
      whole.t_end = std::max(whole.t_end, one.times.t_end),
      whole.dt_end = std::max(whole.dt_end, one.times.dt_end);
    }
    contacts.push_back(whole);
  }
  std::sort(contacts.begin(), contacts.end(), [](const ContactTimes& a, const ContactTimes& b) {
    return std::tie(a.t, a.t_end, a.dt, a.dt_end) < std::tie(b.t, b.t_end, b.dt, b.dt_end);
  });
  return contacts;
}

}  // namespace foresee::leg_oracle
