#include "accuracy/engine.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "contact/certified/chord.h"
#include "contact/exact/exact_contact.h"
#include "contact/minkowski/contact_set.h"
#include "contact/oracle.h"
#include "contact/set/set_pair.h"

namespace foresee::bench {
namespace {

Setup setup_of(const Family& family) {
  return {family.a(), family.b(), family.horizon, PairRule(family.a().layout, family.b().layout)};
}

/// One pair in the contact module, one stage after another.
class Stages {
 public:
  explicit Stages(const Family& family) : setup_(setup_of(family)), set_(contact_set(setup_)) {}

  std::optional<ContactTimes> exact(std::size_t i) const {
    return exactly<std::optional<ContactTimes>>(i, exact_times);
  }

  void count(std::size_t i, StageShares& shares) {
    const PairLifetime lifetime = pair_lifetime_of(setup_, a(i), b(i));
    pieces_.load(set_, a(i), b(i));
    const SetPairContext<3, 2> context(
        {setup_, a(i), b(i), pieces_, pieces_, lifetime, any_time, true, steps_});
    const Chord<3> chord(context.relative, lifetime.dt_end);
    const Interval<double> near = chord.between(set_.hull().data(), static_cast<int>(set_.hull().size()),
                                                pieces_.lengths(), {lifetime.dt_start, lifetime.dt_end});
    const bool missed = near.begin > near.end;
    const Verdict verdict = SetPair<3, 2>(context, space_).touches();
    ++(missed ? shares.chord : verdict != Verdict::uncertain ? shares.certified : shares.exact);
    const bool hit =
        verdict == Verdict::uncertain ? exactly<bool>(i, exact_touches) : verdict == Verdict::yes;
    if (hit) ++shares.hits, ++time_stage(context, shares);
  }

 private:
  template <class Answer>
  Answer exactly(std::size_t i, Answer (*decide)(PiecePolynomials&, const ExactLifetime&)) const {
    PairPolynomials polynomials(setup_, a(i), b(i), {set_, a(i), b(i)});
    return decide(polynomials, exact_lifetime_of(setup_, a(i), b(i)));
  }

  /// The start of the contact, as UnionContact computes it.
  std::size_t& time_stage(const SetPairContext<3, 2>& context, StageShares& shares) {
    SetPair<3, 2> pair(context, space_);
    if (pair.first_contact().touches != Verdict::yes) return shares.exact_time;
    return pair.contact_by() <= context.lifetime.dt_start ? shares.at_once : shares.double_double;
  }

  const double* a(std::size_t i) const { return setup_.a.row(i); }
  const double* b(std::size_t i) const { return setup_.b.row(i); }

  Setup setup_;
  ContactSet set_;
  SetPieces pieces_;
  SetSpace space_;
  NeverInterrupt never_;
  Steps steps_{never_};
};

std::optional<ContactTimes> exact_answer(const Family& family, std::size_t i) {
  return Stages(family).exact(i);
}

Answer answer_of(const std::optional<ContactTimes>& times) {
  return times ? Answer{true, times->dt} : Answer{};
}

testing_by_hand::Object object_of(const Bodies& bodies, std::size_t i) {
  testing_by_hand::Object object;
  object.layout = bodies.layout;
  const double* row = bodies.row(i);
  const Offsets& at = bodies.at;
  object.t = row[at.t];
  for (int j = 0; j < 3; ++j) {
    object.x[j] = row[at.x + j], object.v[j] = row[at.v + j], object.a[j] = row[at.a + j];
    if (at.half != Offsets::absent) object.half[j] = row[at.half + j];
  }
  if (at.r != Offsets::absent) object.r = row[at.r];
  return object;
}

bool objects_to(const Family& family, std::size_t i, const std::optional<ContactTimes>& answer) {
  const testing_by_hand::Object a = object_of(family.a(), i), b = object_of(family.b(), i);
  oracle::Rule rule;
  for (int j = 0; j < 3; ++j) {
    rule.axes.push_back(oracle::relative_axis(a, b, j, family.horizon.now));
    rule.half.push_back({oracle::Exact(a.half[j]) + oracle::Exact(b.half[j])});
  }
  if (family.balls()) rule.round = {0, 1, 2};
  rule.radius = {oracle::Exact(a.r) + oracle::Exact(b.r)};
  return !oracle::judge(rule, a, b, family.horizon, answer).empty();
}

}  // namespace

Method filtered_engine(const Family& family) {
  const std::shared_ptr<Contact> contact =
      make_contact(family.a(), family.b(), {.horizon = family.horizon}, "a", "b");
  return {"filtered", "",
          [contact, pairs = std::vector<Pair>(), hits = std::vector<Pair>(),
           times = std::vector<ContactTimes>()](std::size_t first, std::size_t count, Answer* out) mutable {
            pairs.clear(), hits.clear(), times.clear();
            for (std::size_t i = first; i < first + count; ++i)
              pairs.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)});
            contact->first_contacts(pairs, TimesWanted::starts, hits, times);
            std::fill_n(out, count, Answer{});
            for (std::size_t k = 0; k < hits.size(); ++k) out[hits[k].a - first] = {true, times[k].dt};
          }};
}

Method exact_stage(const Family& family) {
  return one_by_one("exact-only", "",
                    [&family](std::size_t i) { return answer_of(exact_answer(family, i)); });
}

StageShares stage_shares(const Family& family) {
  StageShares shares;
  Stages stages(family);
  for (std::size_t i = 0; i < family.count; ++i) stages.count(i, shares);
  return shares;
}

Truth truth_of(const Family& family, std::size_t judged) {
  Truth truth;
  truth.judged = std::min(judged, family.count);
  for (std::size_t i = 0; i < family.count; ++i) {
    const std::optional<ContactTimes> answer = exact_answer(family, i);
    truth.answers.push_back(answer_of(answer));
    if (i < truth.judged) truth.complaints += objects_to(family, i, answer);
  }
  return truth;
}

}  // namespace foresee::bench
