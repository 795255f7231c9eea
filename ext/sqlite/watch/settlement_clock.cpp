// A settlement's clock: where it moves, how far the rows reach from there, and when they must be made anew.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sqlite/watch/settlement.h"

namespace foresee::sqlite {
bool Settlement::any_object() const {
  const auto has_any = [](const Connection::OpenTable& table) {
    return table.store->take_snapshot()->find_root() != 0;
  };
  return has_any(tables_.a) || (tables_.b && has_any(*tables_.b));
}

void Settlement::move_clock() {
  if (state_.asked) state_.clock = state_.asked;
  state_.asked.reset();
  if (!state_.manual && state_.ahead && state_.clock)
    move_clock_by_reports();
  else if ((!state_.manual || !state_.clock) && any_object()) {
    double newest = tables_.a.store->read_newest_t();
    if (tables_.b) newest = std::max(newest, tables_.b->store->read_newest_t());
    state_.clock = std::max(newest, state_.clock.value_or(newest));
  }
  if (!state_.clock && state_.manual) state_.clock = 0;
  clock_ = state_.now();
  horizon_end_ = clock_ + state_.horizon;
  if (before_.clock && clock_ != *before_.clock) state_.step = std::abs(clock_ - *before_.clock);
}

/// By the reports of this transaction, in the order of their moments; those too far ahead are counted.
void Settlement::move_clock_by_reports() {
  std::vector<double> moments = changed_a_.moments;
  if (!tables_.are_one()) moments.insert(moments.end(), changed_b_.moments.begin(), changed_b_.moments.end());
  std::sort(moments.begin(), moments.end());
  for (const double t : moments) {
    if (t > *state_.clock + *state_.ahead)
      ++state_.early;
    else
      state_.clock = std::max(*state_.clock, t);
  }
}

bool Settlement::must_compute_anew() const {
  if (!changed_a_.told || !changed_b_.told || before_.anew || !before_.clock) return true;
  if (clock_ < *before_.clock || clock_ > before_.known_to) return true;
  const auto most = [](const Connection::OpenTable& table) {
    return 0.3 * static_cast<double>(table.store->likely_objects());
  };
  if (static_cast<double>(changed_a_.ids.size()) > std::max(64.0, most(tables_.a))) return true;
  return tables_.b && static_cast<double>(changed_b_.ids.size()) > std::max(64.0, most(*tables_.b));
}

/// Far enough that the next look comes after some steps of the clock; a single leap does not count.
void Settlement::look_further() {
  const double largest = std::max(std::abs(clock_), std::abs(horizon_end_));
  const double least = 8 * (next_above(largest) - largest);  // what rounding cannot swallow
  const double further = std::max({least, state_.horizon / 4, 16 * std::min(state_.step, before_.step)});
  reach_ = state_.horizon + further;
  if (!std::isfinite(reach_)) reach_ = state_.horizon;
  state_.known_to = std::nextafter(clock_ + reach_, -std::numeric_limits<double>::infinity());
}

}  // namespace foresee::sqlite
