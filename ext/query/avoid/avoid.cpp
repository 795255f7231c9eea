#include "query/avoid/avoid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "query/avoid/proven_ranges.h"

namespace foresee {
namespace {

constexpr double min_number = std::numeric_limits<double>::denorm_min();

/// Of these changes, the one that changes the object least.
double nearest_to_0(double from, double to) {
  return from > 0 ? from : to < 0 ? to : 0;
}

/// The rows of one manoeuvre.
class ManoeuvreRows {
 public:
  ManoeuvreRows(const ManoeuvreCase& manoeuvre, Interrupt& interrupt)
      : manoeuvre_(manoeuvre),
        question_(manoeuvre.question),
        queried_(manoeuvre.queried),
        interrupt_(interrupt),
        exact_(manoeuvre, interrupt) {}

  std::vector<AvoidRow> rows() {
    if (queried_.lo == queried_.hi || changes_nothing()) {
      const double k = queried_.lo == queried_.hi ? queried_.lo : 0;
      add_row(is_clear(k), queried_.lo, queried_.hi);
    } else {
      std::vector<KRange> clear;
      if (is_finite(manoeuvre_.own.base)) clear = proven_ranges(manoeuvre_, exact_, interrupt_);
      tile(with_exact_0(std::move(clear)));
    }
    if (question_.wants_ends) name_blockers();
    return std::move(rows_);
  }

 private:
  /// An object at rest cannot turn, except an outline with a heading: all changes are one.
  bool changes_nothing() const {
    const auto none = [](const std::array<double, 3>& v) { return v[0] == 0 && v[1] == 0; };
    const OwnMotion& base = manoeuvre_.own.base;
    return manoeuvre_.first_leg().turns() && none(base.v) && none(base.a) && !manoeuvre_.rotates_outline;
  }

  /// The legs of the motion that is stored for k.
  std::vector<OwnMotion> motions_at(double k) const {
    const OwnState& own = manoeuvre_.own;
    if (k == 0) return own.legs.empty() ? std::vector<OwnMotion>{own.stored} : own.legs;
    std::vector<OwnMotion> motions;
    Steps steps(interrupt_);
    for (const auto& leg : manoeuvre_.changed.legs) {
      steps();
      motions.push_back(leg->changed(k));
    }
    return motions;
  }

  /// What touches when the manoeuvre starts, and is exempt as Touching says. It is seen at the start of
  ///   k = 0, or a change of motion    the changed motion: it starts where the unchanged one is, in the same pose
  ///   a delay or a wait               the unchanged motion, with `ignore`; else nothing is exempt
  ///   a turn of the own outline       the unchanged motion: the changed one starts in another pose
  std::vector<NearRow> exempt_at(double k, const OwnState::Records& records) {
    const bool are_later = manoeuvre_.changed.are_later;
    if (k == 0 || !(are_later || manoeuvre_.rotates_outline)) return exact_.touching_at_start(records);
    if (are_later && question_.touching != Touching::ignore) return {};
    if (!exempt_) exempt_ = exact_.touching_at_start(manoeuvre_.records_at_start());
    return *exempt_;
  }
  bool is_clear(double k) {
    const std::vector<OwnMotion> motions = motions_at(k);
    if (!can_be_stored(motions)) return false;
    const OwnState::Records records = manoeuvre_.own.records_of(motions);
    return exact_.touching(records, exempt_at(k, records)).empty();
  }

  /// As finite numbers, and as an outline in these poses.
  bool can_be_stored(const std::vector<OwnMotion>& motions) const {
    for (const OwnMotion& motion : motions) {
      if (!is_finite(motion)) return false;
      if (!manoeuvre_.rotates_outline) continue;
      try {
        question_.form->extents(motion.heading);
      } catch (const Error&) {
        return false;
      }
    }
    return true;
  }

