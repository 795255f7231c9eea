#include "contact/outline_contact.h"

#include <algorithm>
#include <optional>

#include "base/float_environment.h"
#include "contact/closest_approach.h"
#include "contact/exact/exact_contact.h"
#include "contact/outline/critical_pieces.h"
#include "contact/outline/outline_pair.h"
#include "contact/outline/window_near.h"
#include "contact/typed_contact.h"

namespace foresee::contact {
namespace {

/// What the row of a table looks like.
void take(ObjectPieces& pieces, const Bodies& bodies, const OutlineRows* outlines, std::size_t i) {
  const ConvexPieces* const known = outlines ? outlines->pieces(i) : nullptr;
  if (known) return pieces.take(*known);
  const double* const row = bodies.row(i);
  const Offsets& at = bodies.at;
  if (!outlines && at.bounds != Offsets::absent) {
    const double* const bounds = row + at.bounds;
    return pieces.take_box({Vec<2>(bounds[0], bounds[1]), Vec<2>(bounds[2], bounds[3])});
  }
  if (at.half == Offsets::absent) return pieces.take_point();
  pieces.take_box(row[at.half], row[at.half + 1]);
}

template <int D, int Degree>
class OutlineContact final : public Contact {
 public:
  OutlineContact(const Setup& setup, const OutlineTables& outlines) : setup_(setup), outlines_(outlines) {}

  Reach reach() const override { return {setup_.within, setup_.within_z}; }
  void heed(Interrupt& interrupt) override { steps_.emplace(interrupt); }

  std::string effort() const override {
    return a_pair(pieces_) + " pieces, " + a_pair(steps_->taken()) + " node tests and " +
           a_pair(space_.tests) + " leaf tests a pair";
  }

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
    Staged staged(setup_, row_a, row_b, a_, b_, moments, false, space_, *steps_);
    const Verdict touches = staged.touches();
    if (touches != Verdict::uncertain) return touches == Verdict::yes;
    return exactly_touches(row_a, row_b, staged);
  }

  std::optional<ContactTimes> first_contact(const Pair& pair, TimesWanted wanted) {
    const double *const row_a = setup_.a.row(pair.a), *const row_b = setup_.b.row(pair.b);
    const Moments moments = moments_of(setup_, row_a, row_b);
    if (moments.none) return {};
    take_pieces(pair);
    Staged staged(setup_, row_a, row_b, a_, b_, moments, true, space_, *steps_);
    Instant begin;
    const Verdict touches = staged.first_contact(begin);
    if (touches == Verdict::no) return {};
    if (touches == Verdict::uncertain) {
      const auto exact = exact_contact(row_a, row_b, staged, -Stay::inf, staged.met_by());
      if (!exact || exact->dt_end < Stay::inf) return exact;
      begin = {exact->dt, exact->t};
    }
    const Instant end = wanted == TimesWanted::both ? staged.end_of_contact() : begin;
    if (end.known()) return ContactTimes{begin.t, end.t, begin.dt, end.dt};
    const auto exact = exact_contact(row_a, row_b, staged, staged.last_certain_moment());
    return ContactTimes{begin.t, exact.value().t_end, begin.dt, exact.value().dt_end};
  }

  void take_pieces(const Pair& pair) {
    if (setup_.window && !outlines_.a)
      a_.take_box(window_near(setup_, setup_.b.row(pair.b)));
    else
      take(a_, setup_.a, outlines_.a, pair.a);
    take(b_, setup_.b, outlines_.b, pair.b);
    ++pairs_, pieces_ += a_.count() + b_.count();
    if (a_.is_point() && b_.is_point()) a_.take_box(0, 0);  // a sum needs edges
  }

  /// To one decimal.
  std::string a_pair(std::uint64_t all) const {
    const std::uint64_t tenths = pairs_ == 0 ? 0 : (10 * all + pairs_ / 2) / pairs_;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }

  /// Some pieces at a time.
  [[gnu::noinline]] bool exactly_touches(const double* row_a, const double* row_b, Staged& staged) {
    constexpr std::size_t at_a_time = 1024;
    const ExactMoments asked = exact_moments_of(setup_, row_a, row_b);
    std::vector<PiecePair> pairs;
    const auto met = [&] {
      return !pairs.empty() && exactly<bool>(row_a, row_b, asked, staged, pairs, exact_touches);
    };
    bool touches = false;
    staged.possible_pairs({-Stay::inf, Stay::inf}, [&](const PiecePair& pair) {
      pairs.push_back(pair);
      if (pairs.size() < at_a_time) return true;
      touches = met();
      pairs.clear();
      return !touches;
    });
    return touches || met();
  }

  /// The first contact that ends at `from` or later, exactly. `from` is before all contact, or within one,
  /// whose begin then is `from`. Of a contact that lasts until `met_by`, when they touch, the end is
  /// infinite.
  [[gnu::noinline]] std::optional<ContactTimes> exact_contact(const double* row_a, const double* row_b,
                                                              Staged& staged, double from,
                                                              double met_by = Stay::inf) {
    const ExactMoments asked = exact_moments_of(setup_, row_a, row_b);
    if (from == -Stay::inf) from = staged.first_possible(from);
    for (; from < Stay::inf; from = staged.first_possible(from)) {
      if (asked.end < Dyadic(from)) break;
      const double until = met_by < Stay::inf ? met_by : staged.possible_until(from);
      ExactMoments moments = asked;
      begin_at(moments, from);
      if (end_at(moments, until) && until == met_by)
        moments.rounded.dt_end = moments.rounded.t_end = Stay::inf;
      std::vector<PiecePair> pairs;
      staged.possible_pairs({from, until}, [&pairs](const PiecePair& pair) {
        pairs.push_back(pair);
        return true;
      });
      const auto times =
          exactly<std::optional<ContactTimes>>(row_a, row_b, moments, staged, pairs, exact_times);
      if (times) return times;
      from = until;
    }
    return {};
  }

  /// Nothing before `from` is asked about: the pieces may touch again, but others before.
  static void begin_at(ExactMoments& moments, double from) {
    const Dyadic begin(from);
    if (!(moments.begin < begin)) return;
    moments.begin = begin;
    moments.rounded.dt_begin = from, moments.rounded.t_begin = rounded(begin + moments.now);
  }
  /// Nor after `until`. Whether anything was.
  static bool end_at(ExactMoments& moments, double until) {
    const Dyadic end(until);
    if (!(end < moments.end)) return false;
    moments.end = end;
    moments.rounded.dt_end = until, moments.rounded.t_end = rounded(end + moments.now);
    return true;
  }

  /// The exact stage's answer about these pieces.
  template <class Answer>
  Answer exactly(const double* row_a, const double* row_b, const ExactMoments& moments, const Staged& staged,
                 std::span<const PiecePair> pairs, Answer (*ask)(PairPolynomials&, const ExactMoments&)) {
    const ContactSet set = critical_pieces(setup_, a_, b_, pairs, staged.is_grown());
    PairPolynomials polynomials(set, setup_, row_a, row_b);
    return ask(polynomials, moments);
  }

  const Setup setup_;
  const OutlineTables outlines_;
  ObjectPieces a_, b_;
  PieceSpace space_;
  NeverInterrupt never_;
  std::optional<Steps> steps_{never_};
  std::uint64_t pairs_ = 0, pieces_ = 0;  ///< that were asked about, and what they have together
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
