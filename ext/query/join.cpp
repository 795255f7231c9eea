#include "query/join.h"

#include <algorithm>
#include <string>
#include <utility>

#include "motion/float_environment.h"
#include "query/join_candidates.h"
#include "query/join_question.h"

namespace foresee {

JoinMethod join_method(std::string_view name) {
  if (name == "auto") return JoinMethod::automatic;
  if (name == "grid") return JoinMethod::grid;
  if (name == "tree") return JoinMethod::tree;
  if (name == "scan") return JoinMethod::scan;
  if (name == "gpcd") return JoinMethod::gpcd;
  throw Error("method must be 'auto', 'grid', 'tree', 'scan' or 'gpcd', not '" + std::string(name) + "'");
}

const char* name_of(JoinMethod method) {
  switch (method) {
    case JoinMethod::automatic:
      return "auto";
    case JoinMethod::grid:
      return "grid";
    case JoinMethod::tree:
      return "tree";
    case JoinMethod::scan:
      return "scan";
    case JoinMethod::gpcd:
      return "gpcd";
  }
  return "";
}

Join::Join(JoinQuestion question, Interrupt& interrupt)
    : question_((check_question(question), std::move(question))),
      interrupt_(interrupt),
      contact_(contact_of(question_)),
      candidates_(join_candidates(question_, contact_->reach(), interrupt)) {
  // Which pairs touch at once is only known from their times.
  if (question_.skip_touching) question_.wants.contact = true;
}

Join::~Join() {
  candidates_.reset();
  if (question_.space) question_.space->trim();
}

/// The exact stage may take some ten microseconds a pair, so a batch is asked in slices that can be
/// interrupted.
template <class Work>
void Join::in_slices(std::size_t count, Work work) {
  constexpr std::size_t slice = 256;
  for (std::size_t begin = 0; begin < count; begin += slice) {
    interrupt_.check();
    work(begin, std::min(slice, count - begin));
  }
}

std::span<const JoinRow> Join::next() {
  const FloatEnvironment environment;
  rows_.clear();
  while (rows_.empty()) {
    interrupt_.check();
    pairs_.clear();
    if (!candidates_->next(pairs_)) break;
    keep_asked_pairs();
    find_hits();
    make_rows();
  }
  return rows_;
}

void Join::keep_asked_pairs() {
  const Scene& a = *question_.a;
  const Scene& b = question_.b ? *question_.b : a;
  const bool within_one = !question_.b;
  const bool one_table = within_one || question_.b == question_.a;
  const bool one_id = question_.only_a || question_.only_b;
  std::size_t kept = 0;
  for (Pair pair : pairs_) {
    if (one_table && pair.a == pair.b) continue;
    if (within_one && a.ids[pair.a] > a.ids[pair.b]) {
      if (one_id) continue;  // the id asked for stands in the other column of this pair
      std::swap(pair.a, pair.b);
    }
    if (question_.only_a && a.ids[pair.a] != *question_.only_a) continue;
    if (question_.only_b && b.ids[pair.b] != *question_.only_b) continue;
    pairs_[kept++] = pair;
  }
  pairs_.resize(kept);
}

void Join::find_hits() {
  const TimesWanted wanted = question_.wants.ends ? TimesWanted::both : TimesWanted::begins;
  hits_.clear(), times_.clear();
  in_slices(pairs_.size(), [&](std::size_t begin, std::size_t count) {
    const auto pairs = std::span(pairs_).subspan(begin, count);
    if (question_.wants.contact)
      contact_->first_contacts(pairs, wanted, hits_, times_);
    else
      contact_->decide(pairs, hits_);
  });
  times_.resize(hits_.size());
}

void Join::make_rows() {
  const Scene& a = *question_.a;
  const Scene& b = question_.b ? *question_.b : a;
  approaches_.resize(hits_.size());
  if (question_.wants.approach)
    in_slices(hits_.size(), [&](std::size_t begin, std::size_t count) {
      contact_->closest_approach(std::span(hits_).subspan(begin, count),
                                 std::span(approaches_).subspan(begin, count));
    });
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (question_.skip_touching && !(times_[i].dt > 0)) continue;
    rows_.push_back({a.ids[hits_[i].a], b.ids[hits_[i].b], times_[i], approaches_[i]});
  }
}

}  // namespace foresee
