#include "contact/sturm.h"

#include <algorithm>
#include <cmath>

namespace foresee::oracle {
namespace {

void trim(Integers& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// From this length on, common divisors are removed; below it the search costs more than it saves.
void divide_content(Integers& p) {
  if (p.empty() || msb(abs(p.back())) < 1500) return;
  Whole content = 0;
  for (const Whole& c : p) content = gcd(content, c);
  if (content > 1)
    for (Whole& c : p) c /= content;
}

/// A positive multiple of the remainder of a by b.
Integers remainder(Integers a, const Integers& b) {
  const Whole lead = abs(b.back());
  while (a.size() >= b.size()) {
    const Whole top = b.back() < 0 ? Whole(-a.back()) : a.back();
    const std::size_t shift = a.size() - b.size();
    for (Whole& c : a) c *= lead;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= b[i] * top;
    trim(a);
  }
  divide_content(a);
  return a;
}

/// p over a divisor of it, up to a factor.
Integers quotient(const Integers& p, const Integers& divisor) {
  Integers rest = p, quotient(p.size() - divisor.size() + 1);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    const Whole lead = divisor.back(), top = rest[k + divisor.size() - 1];
    for (Whole& c : rest) c *= lead;
    for (Whole& c : quotient) c *= lead;
    for (std::size_t i = 0; i < divisor.size(); ++i) rest[k + i] -= top * divisor[i];
    quotient[k] = top;
  }
  divide_content(quotient);
  return quotient;
}

void isolate(const Sturm& sturm, const Exact& low, const Exact& high, std::vector<TimePoint>& instants) {
  const int count = sturm.count(low, high);
  if (count == 0) return;
  if (count == 1) {
    instants.emplace_back(sturm, low, high);
    return;
  }
  const Exact mid = middle(low, high);
  isolate(sturm, low, mid, instants);
  isolate(sturm, mid, high, instants);
}

}  // namespace

Exact::Exact(double value) {
  if (value == 0) return;
  int exponent = 0;
  auto whole = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  for (; whole % 2 == 0; whole /= 2) ++exponent;
  n = whole, e = exponent;
}

Exact operator+(const Exact& a, const Exact& b) {
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  if (a.e >= b.e) return {(a.n << (a.e - b.e)) + b.n, b.e};
  return {a.n + (b.n << (b.e - a.e)), a.e};
}

Integers integers_of(const Coefficients& p) {
  int lowest = std::numeric_limits<int>::max();
  for (const Exact& c : p)
    if (c.sign() != 0) lowest = std::min(lowest, c.e);
  Integers result;
  for (const Exact& c : p) result.push_back(c.sign() == 0 ? Whole(0) : Whole(c.n << (c.e - lowest)));
  trim(result);
  return result;
}

Integers derivative(const Integers& p) {
  Integers d;
  for (std::size_t k = 1; k < p.size(); ++k) d.push_back(p[k] * k);
  return d;
}

Exact value_at(const Coefficients& p, const Exact& x) {
  Exact value;
  for (std::size_t k = p.size(); k-- > 0;) value = value * x + p[k];
  return value;
}

int sign_at(const Integers& p, const Exact& x) {
  // With x = n 2^e: sum of p[k] n^k 2^(e k), times 2^(-e degree) if e < 0.
  Whole value = 0;
  const int degree = static_cast<int>(p.size()) - 1;
  if (x.e >= 0) {
    const Whole n = x.n << x.e;
    for (int k = degree; k >= 0; --k) value = value * n + p[k];
  } else {
    for (int k = degree; k >= 0; --k) value = value * x.n + (p[k] << (-x.e * (degree - k)));
  }
  return value.sign();
}

Integers common_divisor(Integers a, Integers b) {
  while (!b.empty()) {
    Integers rest = remainder(a, b);
    a = std::move(b);
    b = std::move(rest);
  }
  return a;
}

Sturm::Sturm(Integers p) : polynomial_(std::move(p)) {
  build(polynomial_);
  if (chain_.back().size() > 1) build(quotient(chain_.front(), Integers(chain_.back())));
}

void Sturm::build(Integers p) {
  chain_.clear();
  Integers next = derivative(p);
  chain_.push_back(std::move(p));
  while (!next.empty()) {
    chain_.push_back(std::move(next));
    next = remainder(chain_[chain_.size() - 2], chain_.back());
    for (Whole& c : next) c = -c;
  }
}

int Sturm::variations(const Exact& x) const {
  int changes = 0, before = 0;
  for (const Integers& p : chain_) {
    const int sign = sign_at(p, x);
    if (sign != 0 && before != 0 && sign != before) ++changes;
    if (sign != 0) before = sign;
  }
  return changes;
}

void TimePoint::halve() {
  const Exact mid = middle(low, high);
  (compare(mid) > 0 ? low : high) = mid;
  if (high == mid) sign_high_ = sign_of(mid);
}

int TimePoint::compare(const Exact& x) const {
  if (x <= low) return 1;
  if (x > high) return -1;
  if (sign_high_ == 0) return x < high ? 1 : 0;
  const int sign = sign_of(x);
  return sign == 0 ? 0 : sign == sign_high_ ? -1 : 1;
}

int TimePoint::sign_of(const Sturm& p) {
  for (int round = 0; round < 6; ++round, halve())
    if (p.count(low, high) == 0) return sign_at(p.polynomial(), high);
  const Sturm common(common_divisor(sturm_->square_free(), p.square_free()));
  if (common.polynomial().size() > 1 && common.count(low, high) == 1) return 0;
  while (p.count(low, high) != 0) halve();
  return sign_at(p.polynomial(), high);
}

bool same_time(TimePoint& a, TimePoint& b) {
  auto apart = [&] { return std::min(a.high, b.high) <= std::max(a.low, b.low); };
  // Most are far apart, which few steps show; only then is a common root searched.
  for (int round = 0; round < 30; ++round, a.halve(), b.halve())
    if (apart()) return false;
  const Sturm common(common_divisor(a.sturm_->square_free(), b.sturm_->square_free()));
  for (; !apart(); a.halve(), b.halve())
    if (common.polynomial().size() > 1 && common.count(std::max(a.low, b.low), std::min(a.high, b.high)) == 1)
      return true;
  return false;
}

std::vector<TimePoint> times_between(const Sturm& sturm, const Exact& low, const Exact& high) {
  std::vector<TimePoint> instants;
  if (sturm.polynomial().size() > 1 && low < high) isolate(sturm, low, high, instants);
  return instants;
}

}  // namespace foresee::oracle
