// The intervals on which a polynomial is at most 0, against its exact sign at its roots and between them.
#include "numbers/time_intervals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "numbers/factors.h"
#include "numbers/rationals.h"

namespace foresee {
namespace {

using namespace judge;

/// A queried interval of two numbers.
struct Span {
  Dyadic low, high;
  AlgebraicRoot begin{low}, end{high};

  Span(const Dyadic& low, const Dyadic& high) : low(low), high(high) {}
  Span(const Span&) = delete;
  QueriedInterval queried() { return {begin, end}; }
};

bool contains(const TimeInterval& interval, const Dyadic& x) {
  return compare(*interval.first, x) <= 0 && compare(*interval.last, x) >= 0;
}
bool contains(const TimeIntervals& intervals, const Dyadic& x) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const TimeInterval& i) { return contains(i, x); });
}

/// In order, apart, and within the span.
void expect_ordered(const TimeIntervals& intervals, Span& span) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    EXPECT_LE(compare(*intervals[i].first, *intervals[i].last), 0);
    EXPECT_GE(compare(*intervals[i].first, span.low), 0);
    EXPECT_LE(compare(*intervals[i].last, span.high), 0);
    if (i > 0) {
      EXPECT_LT(compare(*intervals[i - 1].last, *intervals[i].first), 0);
    }
  }
}

/// Multiples of a step within a span.
std::vector<Dyadic> samples(const Span& span, double step) {
  std::vector<Dyadic> all;
  for (Dyadic x = span.low; x <= span.high; x = x + Dyadic(step)) all.push_back(x);
  return all;
}

constexpr double lattice = 0.5, fine = 0.125;

Dyadic on_lattice(Inputs& inputs, int lower, int upper) {
  return Dyadic(lattice * inputs.between(lower, upper));
}

/// Of degree 0 to 4 with roots on the lattice, single ones and double ones, and without any.
Polynomial with_lattice_roots(Inputs& inputs) {
  Polynomial p = polynomial({inputs.number(-3, 3)});
  const int degree = inputs.between(0, 4);
  while (p.degree < degree) {
    const Polynomial factor = with_root(on_lattice(inputs, -2, 14));
    if (p.degree + 2 <= degree && inputs.one_in(3))
      p = multiplied(p, inputs.one_in(2) ? multiplied(factor, factor) : polynomial({17, -4, 1}));
    else
      p = multiplied(p, factor);
  }
  return p;
}

/// Whole coefficients: the roots are anything.
Polynomial with_any_roots(Inputs& inputs) {
  Polynomial p;
  for (int k = inputs.between(0, 4); k >= 0; --k)
    p.c[static_cast<std::size_t>(k)] = Dyadic(inputs.between(-30, 30));
  return Polynomial(p.c);
}

/// Ends on the lattice too, so that roots are at them, and now and then one time alone.
Span drawn_span(Inputs& inputs) {
  const Dyadic low = on_lattice(inputs, 0, 6);
  return {low, low + on_lattice(inputs, 0, 10)};
}

int drawn_digits(Inputs& inputs) {
  return inputs.one_in(2) ? 0 : inputs.between(8, 60);
}

void expect_inside(const TimeIntervals& intervals, const Polynomial& p, const Span& span) {
  for (const Dyadic& x : samples(span, fine)) EXPECT_EQ(contains(intervals, x), sign_at(p, x) <= 0);
}

TEST(TimeIntervals, InsideIsWhereThePolynomialIsAtMostZero) {
  Inputs inputs(1);
  for (int i = 0; i < cases(1000); ++i) {
    const bool exact_roots = inputs.one_in(2);
    ExactSource p(exact_roots ? with_lattice_roots(inputs) : with_any_roots(inputs), drawn_digits(inputs));
    Span span = drawn_span(inputs);
    const TimeIntervals intervals = sublevel_intervals(p.lazy(), span.queried());
    expect_ordered(intervals, span);
    expect_inside(intervals, p.polynomial(), span);
    if (!exact_roots) continue;
    // As many as the samples show: all roots and a time between any two of them are among these.
    std::size_t runs = 0;
    bool before = false;
    for (const Dyadic& x : samples(span, fine)) {
      const bool now = sign_at(p.polynomial(), x) <= 0;
      runs += now && !before, before = now;
    }
    EXPECT_EQ(intervals.size(), runs);
  }
}

/// Where a polynomial touches 0 from above, and where from below.
TEST(TimeIntervals, TouchingIsInside) {
  for (const Polynomial& factor : {polynomial({1}), polynomial({1, 1}), polynomial({17, -4, 1})}) {
    const Polynomial touching =
        multiplied(multiplied(with_root(Dyadic(3.0)), with_root(Dyadic(3.0))), factor);
    Span span(Dyadic(1.0), Dyadic(5.0));
    ExactSource above(touching), below(negated(touching));
    const TimeIntervals once = sublevel_intervals(above.lazy(), span.queried()),
                        all = sublevel_intervals(below.lazy(), span.queried());
    ASSERT_EQ(once.size(), 1u);
    EXPECT_EQ(once[0].first, once[0].last);
    EXPECT_EQ(compare(*once[0].first, Dyadic(3.0)), 0);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].first, &span.begin);
    EXPECT_EQ(all[0].last, &span.end);
    EXPECT_TRUE(complement(all, span.queried()).empty());
    EXPECT_EQ(complement(once, span.queried()).size(), 2u);
  }
}

