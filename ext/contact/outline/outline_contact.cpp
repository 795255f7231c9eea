#include "contact/outline_contact.h"

#include <algorithm>

#include "base/float_environment.h"
#include "contact/closest_approach.h"
#include "contact/exact/exact_contact.h"
#include "contact/outline/critical_pieces.h"
#include "contact/outline/outline_pair.h"
#include "contact/typed_contact.h"

namespace foresee::contact {
namespace {

/// What the row of a table looks like.
void take(ObjectPieces& pieces, const Bodies& bodies, const OutlineRows* outlines, std::size_t i) {
  const ConvexPieces* const known = outlines ? outlines->pieces(i) : nullptr;
  if (known) return pieces.take(*known);
  if (bodies.at.half == Offsets::absent) return pieces.take_point();
  const double* const half = bodies.row(i) + bodies.at.half;
  pieces.take_box(half[0], half[1]);
}

template <int D, int Degree>
class OutlineContact final : public Contact {
 public:
  OutlineContact(const Setup& setup, const OutlineTables& outlines) : setup_(setup), outlines_(outlines) {}

  Reach reach() const override { return {setup_.within, setup_.within_z}; }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    for (const Pair& pair : pairs)
      if (touches(pair)) hits.push_back(pair);
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    for (const Pair& pair : pairs) {
      const auto found = first_contact(pair, wanted);
      if (!found) continue;
      hits.push_back(pair);
      times.push_back(*found);
    }
  }

  void closest_approach(std::span<const Pair> hits, std::span<ClosestApproach> out) override {
    const FloatEnvironment environment;
    for (std::size_t i = 0; i < hits.size(); ++i)
      out[i] = closest_approach_of<D>(setup_, setup_.a.row(hits[i].a), setup_.b.row(hits[i].b));
  }

 private:
  using Staged = OutlinePair<D, Degree>;

  bool touches(const Pair& pair) {
    const double *const row_a = setup_.a.row(pair.a), *const row_b = setup_.b.row(pair.b);
    const Moments moments = moments_of(setup_, row_a, row_b);
    if (moments.none) return false;
    take_pieces(pair);
    Staged staged(setup_, row_a, row_b, a_, b_, moments, false, space_);
    const Verdict touches = staged.touches();
    if (touches != Verdict::uncertain) return touches == Verdict::yes;
    return exactly<bool>(row_a, row_b, exact_moments_of(setup_, row_a, row_b), staged,
                         {-Stay::inf, Stay::inf}, exact_touches);
  }

  std::optional<ContactTimes> first_contact(const Pair& pair, TimesWanted wanted) {
    const double *const row_a = setup_.a.row(pair.a), *const row_b = setup_.b.row(pair.b);
    const Moments moments = moments_of(setup_, row_a, row_b);
    if (moments.none) return {};
    take_pieces(pair);
    Staged staged(setup_, row_a, row_b, a_, b_, moments, true, space_);
    Instant begin;
    const Verdict touches = staged.first_contact(begin);
    if (touches == Verdict::no) return {};
    if (touches == Verdict::uncertain) return exact_contact(row_a, row_b, staged, -Stay::inf);
    const Instant end = wanted == TimesWanted::both ? staged.end_of_contact() : begin;
    if (end.known()) return ContactTimes{begin.t, end.t, begin.dt, end.dt};
    const auto exact = exact_contact(row_a, row_b, staged, staged.last_certain_moment());
    return ContactTimes{begin.t, exact->t_end, begin.dt, exact->dt_end};
  }

  void take_pieces(const Pair& pair) {
    take(a_, setup_.a, outlines_.a, pair.a);
    take(b_, setup_.b, outlines_.b, pair.b);
    if (a_.is_point() && b_.is_point()) a_.take_box(0, 0);  // a sum needs edges
  }

  /// The first contact that ends at `from` or later, exactly. `from` is before all contact, or within one,
  /// whose begin then is `from`.
  std::optional<ContactTimes> exact_contact(const double* row_a, const double* row_b, Staged& staged,
                                            double from) {
    const ExactMoments asked = exact_moments_of(setup_, row_a, row_b);
    if (from == -Stay::inf) from = staged.first_possible(from);
    for (; from < Stay::inf; from = staged.first_possible(from)) {
      if (asked.end < Dyadic(from)) break;
      const double until = staged.possible_until(from);
      const auto times = exactly<std::optional<ContactTimes>>(row_a, row_b, between(asked, from, until),
                                                              staged, {from, until}, exact_times);
      if (times) return times;
      from = until;
    }
    return {};
  }

  /// Nothing before `from` or after `until` is asked about: the pieces may touch again, but others before.
  static ExactMoments between(ExactMoments moments, double from, double until) {
    const Dyadic begin(from), end(until);
    if (moments.begin < begin) {
      moments.begin = begin;
      moments.rounded.dt_begin = from, moments.rounded.t_begin = rounded(begin + moments.now);
    }
    if (end < moments.end) {
      moments.end = end;
      moments.rounded.dt_end = until, moments.rounded.t_end = rounded(end + moments.now);
    }
    return moments;
  }

  /// The exact stage's answer about the pieces that may touch within the period.
  template <class Answer>
  [[gnu::noinline]] Answer exactly(const double* row_a, const double* row_b, const ExactMoments& moments,
                                   Staged& staged, const Period<double>& period,
                                   Answer (*ask)(PairPolynomials&, const ExactMoments&)) {
    std::vector<PiecePair> pairs;
    for (const PieceStay& stay : staged.tests().all())
      if (stay.begin.low <= period.end && stay.end.high >= period.begin)
        pairs.push_back(staged.tests().pair_of(stay));
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    const ContactSet set = critical_pieces(setup_, a_, b_, pairs);
    PairPolynomials polynomials(set, setup_, row_a, row_b);
    return ask(polynomials, moments);
  }

  const Setup setup_;
  const OutlineTables outlines_;
  ObjectPieces a_, b_;
  PieceSpace space_;
};

}  // namespace

std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree) {
  if (setup.a.layout.axes < 3) {
    if (degree < 2) return std::make_unique<OutlineContact<2, 1>>(setup, outlines);
    return std::make_unique<OutlineContact<2, 2>>(setup, outlines);
  }
  if (degree < 2) return std::make_unique<OutlineContact<3, 1>>(setup, outlines);
  return std::make_unique<OutlineContact<3, 2>>(setup, outlines);
}

}  // namespace foresee::contact