  /// These ranges, with or without 0 as exact contact decides.
  std::vector<KRange> with_exact_0(std::vector<KRange> clear) {
    if (queried_.lo > 0 || queried_.hi < 0) return clear;
    const auto after = std::find_if(clear.begin(), clear.end(), [](const KRange& r) { return r.to >= 0; });
    const bool has_0 = after != clear.end() && after->from <= 0;
    if (is_clear(0) == has_0) return clear;
    if (!has_0) {
      clear.insert(after, {0, 0});
      return clear;
    }
    // 0 touches: the ranges end at the doubles next to 0.
    const KRange around = *after;
    auto place = clear.erase(after);
    if (around.to > 0) place = clear.insert(place, {min_number, around.to});
    if (around.from < 0) clear.insert(place, {around.from, -min_number});
    return clear;
  }

  /// Adds a clear row for each of these ranges, and a blocked one for each gap: the two alternate.
  void tile(const std::vector<KRange>& clear) {
    double from = queried_.lo;
    for (const KRange& range : clear) {
      if (range.from > from) add_row(false, from, range.from);
      add_row(true, range.from, range.to);
      from = range.to;
    }
    if (from < queried_.hi || clear.empty()) add_row(false, from, queried_.hi);
  }

  void add_row(bool clear, double from, double to) {
    const double k = nearest_to_0(from, to);
    rows_.push_back({queried_.manoeuvre, clear, from, to, k, {}, {}, {}});
    if (question_.wants_motion) rows_.back().record = changed_record(manoeuvre_, k);
    if (question_.wants_plan) rows_.back().plan = changed_plan(manoeuvre_, k);
  }

  /// Names the blockers of both ends of blocked rows, and of the ends that clear rows share with them.
  void name_blockers() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      AvoidRow& row = rows_[i];
      if (row.clear) continue;
      const bool shares_from = i > 0, shares_to = i + 1 < rows_.size();
      row.below = blocker(row.k_from, row.k_to, shares_from);
      row.above = blocker(row.k_to, row.k_from, shares_to);
      if (shares_from) rows_[i - 1].above = row.below;
      if (shares_to) rows_[i + 1].below = row.above;
    }
  }

  /// The first blocker, as changes go from one end of a blocked row towards the other.
  std::optional<Blocker> blocker(double end, double other, bool end_is_clear) {
    const auto at = [&](double k) -> std::optional<Blocker> {
      const std::vector<OwnMotion> motions = motions_at(k);
      if (!can_be_stored(motions)) return std::nullopt;
      const OwnState::Records records = manoeuvre_.own.records_of(motions);
      const std::vector<NearRow> touching = exact_.touching(records, exempt_at(k, records));
      return touching.empty() ? std::nullopt : exact_.first_touching(records, touching);
    };
    if (auto found = end_is_clear ? std::nullopt : at(end)) return found;
    const double room = std::abs(other - end), direction = other > end ? 1 : -1;
    bool passed_0 = end == 0 || (end > 0) == (other > 0);
    const double smallest = queried_.hi * 0x1p-42 - queried_.lo * 0x1p-42;  // 0 if the range is that short
    for (double step = std::max(smallest, min_number); step < room; step *= 2) {
      const double k = end + direction * step;
      if (!passed_0 && (k > 0) != (end > 0)) {
        passed_0 = true;
        if (auto found = at(0)) return found;
      }
      if (auto found = at(k)) return found;
    }
    if (!passed_0)
      if (auto found = at(0)) return found;
    return std::nullopt;
  }

  const ManoeuvreCase& manoeuvre_;
  const AvoidQuestion& question_;
  const QueriedChanges& queried_;
  Interrupt& interrupt_;
  ExactAvoidance exact_;
  /// Once known: what touches when the manoeuvre starts, for motions whose own start does not show it.
  std::optional<std::vector<NearRow>> exempt_;
  std::vector<AvoidRow> rows_;
};

}  // namespace

std::vector<AvoidRow> avoid(const AvoidQuestion& question, Interrupt& interrupt) {
  const FloatEnvironment environment;
  require_valid(question);
  std::vector<AvoidRow> rows;
  if (question.own_scene->size() == 0) return rows;
  const OwnState own(question);
  if (!own.is_there({question.now, question.h})) return rows;
  for (const QueriedChanges& queried : queried_changes(question, own)) {
    std::vector<AvoidRow> some =
        ManoeuvreRows(manoeuvre_case(question, own, queried, interrupt), interrupt).rows();
    std::move(some.begin(), some.end(), std::back_inserter(rows));
  }
  return rows;
}

}  // namespace foresee
