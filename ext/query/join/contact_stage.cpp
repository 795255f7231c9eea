#include "query/join/contact_stage.h"

#include <algorithm>

#include "query/distinct_contacts.h"

namespace foresee {

ContactStage::ContactStage(const JoinQuestion& question, std::shared_ptr<Contact> contact,
                           Interrupt& interrupt)
    : question_(question), interrupt_(interrupt), contact_(std::move(contact)) {
  contact_->set_interrupt(interrupt);
}

// Exact arithmetic may take tens of microseconds per pair, so a batch is decided in slices that can be
// interrupted.
template <class Work>
void ContactStage::in_slices(std::size_t count, Work work) {
  constexpr std::size_t slice = 256;
  for (std::size_t begin = 0; begin < count; begin += slice) {
    interrupt_.check();
    work(begin, std::min(slice, count - begin));
  }
}

void ContactStage::find_hits(std::vector<Pair>& batch, BatchProof proof, const TimeSlab& slab, Hits& hits) {
  if (question_.all_contacts) return find_all_contacts(batch, slab, hits);
  const bool all_times = slab.holds_all() && question_.queries_all_times();
  const bool times_matter = !all_times || question_.wants.contact || question_.order != JoinOrder::any;
  const std::size_t before = hits.pairs.size();
  // Hits may still be dropped, if another slab or the queried times decide, or may never be read, if they are sorted.
  // Then write_rows() computes the ends of the others only. Of legs, pairs that have a row are not tested again
  // (movers/leg_join.h), so that few are dropped.
  const bool ends_now =
      (all_times || has_plans(question_)) && question_.order == JoinOrder::any && question_.wants.ends;
  hits.with_ends = ends_now;
  if (proof == BatchProof::touch_at_start) {
    if (!queries_start(slab)) return;  // no contact of the batch starts at another time
    if (!ends_now) return add_touching(batch, hits);
  }
  keep_queried_pairs(batch);
  in_slices(batch.size(), [&](std::size_t begin, std::size_t count) {
    const auto pairs = std::span(batch).subspan(begin, count);
    if (times_matter)
      contact_->first_contacts(pairs, ends_now ? TimesWanted::both : TimesWanted::starts, hits.pairs,
                               hits.times);
    else
      contact_->decide(pairs, hits.pairs);
  });
  hits.times.resize(hits.pairs.size());
  if (!all_times) keep_queried_times(slab, before, hits);
}

void ContactStage::find_all_contacts(std::vector<Pair>& batch, const TimeSlab& slab, Hits& hits) {
  const std::size_t before = hits.pairs.size();
  hits.with_ends = true;
  keep_queried_pairs(batch);
  in_slices(batch.size(), [&](std::size_t begin, std::size_t count) {
    contact_->all_contacts(std::span(batch).subspan(begin, count), hits.pairs, hits.times);
  });
  join_equal_contacts(before, hits.pairs, hits.times);
  keep_queried_times(slab, before, hits);
}

bool ContactStage::queries_start(const TimeSlab& slab) const {
  const double now = question_.now;
  return slab.horizon.now == now && slab.holds(now) && question_.queried_t.holds(now) &&
         question_.queried_dt.holds(0);
}

void ContactStage::add_touching(std::vector<Pair>& batch, Hits& hits) const {
  const double now = question_.now;
  keep_queried_pairs(batch);
  hits.pairs.insert(hits.pairs.end(), batch.begin(), batch.end());
  hits.times.resize(hits.pairs.size(), {now, now, 0, 0});
}

namespace {

/// Drops pairs of legs of one object. Without a branch, which would be mispredicted.
void drop_equal_ids(const std::vector<std::int64_t>& ids, std::vector<Pair>& pairs) {
  std::size_t kept = 0;
  for (const Pair pair : pairs) {
    pairs[kept] = pair;
    kept += ids[pair.a] != ids[pair.b];
  }
  pairs.resize(kept);
}

/// Puts the smaller id of each pair first. Without a branch, which would be mispredicted.
void order_by_id(const std::vector<std::int64_t>& ids, std::vector<Pair>& pairs) {
  for (Pair& pair : pairs) {
    const std::uint32_t a = pair.a, b = pair.b;
    const bool ordered = ids[a] < ids[b];
    pair = {ordered ? a : b, ordered ? b : a};
  }
}

}  // namespace

void ContactStage::keep_queried_pairs(std::vector<Pair>& batch) const {
  const Scene& a = *question_.a;
  const Scene& b = question_.side_b();
  if (question_.b == question_.a) std::erase_if(batch, [](Pair pair) { return pair.a == pair.b; });
  const bool ids_repeat = a.layout.has_plan && a.first_rows.size() != a.size() + 1;
  if (ids_repeat && &a == &b) drop_equal_ids(a.ids, batch);
  if (!question_.only_a && !question_.only_b) {
    if (!question_.b) order_by_id(a.ids, batch);
    return;
  }
  // Within one scene the requested id may stand in the other column; that pair belongs to another query.
  std::erase_if(batch, [&](Pair pair) {
    return (!question_.b && a.ids[pair.a] >= b.ids[pair.b]) ||
           (question_.only_a && a.ids[pair.a] != *question_.only_a) ||
           (question_.only_b && b.ids[pair.b] != *question_.only_b);
  });
}

void ContactStage::keep_queried_times(const TimeSlab& slab, std::size_t first, Hits& hits) const {
  std::size_t kept = first;
  for (std::size_t i = first; i < hits.pairs.size(); ++i) {
    const ContactTimes& times = hits.times[i];
    if (!slab.holds(times.t) || !question_.queried_t.holds(times.t) || !question_.queried_dt.holds(times.dt))
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

void ContactStage::add_all_ends(Hits& hits) {
  std::swap(without_all_ends_, hits);
  hits.clear();
  hits.with_ends = true;
  Hits all;
  in_slices(without_all_ends_.pairs.size(), [&](std::size_t begin, std::size_t count) {
    for (std::size_t i = begin; i < begin + count; ++i) {
      all.clear();
      contact_->all_contacts({&without_all_ends_.pairs[i], 1}, all.pairs, all.times);
      join_equal_contacts(0, all.pairs, all.times);
      for (const ContactTimes& times : all.times) {
        if (times.t != without_all_ends_.times[i].t || times.dt != without_all_ends_.times[i].dt) continue;
        hits.pairs.push_back(without_all_ends_.pairs[i]);
        hits.times.push_back(times);
      }
    }
  });
}

void ContactStage::write_rows(Hits& hits, std::vector<JoinRow>& rows) {
  const Scene& a = *question_.a;
  const Scene& b = question_.side_b();
  if (question_.all_contacts && !hits.with_ends) add_all_ends(hits);
  if (question_.wants.contact && question_.wants.ends && !hits.with_ends) add_ends(hits);
  if (question_.wants.approach) {
    approaches_.resize(hits.pairs.size());
    in_slices(hits.pairs.size(), [&](std::size_t begin, std::size_t count) {
      contact_->closest_approach(std::span(hits.pairs).subspan(begin, count),
                                 std::span(approaches_).subspan(begin, count));
    });
  }
  const std::size_t before = rows.size();
  rows.resize(before + hits.pairs.size());
  for (std::size_t i = 0; i < hits.pairs.size(); ++i) {
    JoinRow& row = rows[before + i];
    row.a = a.ids[hits.pairs[i].a], row.b = b.ids[hits.pairs[i].b];
    row.contact = hits.times[i];
    if (question_.wants.approach) row.approach = approaches_[i];
  }
}

bool ContactStage::would_only_write(BatchProof proof) const {
  const bool all_pairs = !question_.only_a && !question_.only_b && question_.b != question_.a;
  const bool no_more_wanted = !question_.wants.ends && !question_.wants.approach;
  return proof == BatchProof::touch_at_start && all_pairs && no_more_wanted && !question_.all_contacts;
}

void ContactStage::find_and_write(std::vector<Pair>& batch, BatchProof proof, const TimeSlab& slab,
                                  std::vector<JoinRow>& rows) {
  if (would_only_write(proof)) {
    if (queries_start(slab)) write_touching(batch, rows);
    return;
  }
  hits_.clear();
  find_hits(batch, proof, slab, hits_);
  write_rows(hits_, rows);
}

namespace {

/// Rows of pairs that all have the same times; within one scene the smaller id first. A branch would be
/// mispredicted; the expression is one that compilers do not turn into a branch.
template <bool within>
void write_pairs(std::span<const Pair> pairs, const std::int64_t* ids_a, const std::int64_t* ids_b,
                 const ContactTimes& times, JoinRow* rows) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::int64_t a = ids_a[pairs[i].a], b = ids_b[pairs[i].b];
    const std::int64_t exchanged = within ? (a ^ b) & -static_cast<std::int64_t>(b < a) : 0;
    rows[i].a = a ^ exchanged, rows[i].b = b ^ exchanged;
    rows[i].contact = times;
  }
}

}  // namespace

void ContactStage::write_touching(std::span<const Pair> pairs, std::vector<JoinRow>& rows) const {
  const ContactTimes times{question_.now, question_.now, 0, 0};
  const std::int64_t* ids = question_.a->ids.data();
  const std::size_t before = rows.size();
  rows.resize(before + pairs.size());
  if (question_.b)
    write_pairs<false>(pairs, ids, question_.b->ids.data(), times, rows.data() + before);
  else
    write_pairs<true>(pairs, ids, ids, times, rows.data() + before);
}

}  // namespace foresee
