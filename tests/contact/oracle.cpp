#include "contact/oracle.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foresee::oracle {
namespace {

using Integers = std::vector<Whole>;

void trim(Integers& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Integers integers_of(const Coefficients& p) {
  Whole common = 1;
  for (const Rational& c : p) common = lcm(common, denominator(c));
  Integers result;
  for (const Rational& c : p) result.push_back(numerator(c) * (common / denominator(c)));
  trim(result);
  return result;
}

void divide_content(Integers& p) {
  Whole content = 0;
  for (const Whole& c : p) content = gcd(content, c);
  if (content > 1)
    for (Whole& c : p) c /= content;
}

/// A positive multiple of the remainder of a by b.
Integers remainder(Integers a, const Integers& b) {
  while (a.size() >= b.size()) {
    const Whole top = a.back(), lead = b.back();
    const std::size_t shift = a.size() - b.size();
    for (Whole& c : a) c *= abs(lead);
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= b[i] * top * (lead < 0 ? -1 : 1);
    trim(a);
  }
  divide_content(a);
  return a;
}

Integers derivative(const Integers& p) {
  Integers d;
  for (std::size_t k = 1; k < p.size(); ++k) d.push_back(p[k] * k);
  return d;
}

Integers common_divisor(Integers a, Integers b) {
  while (!b.empty()) {
    Integers rest = remainder(a, b);
    a = std::move(b);
    b = std::move(rest);
  }
  return a;
}

int sign_at(const Integers& p, const Rational& x) {
  const Whole n = numerator(x), d = denominator(x);
  Whole value = 0, power = 1;
  for (std::size_t k = p.size(); k-- > 0; power *= d) value = value * n + p[k] * power;
  return value.sign();
}

/// A polynomial and how many roots it has where.
class Sturm {
 public:
  explicit Sturm(Integers p) {
    divide_content(p);
    chain_.push_back(p);
    Integers next = foresee::oracle::derivative(p);
    while (!next.empty()) {
      divide_content(next);
      chain_.push_back(next);
      next = remainder(chain_[chain_.size() - 2], chain_.back());
      for (Whole& c : next) c = -c;
    }
  }
  const Integers& polynomial() const { return chain_.front(); }
  /// Distinct roots in (low, high]. Requires: neither end is a repeated root.
  int count(const Rational& low, const Rational& high) const { return variations(low) - variations(high); }
  /// The last of the chain: constant if there are no repeated roots.
  const Integers& last() const { return chain_.back(); }

 private:
  int variations(const Rational& x) const {
    int changes = 0, before = 0;
    for (const Integers& p : chain_) {
      const int sign = sign_at(p, x);
      if (sign != 0 && before != 0 && sign != before) ++changes;
      if (sign != 0) before = sign;
    }
    return changes;
  }
  std::vector<Integers> chain_;
};

/// p over its repeated part.
Integers square_free(const Integers& p) {
  const Integers repeated = common_divisor(p, derivative(p));
  if (repeated.size() <= 1) return p;
  Integers rest = p, quotient(p.size() - repeated.size() + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    const Whole lead = repeated.back(), top = rest[k + repeated.size() - 1];
    for (Whole& c : rest) c *= lead;
    for (Whole& c : quotient) c *= lead;
    for (std::size_t i = 0; i < repeated.size(); ++i) rest[k + i] -= top * repeated[i];
    quotient[k] = top;
  }
  divide_content(quotient);
  return quotient;
}

/// A moment at which polynomials change sign: the only root of `sturm` in (low, high].
struct Event {
  const Sturm* sturm;
  std::vector<int> zero_here;  ///< which polynomials vanish
  Rational low, high;

  void halve() {
    const Rational middle = (low + high) / 2;
    (sturm->count(low, middle) == 1 ? high : low) = middle;
  }
  /// -1, 0, 1: the event is before, at, after x.
  int compare(const Rational& x) const {
    if (x <= low) return 1;
    if (x > high) return -1;
    if (sturm->count(low, x) == 0) return 1;
    return sign_at(sturm->polynomial(), x) == 0 ? 0 : -1;
  }
};

void isolate(const Sturm& sturm, int source, const Rational& low, const Rational& high,
             std::vector<Event>& events) {
  const int count = sturm.count(low, high);
  if (count == 0) return;
  if (count == 1) {
    events.push_back({&sturm, {source}, low, high});
    return;
  }
  const Rational middle = (low + high) / 2;
  isolate(sturm, source, low, middle, events);
  isolate(sturm, source, middle, high, events);
}

/// True if both are the same moment; else narrows them until they are apart.
bool same_moment(Event& a, Event& b) {
  auto apart = [&] { return std::max(a.low, b.low) >= std::min(a.high, b.high); };
  // Most are far apart, which is soon seen; only then is a common root worth looking for.
  for (int round = 0; round < 30; ++round, a.halve(), b.halve())
    if (apart()) return false;
  const Sturm common(common_divisor(a.sturm->polynomial(), b.sturm->polynomial()));
  for (; !apart(); a.halve(), b.halve())
    if (common.polynomial().size() > 1 && common.count(std::max(a.low, b.low), std::min(a.high, b.high)) == 1)
      return true;
  return false;
}

struct Timeline {
  std::vector<Sturm> sturms;
  std::vector<Event> events;
};

void build(Timeline& line, const std::vector<Integers>& polynomials, const Rational& lo, const Rational& hi) {
  line.sturms.reserve(polynomials.size());
  for (std::size_t i = 0; i < polynomials.size() && lo < hi; ++i) {
    if (polynomials[i].size() < 2) continue;
    line.sturms.emplace_back(square_free(polynomials[i]));
    std::vector<Event> found;
    isolate(line.sturms.back(), static_cast<int>(i), lo, hi, found);
    for (Event& event : found) {
      bool known = false;
      for (Event& other : line.events)
        if (same_moment(event, other)) {
          other.zero_here.push_back(static_cast<int>(i));
          known = true;
          break;
        }
      if (!known) line.events.push_back(event);
    }
  }
  // Later narrowing keeps events apart that were told apart before.
  std::sort(line.events.begin(), line.events.end(),
            [](const Event& a, const Event& b) { return a.low < b.low; });
}

/// Is `value` the double nearest to the event (or the rational) plus offset, ties to even?
template <class Compare>
bool is_nearest(double value, Compare&& compare) {
  if (!(std::abs(value) < std::numeric_limits<double>::max())) return false;
  const double inf = std::numeric_limits<double>::infinity();
  const double below = std::nextafter(value, -inf), above = std::nextafter(value, inf);
  const Rational at(value);
  const int low = compare((at + Rational(below)) / 2), high = compare((at + Rational(above)) / 2);
  const bool even = std::bit_cast<std::uint64_t>(value) % 2 == 0;
  return (low > 0 || (low == 0 && even)) && (high < 0 || (high == 0 && even));
}

/// Around a point there is only one region.
Rule ball_rule(const std::vector<Coefficients>& axes, const std::vector<Rational>& half,
               const std::vector<int>& round, const Rational& radius) {
  Rule rule;
  std::vector<bool> is_round(axes.size());
  Coefficients sum(5);
  sum[0] = -radius * radius;
  for (int j : round) {
    is_round[j] = true;
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) sum[k + l] += axes[j][k] * axes[j][l];
  }
  rule.polynomials.push_back(sum);
  for (std::size_t j = 0; j < axes.size(); ++j) {
    if (is_round[j]) continue;
    Coefficients high = axes[j], low = axes[j];
    high[0] -= half[j];
    for (Rational& c : low) c = -c;
    low[0] -= half[j];
    rule.polynomials.push_back(high);
    rule.polynomials.push_back(low);
  }
  rule.holds = [](const std::vector<int>& signs) {
    return std::all_of(signs.begin(), signs.end(), [](int sign) { return sign <= 0; });
  };
  return rule;
}

}  // namespace

