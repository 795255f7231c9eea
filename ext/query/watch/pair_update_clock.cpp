// Clock of an update: its new value, the length of the look-ahead, and the conditions of recomputation.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "query/watch/pair_update.h"

namespace foresee {
namespace {

/// Appends the reference times of all objects, of a plan that of its first leg. Requires: a layout with t, or none has.
void append_times(const Scene& scene, std::vector<double>& instants) {
  const Bodies bodies = scene.bodies();
  for (std::size_t i = 0; i < scene.object_count(); ++i)
    instants.push_back(value_or(bodies.row(scene.rows_of(i).first), bodies.at.t, 0));
}

/// How many numbers an interval of this width has at its fullest place, and the last of them. Requires: ascending.
struct Cluster {
  std::int64_t count = 0;
  double last = 0;
};
Cluster largest_cluster(std::span<const double> ascending, double width) {
  Cluster largest;
  std::size_t first = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    while (ascending[i] - ascending[first] > width) ++first;
    const auto count = static_cast<std::int64_t>(i - first + 1);
    if (count >= largest.count) largest = {count, ascending[i]};
  }
  return largest;
}

bool has_long_look_ahead(const WatchState& state) {
  return state.look_ahead_length >= state.horizon / 8;
}

}  // namespace

void PairUpdate::move_clock() {
  if (state_.requested_clock) state_.clock = state_.requested_clock;
  state_.requested_clock.reset();
  if (!state_.manual && state_.ahead)
    follow_reports();
  else if ((!state_.manual || !state_.clock) && any_object(tables_)) {
    const double newest = tables_.newest_t();
    state_.clock = std::max(newest, state_.clock.value_or(newest));
  }
  if (!state_.clock && state_.manual) state_.clock = 0;
  clock_ = state_.clock.value_or(0);
  horizon_end_ = clock_ + state_.horizon;
  if (before_.clock && clock_ != *before_.clock) state_.last_advance = std::abs(clock_ - *before_.clock);
}

/// The tables whose rows have the time of a report. Zones without t are always there, and say nothing about the time.
std::vector<PairUpdate::Reporting> PairUpdate::reporting_tables() const {
  std::vector<Reporting> tables{{&changed_.a, tables_.a.get()}};
  if (!tables_.is_within_one()) tables.push_back({&changed_.b, tables_.b.get()});
  const auto lacks_t = [](const Reporting& one) { return !one.table->layout().has_t; };
  if (!std::all_of(tables.begin(), tables.end(), lacks_t)) std::erase_if(tables, lacks_t);
  return tables;
}

/// Reference times of the objects that this transaction has changed, or of all objects if the changes are
/// unknown or if all are wanted; in rising order.
std::vector<double> PairUpdate::report_times(bool of_all) const {
  std::vector<double> instants;
  for (const auto& [changed, table] : reporting_tables()) {
    if (of_all || !changed->are_known)
      append_times(*table->all(), instants);
    else if (table->layout().has_t)
      instants.insert(instants.end(), changed->instants.begin(), changed->instants.end());
    else
      instants.resize(instants.size() + changed->ids.size());
  }
  std::sort(instants.begin(), instants.end());
  return instants;
}

/// Advances the clock by the reports in order of time; counts those too far ahead of it. The first reports
/// have no clock to compare with: it starts at their median, since most times are right.
void PairUpdate::follow_reports() {
  const std::vector<double> instants = report_times();
  const bool counts = !state_.clock || (changed_.a.are_known && changed_.b.are_known);
  if (!state_.clock && !instants.empty()) state_.clock = instants[(instants.size() - 1) / 2];
  if (!state_.clock && any_object(tables_)) state_.clock = 0;  // zones, and no report yet
  const double clock_before = state_.clock.value_or(0);
  std::int64_t early = 0;
  for (const double t : instants) {
    if (t > *state_.clock + *state_.ahead)
      ++early;
    else
      state_.clock = std::max(*state_.clock, t);
  }
  const std::int64_t others = static_cast<std::int64_t>(instants.size()) - early;
  const std::int64_t before = state_.early_reports;
  if (counts) {
    // Reports that advance the clock show that it is alive, however seldom they come beside one fast clock.
    const bool advances = state_.clock.value_or(0) > clock_before;
    state_.early_score = advances ? 0 : std::max<std::int64_t>(0, state_.early_score + early - 2 * others);
    state_.early_reports += early;
    if (early <= others) return;
  }
  // All objects are read after each so many early reports: some rows for each.
  double objects = 0;
  for (const Reporting& one : reporting_tables()) {
    if (one.table->layout().has_plan) return;  // its t is the start of a plan, which may be planned for later
    objects += one.table->likely_objects();
  }
  const auto some = std::max<std::int64_t>(1, static_cast<std::int64_t>(objects / 64));
  if (!counts || before / some != state_.early_reports / some) follow_early_reports();
}

