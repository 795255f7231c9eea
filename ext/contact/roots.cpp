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

/// |a| / |b| as a double that need not be accurate. Requires: both not zero.
double rough_ratio(const Dyadic& a, const Dyadic& b) {
  auto leading = [](const Dyadic& d) {
    return rounded(Dyadic(abs(d.mantissa()), d.exponent() - d.magnitude()));
  };
  const int shift = std::clamp(a.magnitude() - b.magnitude(), -1000, 1000);
  return std::ldexp(leading(a) / leading(b), shift);
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
  const double share = 1 / (1 + rough_ratio(at_high, at_low));
  const auto last = (std::int64_t{1} << digits) - 1;
  const auto place = std::clamp(static_cast<std::int64_t>(std::ldexp(share, digits)), std::int64_t{0}, last);
  const Dyadic left = low_ + cell * Dyadic(Integer(place), 0), right = left + cell;
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
  digits_ = caught ? std::min(2 * digits, 40) : std::max(digits / 2, 1);
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
  for (int round = 0;; ++round) {
    if (exact()) return sign_at(q, low_);
    const Descartes count = descartes(q, low_, high_);
    if (count.variations == 0) return count.first;
    if (round == 4) {
      // In doubt for long: a common root is a root of the common divisor, which divides p and so changes its
      // sign.
      const Polynomial common = common_divisor(*p_, q);
      if (common.degree > 0 && descartes(common, low_, high_).variations == 1) return 0;
    }
    narrow(round);
  }
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