Coefficients relative_axis(const testing_pairs::Object& a, const testing_pairs::Object& b, int axis,
                           double now) {
  auto absolute = [axis, now](const testing_pairs::Object& o) -> Coefficients {
    const Rational s = Rational(now) - Rational(o.layout.has_t ? o.t : 0), x(o.x[axis]);
    const Rational v(o.layout.law == Law::rest ? 0 : o.v[axis]);
    const Rational acceleration(o.layout.law < Law::accelerated ? 0 : o.a[axis]);
    return {x + v * s + acceleration * s * s / 2, v + acceleration * s, acceleration / 2};
  };
  Coefficients pa = absolute(a), pb = absolute(b);
  for (int k = 0; k < 3; ++k) pb[k] -= pa[k];
  return pb;
}

Rule distance_rule(const std::vector<Coefficients>& axes, const std::vector<Rational>& half,
                   const std::vector<int>& round, const Rational& radius) {
  if (std::all_of(round.begin(), round.end(), [&](int j) { return half[j] == 0; }))
    return ball_rule(axes, half, round, radius);
  Rule rule;
  const int n = static_cast<int>(axes.size());
  for (int j = 0; j < n; ++j)
    for (int side : {-1, 1}) {  // 2j: x + half, 2j + 1: x - half
      Coefficients p = axes[j];
      p[0] -= side * half[j];
      rule.polynomials.push_back(p);
    }
  // One polynomial for each region around the box: a digit for every round axis, 0 inside, 1 below, 2 above.
  int regions = 1;
  for (std::size_t i = 0; i < round.size(); ++i) regions *= 3;
  const int first_region = 2 * n;
  for (int region = 0; region < regions; ++region) {
    Coefficients sum(5);
    sum[0] = -radius * radius;
    int digits = region;
    for (int j : round) {
      const int where = digits % 3;
      digits /= 3;
      if (where == 0) continue;
      const Coefficients& p = rule.polynomials[2 * j + (where == 1 ? 0 : 1)];
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum[k + l] += p[k] * p[l];
    }
    rule.polynomials.push_back(sum);
  }
  rule.holds = [n, round, first_region](const std::vector<int>& signs) {
    std::vector<bool> is_round(n);
    for (int j : round) is_round[j] = true;
    for (int j = 0; j < n; ++j)
      if (!is_round[j] && (signs[2 * j] < 0 || signs[2 * j + 1] > 0)) return false;
    int region = 0, weight = 1;
    for (int j : round) {
      if (signs[2 * j] < 0) region += weight;
      if (signs[2 * j + 1] > 0) region += 2 * weight;
      weight *= 3;
    }
    return signs[first_region + region] <= 0;
  };
  return rule;
}