/// After a pause of the feed that is longer than `ahead`, every report is early. The clock follows objects whose early
/// reports agree within `ahead`, if they are more than agree at any other time. It follows fewer once their reports are
/// more than those others, and no other report advances the clock. Some fast clocks among many right ones are neither.
void PairUpdate::follow_early_reports() {
  constexpr std::int64_t min_score = 16;
  const std::vector<double> instants = report_times(true);
  const std::span<const double> all(instants.data(), instants.size());
  const auto first_early = static_cast<std::size_t>(
      std::upper_bound(all.begin(), all.end(), *state_.clock + *state_.ahead) - all.begin());
  const Cluster others = largest_cluster(all.first(first_early), *state_.ahead),
                early = largest_cluster(all.subspan(first_early), *state_.ahead);
  if (early.count == 0) return;
  if (early.count <= others.count && state_.early_score < 2 * early.count + others.count + min_score) return;
  state_.clock = early.last;
  state_.early_score = 0;
}

// A long look-ahead leaves the ends beyond the next one to it. A short one finds all, so that few are looked for twice.
double ends_known_to(const WatchState& state) {
  return has_long_look_ahead(state) ? state.known_to - state.horizon : state.known_to;
}

// The clock must not pass the known ends between two look-aheads, so a long one comes a few steps of the clock early.
bool PairUpdate::must_look_ahead() const {
  const double step = std::max(state_.last_advance, before_.last_advance);
  const double lead = has_long_look_ahead(before_) ? std::min(before_.look_ahead_length / 4, 4 * step) : 0;
  return !(next_above(horizon_end_ + lead) <= before_.known_to);
}

bool PairUpdate::must_recompute() const {
  if (!changed_.a.are_known || !changed_.b.are_known || before_.must_rebuild || !before_.clock) return true;
  if (clock_ < *before_.clock || clock_ > ends_known_to(before_)) return true;
  return is_majority(changed_.a, *tables_.a) || is_majority(changed_.b, tables_.side_b());
}

/// Doubles or halves the look-ahead. A search costs about a hundred nanoseconds per object at any length.
/// Each pair found costs two row writes, which are wasted if the pair is erased before it is shown. The two
/// costs are kept about equal.
void PairUpdate::adapt_look_ahead() {
  double objects = tables_.a->likely_objects();
  if (!tables_.is_within_one()) objects += tables_.b->likely_objects();
  const double dropped = static_cast<double>(state_.dropped_waiting), fair = std::max(objects / 64, 16.0);
  if (dropped < fair / 2 && 10 * state_.dropped_waiting <= state_.found_waiting)
    state_.look_ahead_length *= 2;
  else if (dropped > 2 * fair || 2 * state_.dropped_waiting > state_.found_waiting)
    state_.look_ahead_length /= 2;
}

/// The next look-ahead is due after several steps of the clock, if these are small compared with the horizon.
/// A single large step does not count.
void PairUpdate::extend_look_ahead() {
  const double largest = std::max(std::abs(clock_), std::abs(horizon_end_));
  const double rounding = 8 * (next_above(largest) - largest);  // a smaller extension can vanish
  const double step = std::min(state_.last_advance, before_.last_advance);
  const double shortest = std::max(rounding, std::min(16 * step, state_.horizon / 64));
  const double longest = std::max({shortest, state_.horizon, 1024 * step});
  if (state_.look_ahead_length <= 0) state_.look_ahead_length = state_.horizon / 4;
  state_.look_ahead_length = std::clamp(state_.look_ahead_length, shortest, longest);
  state_.found_waiting = 0;
  state_.dropped_waiting = 0;
  queried_length_ = state_.horizon + state_.look_ahead_length;
  if (!std::isfinite(queried_length_)) queried_length_ = state_.horizon;
  state_.known_to = std::nextafter(clock_ + queried_length_, -std::numeric_limits<double>::infinity());
}

}  // namespace foresee