/// A minimum of 2^-300 below 0 gives an interval, one of 2^-300 above 0 does not.
TEST(TimeIntervals, TouchingDiffersFromAlmostTouching) {
  const Dyadic little = Dyadic::power_of_two(-300);
  for (const int factor_degree : {0, 1, 2})
    for (const int side : {-1, 0, 1}) {
      const Dyadic bottom = side < 0 ? -little : side > 0 ? little : Dyadic();
      const Polynomial dip({Dyadic(9.0) + bottom, Dyadic(-6.0), Dyadic(1.0), Dyadic(), Dyadic()});
      const Polynomial factors[] = {polynomial({1}), polynomial({1, 1}), polynomial({17, -4, 1})};
      ExactSource p(multiplied(dip, factors[factor_degree]), 50);
      Span span(Dyadic(), Dyadic(5.0));
      const TimeIntervals intervals = sublevel_intervals(p.lazy(), span.queried());
      ASSERT_EQ(intervals.size(), side > 0 ? 0u : 1u) << factor_degree << ' ' << side;
      if (side > 0) continue;
      EXPECT_EQ(compare(*intervals[0].first, *intervals[0].last), side < 0 ? -1 : 0);
      EXPECT_TRUE(contains(intervals, Dyadic(3.0)));
    }
}

TEST(TimeIntervals, ConstantsAreInsideAlwaysOrNever) {
  Span span(Dyadic(1.0), Dyadic(2.0));
  for (const double c : {-1.0, 0.0, 5e-324}) {
    ExactSource p(polynomial({c}));
    EXPECT_EQ(sublevel_intervals(p.lazy(), span.queried()).size(), c > 0 ? 0u : 1u);
  }
}

TEST(TimeIntervals, ZerosAreThoseStrictlyWithinInOrder) {
  Inputs inputs(2);
  for (int i = 0; i < cases(500); ++i) {
    ExactSource p(with_lattice_roots(inputs), drawn_digits(inputs));
    Span span = drawn_span(inputs);
    const Roots zeros = zeros_within(p.lazy(), span.queried());
    int next = 0;
    for (const Dyadic& x : samples(span, fine)) {
      if (x == span.low || x == span.high || p.polynomial().degree < 1 || sign_at(p.polynomial(), x) != 0)
        continue;
      ASSERT_LT(next, zeros.count);
      EXPECT_EQ(compare(*zeros.list[static_cast<std::size_t>(next++)], x), 0);
    }
    EXPECT_EQ(next, zeros.count);
  }
}

/// What is outside p is inside -p, but for the times at which p only touches 0 from below.
TEST(TimeIntervals, OutsideIsTheRestWithSharedEnds) {
  Inputs inputs(3);
  for (int i = 0; i < cases(500); ++i) {
    ExactSource p(with_lattice_roots(inputs), drawn_digits(inputs));
    Span span = drawn_span(inputs);
    const TimeIntervals in = sublevel_intervals(p.lazy(), span.queried()),
                        out = complement(in, span.queried());
    for (const Dyadic& x : samples(span, fine)) {
      const int sign = sign_at(p.polynomial(), x);
      EXPECT_TRUE(contains(in, x) || contains(out, x));
      if (sign != 0) {
        EXPECT_EQ(contains(out, x), sign > 0);
      }
    }
    for (const TimeInterval& gap : out) {
      const bool at_end = compare(*gap.last, span.low) == 0 || compare(*gap.first, span.high) == 0;
      EXPECT_LE(compare(*gap.first, *gap.last), at_end ? 0 : -1);
    }
  }
}

TEST(TimeIntervals, CommonIsWhatIsInBoth) {
  Inputs inputs(4);
  for (int i = 0; i < cases(500); ++i) {
    ExactSource p(with_lattice_roots(inputs), drawn_digits(inputs)),
        q(with_lattice_roots(inputs), drawn_digits(inputs));
    Span span = drawn_span(inputs);
    const TimeIntervals a = sublevel_intervals(p.lazy(), span.queried()),
                        b = sublevel_intervals(q.lazy(), span.queried());
    const TimeIntervals both = common(a, b), exchanged = common(b, a);
    expect_ordered(both, span);
    EXPECT_EQ(both.size(), exchanged.size());
    for (const Dyadic& x : samples(span, fine)) {
      EXPECT_EQ(contains(both, x), contains(a, x) && contains(b, x));
      EXPECT_EQ(contains(exchanged, x), contains(both, x));
    }
    EXPECT_EQ(common(a, a).size(), a.size());
    EXPECT_TRUE(common(a, {}).empty());
  }
}

/// Ends between which a root lies 2^-600 from one of them.
TEST(TimeIntervals, RootsNextToTheEndsAreFound) {
  const Dyadic little = Dyadic::power_of_two(-600);
  for (const Polynomial& factor :
       {polynomial({1}), polynomial({1, 1}), polynomial({17, -4, 1}), polynomial({1, 1, 1, 1})})
    for (const int side : {-1, 1}) {
      const Dyadic root(2.0), end = side < 0 ? root - little : root + little;
      const Polynomial p = multiplied(with_root(root), factor);
      ExactSource rises(p, 50), falls(negated(p), 50);
      Span until(Dyadic(), end), from(end, Dyadic(4.0));
      EXPECT_EQ(sublevel_intervals(rises.lazy(), until.queried()).size(), 1u);
      EXPECT_EQ(sublevel_intervals(rises.lazy(), from.queried()).size(), side < 0 ? 1u : 0u);
      ExactSource again(negated(p), 50);
      EXPECT_EQ(sublevel_intervals(falls.lazy(), from.queried()).size(), 1u);
      EXPECT_EQ(sublevel_intervals(again.lazy(), until.queried()).size(), side < 0 ? 0u : 1u);
    }
}

}  // namespace
}  // namespace foresee
