#include "contact/roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foresee {
namespace {

/// A dyadic strictly between: the middle, or the middle of the exponents where the two are far apart.
/// Requires: 0 <= low < high.
Dyadic between(const Dyadic& low, const Dyadic& high, int round) {
  if (low.sign() == 0) return high.scaled(-(1 << std::min(round, 12)));
  const int least = low.magnitude(), most = high.magnitude();
  if (most - least >= 2) return Dyadic::power_of_two(least + (most - least + 1) / 2);
  return half_of(low + high);
}

/// The dyadic with the fewest bits strictly between: roots of numbers that people write are often such.
/// Requires: 0 <= low < high.
Dyadic simplest_between(const Dyadic& low, const Dyadic& high) {
  const int unit = (high - low).magnitude() - 2;
  const auto whole = [unit](const Dyadic& x) {
    const int shift = x.exponent() - unit;
    return Integer(shift >= 0 ? Integer(x.mantissa() << shift) : Integer(x.mantissa() >> -shift));
  };
  // The greatest multiple of a power of two in (below, last]: where their leading bits part.
  const Integer below = whole(low);
  Integer last = whole(high);
  if (Dyadic(last, unit) == high) --last;
  const auto part = msb(Integer(below ^ last));
  return {Integer((last >> part) << part), unit};
}

/// |a| / (|a| + |b|) in units of 2^-digits, about. Requires: not both zero.
Integer share_of(const Dyadic& a, const Dyadic& b, int digits) {
  const auto size = [](const Dyadic& d) { return Dyadic(abs(d.mantissa()), d.exponent()); };
  const Dyadic part = size(a), whole = part + size(b);
  const int unit = whole.magnitude() - digits - 32;
  const auto in_units = [unit](const Dyadic& d) {
    const int shift = d.exponent() - unit;
    return Integer(shift >= 0 ? Integer(d.mantissa() << shift) : Integer(d.mantissa() >> -shift));
  };
  return (in_units(part) << digits) / in_units(whole);
}

/// Bits of the longest coefficient.
unsigned longest(const Polynomial& p) {
  unsigned most = 0;
  for (const Integer& c : p.c)
    if (!c.is_zero()) most = std::max(most, static_cast<unsigned>(msb(abs(c))) + 1);
  return most;
}

/// Splits until every interval holds one root or none; gives up (false) after `budget` splits.
bool isolate(const Polynomial& p, const Dyadic& low, const Dyadic& high, int round, int& budget,
             std::vector<Root>& roots) {
  const Descartes count = descartes(p, low, high);
  if (count.variations == 0) return true;
  if (count.variations == 1) {
    roots.emplace_back(p, low, high, count.first);
    return true;
  }
  if (--budget < 0) return false;
  const Dyadic middle = between(low, high, round);
  if (!isolate(p, low, middle, round + 1, budget, roots)) return false;
  if (sign_at(p, middle) == 0) roots.emplace_back(p, middle, middle, 0);
  return isolate(p, middle, high, round + 1, budget, roots);
}

}  // namespace

std::vector<Root> roots_between(const Polynomial& p, const Dyadic& low, const Dyadic& high,
                                Polynomial& square_free_part) {
  std::vector<Root> roots;
  if (p.degree < 1 || !(low < high)) return roots;
  // Most polynomials have no repeated root: try without making sure.
  int budget = 16;
  square_free_part = p;
  if (isolate(square_free_part, low, high, 0, budget, roots)) return roots;
  roots.clear();
  budget = std::numeric_limits<int>::max();
  square_free_part = square_free(p);
  isolate(square_free_part, low, high, 0, budget, roots);
  return roots;
}

void Root::look_at(const Dyadic& x) {
  const int sign = sign_at(*p_, x);
  if (sign == 0)
    low_ = high_ = x;
  else if (sign == sign_low_)
    low_ = x;
  else
    high_ = x;
}

void Root::refine() {
  if (exact()) return;
  const Dyadic at_low = value_at(*p_, low_), at_high = value_at(*p_, high_);
  const bool wide = low_.sign() == 0 || high_.magnitude() - low_.magnitude() >= 2;
  if (wide || at_low.sign() == 0 || at_high.sign() == 0) {
    look_at(between(low_, high_, looks_++));
    return;
  }
  // Where a straight line would cross, on a grid of 2^digits cells: look at the two ends of that cell.
  const int digits = digits_;
  const Dyadic cell = (high_ - low_).scaled(-digits);
  const Integer last = (Integer(1) << digits) - 1;
  const Integer place = std::min(share_of(at_low, at_high, digits), last);
  const Dyadic left = low_ + cell * Dyadic(place, 0), right = left + cell;
  bool hit_left = place == 0, hit_right = place == last;
  if (!hit_left) {
    look_at(left);
    hit_left = exact() || low_ == left;
  }
  if (hit_left && !hit_right && !exact()) {
    look_at(right);
    hit_right = exact() || high_ == right;
  }
  const bool caught = hit_left && hit_right;
  digits_ = caught ? std::min(2 * digits, 2048) : std::max(digits / 2, 1);
  if (!caught && !exact() && digits <= 2) look_at(half_of(low_ + high_));
}

void Root::narrow(int round) {
  if (round == 1 || round == 3)
    look_at(simplest_between(low_, high_));
  else
    refine();
}

int Root::sign_of(const Polynomial& q) {
  if (q.degree < 0) return 0;
  // The common divisor of long numbers costs more than to narrow far.
  const bool few_digits = std::max(longest(*p_), longest(q)) < 1000;
  for (int round = 0;; ++round) {
    if (exact()) return sign_at(q, low_);
    const Descartes count = descartes(q, low_, high_);
    if (count.variations == 0) return count.first;
    if (round == (few_digits ? 4 : 10)) {
      // In doubt for long: a common root is a root of the common divisor, which divides p and so has none or
      // this one here. The parity of the variations tells.
      const Polynomial common = common_divisor(*p_, q);
      if (common.degree > 0 && descartes(common, low_, high_).variations % 2 == 1) return 0;
    }
    narrow(round);
  }
}

int Root::compare(const Dyadic& x) {
  if (exact()) return (low_ - x).sign();
  if (x <= low_) return 1;
  if (high_ <= x) return -1;
  look_at(x);
  return exact() ? 0 : low_ == x ? 1 : -1;
}

double Root::rounded_with(const Dyadic& offset) {
  for (int round = 0;; ++round) {
    const double least = rounded(low_ + offset), most = rounded(high_ + offset);
    if (least == most) return least;
    if (std::nextafter(least, most) == most) {
      // Infinity stands for 2^1024, as rounding has it.
      const Dyadic above = std::isfinite(most) ? Dyadic(most) : Dyadic::power_of_two(1024);
      const Dyadic tie = half_of(Dyadic(least) + above), place = tie - offset;
      if (place <= low_) return most;
      if (high_ <= place) return least;
      look_at(place);
      if (exact()) return rounded(tie);
      return low_ == place ? most : least;
    }
    narrow(round);
  }
}

}  // namespace foresee
