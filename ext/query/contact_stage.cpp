#include "query/contact_stage.h"

#include <algorithm>

#include "query/join_question.h"

namespace foresee {

ContactStage::ContactStage(const JoinQuestion& question, Interrupt& interrupt)
    : question_(question), interrupt_(interrupt), contact_(contact_of(question)) {}

/// The exact arithmetic may take some ten microseconds a pair, so a batch is asked in slices that can be
/// interrupted.
template <class Work>
void ContactStage::in_slices(std::size_t count, Work work) {
  constexpr std::size_t slice = 256;
  for (std::size_t begin = 0; begin < count; begin += slice) {
    interrupt_.check();
    work(begin, std::min(slice, count - begin));
  }
}

void ContactStage::ask(std::vector<Pair>& candidates, const TimeSlab& slab, Hits& hits) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const bool all_times = slab.from == -inf && slab.before == inf && question_.asks_about_all_times();
  const bool times_matter = !all_times || question_.wants.contact || question_.order != JoinOrder::any;
  keep_asked_pairs(candidates);
  hits.clear();
  // Where some are left out or not reached, only the others need an end.
  hits.with_ends = all_times && question_.order == JoinOrder::any && question_.wants.ends;
  in_slices(candidates.size(), [&](std::size_t begin, std::size_t count) {
    const auto pairs = std::span(candidates).subspan(begin, count);
    if (times_matter)
      contact_->first_contacts(pairs, hits.with_ends ? TimesWanted::both : TimesWanted::begins, hits.pairs,
                               hits.times);
    else
      contact_->decide(pairs, hits.pairs);
  });
  hits.times.resize(hits.pairs.size());
  if (!all_times) keep_asked_times(slab, hits);
}

void ContactStage::keep_asked_pairs(std::vector<Pair>& candidates) const {
  const Scene& a = *question_.a;
  const Scene& b = question_.b ? *question_.b : a;
  const bool within_one = !question_.b;
  const bool one_table = within_one || question_.b == question_.a;
  const bool one_id = question_.only_a || question_.only_b;
  std::size_t kept = 0;
  for (Pair pair : candidates) {
    if (one_table && pair.a == pair.b) continue;
    if (within_one && a.ids[pair.a] > a.ids[pair.b]) {
      if (one_id) continue;  // the id asked for stands in the other column of this pair
      std::swap(pair.a, pair.b);
    }
    if (question_.only_a && a.ids[pair.a] != *question_.only_a) continue;
    if (question_.only_b && b.ids[pair.b] != *question_.only_b) continue;
    candidates[kept++] = pair;
  }
  candidates.resize(kept);
}

void ContactStage::keep_asked_times(const TimeSlab& slab, Hits& hits) const {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < hits.pairs.size(); ++i) {
    const ContactTimes& times = hits.times[i];
    if (!slab.holds(times.t) || !question_.asked_t.holds(times.t) || !question_.asked_dt.holds(times.dt))
      continue;
    hits.pairs[kept] = hits.pairs[i];
    hits.times[kept++] = times;
  }
  hits.pairs.resize(kept);
  hits.times.resize(kept);
}

void ContactStage::add_ends(Hits& hits) {
  without_ends_.swap(hits.pairs);
  hits.clear();
  in_slices(without_ends_.size(), [&](std::size_t begin, std::size_t count) {
    contact_->first_contacts(std::span(without_ends_).subspan(begin, count), TimesWanted::both, hits.pairs,
                             hits.times);
  });
}

void ContactStage::write(Hits& hits, std::vector<JoinRow>& rows) {
  const Scene& a = *question_.a;
  const Scene& b = question_.b ? *question_.b : a;
  if (question_.wants.contact && question_.wants.ends && !hits.with_ends) add_ends(hits);
  approaches_.resize(hits.pairs.size());
  if (question_.wants.approach)
    in_slices(hits.pairs.size(), [&](std::size_t begin, std::size_t count) {
      contact_->closest_approach(std::span(hits.pairs).subspan(begin, count),
                                 std::span(approaches_).subspan(begin, count));
    });
  rows.reserve(rows.size() + hits.pairs.size());
  for (std::size_t i = 0; i < hits.pairs.size(); ++i)
    rows.push_back({a.ids[hits.pairs[i].a], b.ids[hits.pairs[i].b], hits.times[i], approaches_[i]});
}

}  // namespace foresee