std::string judge(const Rule& rule, const testing_pairs::Object& a, const testing_pairs::Object& b,
                  const Horizon& horizon, const std::optional<ContactTimes>& answer) {
  const double inf = std::numeric_limits<double>::infinity();
  const Rational now(horizon.now);
  Rational lo = 0, hi(horizon.h);
  for (const auto* o : {&a, &b}) {
    lo = std::max(lo, Rational(Rational(o->layout.has_t ? o->t : 0) - now));
    if (o->layout.has_until && o->until != inf) hi = std::min(hi, Rational(Rational(o->until) - now));
  }
  if (lo > hi) return answer ? "a contact of objects that never exist together" : "";

  std::vector<Integers> polynomials;
  for (const Coefficients& p : rule.polynomials) polynomials.push_back(integers_of(p));
  Timeline line;
  build(line, polynomials, lo, hi);
  auto holds_at = [&](const Rational& x) {
    std::vector<int> signs;
    for (const Integers& p : polynomials) signs.push_back(sign_at(p, x));
    return rule.holds(signs);
  };
  // The walk: begin and end are an event's number, -1 for lo, -2 for hi.
  constexpr int at_lo = -1, at_hi = -2, nowhere = -3;
  int begin = nowhere, end = nowhere;
  if (holds_at(lo)) begin = end = at_lo;
  Rational reached = lo;
  const int count = static_cast<int>(line.events.size());
  bool over = false;
  for (int i = 0; i <= count && !over && lo < hi; ++i) {
    Rational next = hi;
    if (i < count) {
      while (!(line.events[i].low > reached)) line.events[i].halve();
      next = line.events[i].low;
    } else if (!(reached < hi)) {
      break;
    }
    const Rational sample = (reached + next) / 2;
    const bool in_gap = holds_at(sample);
    over = begin != nowhere && !in_gap;
    if (over) break;
    if (i == count) {
      if (in_gap || holds_at(hi)) {
        if (begin == nowhere) begin = at_hi;
        end = at_hi;
      }
      break;
    }
    std::vector<int> signs;
    for (const Integers& p : polynomials) signs.push_back(sign_at(p, sample));
    for (int zero : line.events[i].zero_here) signs[zero] = 0;
    if (rule.holds(signs)) {
      if (begin == nowhere) begin = i;
      end = i;
    }
    if (line.events[i].compare(hi) < 0)
      while (line.events[i].high == hi) line.events[i].halve();
    reached = line.events[i].high;
  }
  if (begin == nowhere) return answer ? "an invented contact" : "";
  if (!answer) return "a missed contact";

  auto check = [&](int where, double value, const Rational& offset) {
    return is_nearest(value, [&](const Rational& tie) {
      const Rational x = tie - offset;
      if (where == at_lo) return Rational(lo - x).sign();
      if (where == at_hi) return Rational(hi - x).sign();
      return line.events[where].compare(x);
    });
  };
  if (!check(begin, answer->dt, 0)) return "dt is not the nearest double";
  if (!check(end, answer->dt_end, 0)) return "dt_end is not the nearest double";
  if (!check(begin, answer->t, now)) return "t is not the nearest double";
  if (!check(end, answer->t_end, now)) return "t_end is not the nearest double";
  return "";
}

}  // namespace foresee::oracle
