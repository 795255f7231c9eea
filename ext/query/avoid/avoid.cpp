#include "query/avoid/avoid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/float_environment.h"
#include "query/avoid/proven_ranges.h"
#include "query/join/question.h"

namespace foresee {
namespace {

constexpr double min_number = std::numeric_limits<double>::denorm_min();

/// The rows of one manoeuvre.
class ManoeuvreRows {
 public:
  ManoeuvreRows(const AvoidQuestion& question, const OwnState& own, const QueriedChanges& queried,
                Interrupt& interrupt)
      : question_(question),
        own_(own),
        queried_(queried),
        interrupt_(interrupt),
        manoeuvre_(case_of(question, own, queried)),
        exact_(question, own, std::max(manoeuvre_.changed.legs.size(), own.legs.size()), scenes(),
               interrupt) {}

  std::vector<AvoidRow> rows() {
    if (queried_.lo == queried_.hi || changes_nothing()) {
      const double k = queried_.lo == queried_.hi ? queried_.lo : 0;
      add_row(is_clear(k), queried_.lo, queried_.hi);
    } else {
      tile(clear_ranges());
    }
    if (question_.wants_ends) find_ends();
    return std::move(rows_);
  }

 private:
  static ManoeuvreCase case_of(const AvoidQuestion& question, const OwnState& own,
                               const QueriedChanges& queried) {
    ManoeuvreCase one{question, own, queried, changed_legs(question, own, queried), false};
    one.turns = turns_with_course(question, one.first_leg());
    return one;
  }

  /// Also finds the near objects.
  ExactAvoidance::Scenes scenes() {
    const auto search = [&](const SearchTarget& others, std::optional<std::int64_t> itself) {
      manoeuvre_.near.push_back(
          intruders(question_, manoeuvre_.changed, queried_, others, itself, reach_to(others), interrupt_));
    };
    search(question_.others, question_.own->ids[0]);
    if (question_.also) search(*question_.also, std::nullopt);
    ExactAvoidance::Scenes scenes;
    for (const NearObjects& near : manoeuvre_.near) scenes.push_back(near.scene);
    return scenes;
  }

  Contact::Reach reach_to(const SearchTarget& others) const {
    Scene none;
    none.layout = others.layout();
    return make_contact(question_.own->bodies(), none.bodies(),
                        {{question_.now, question_.h}, question_.within, question_.within_z},
                        question_.own->name, others.name)
        ->reach();
  }

  /// An object at rest cannot turn, except an outline with a heading: all changes are one.
  bool changes_nothing() const {
    const auto none = [](const std::array<double, 3>& v) { return v[0] == 0 && v[1] == 0; };
    return manoeuvre_.first_leg().turns() && none(own_.base.v) && none(own_.base.a) && !manoeuvre_.turns;
  }

  /// The legs of the motion that is stored for k.
  std::vector<OwnMotion> motions_at(double k) const {
    if (k == 0) return own_.legs.empty() ? std::vector<OwnMotion>{own_.stored} : own_.legs;
    std::vector<OwnMotion> motions;
    for (const auto& leg : manoeuvre_.changed.legs) motions.push_back(leg->changed(k));
    return motions;
  }
  ExactAvoidance::Records records_at(double k) const {
    if (k == 0 && own_.legs.empty()) return {own_.record};
    return own_.records_of(motions_at(k));
  }

  /// The intruders that a change touches, by exact contact.
  std::vector<Intruder> touching_at(double k) {
    const bool are_later = manoeuvre_.changed.are_later;
    if (k == 0 || !(are_later || manoeuvre_.turns)) return exact_.touching(records_at(k));
    if (are_later && question_.touching == Touching::part)
      return exact_.touching(records_at(k), &no_intruders_);
    const std::vector<Intruder> first = exact_.touching_at_start(manoeuvre_.records_at_first());
    return exact_.touching(records_at(k), &first);
  }
  bool is_clear(double k) { return can_be_stored(k) && touching_at(k).empty(); }

  /// As finite numbers, and as an outline in this pose.
  bool can_be_stored(double k) const {
    for (const OwnMotion& motion : motions_at(k)) {
      if (!is_finite(motion)) return false;
      if (!manoeuvre_.turns) continue;
      try {
        question_.form->extents(motion.heading);
      } catch (const Error&) {
        return false;
      }
    }
    return true;
  }

  /// The proven ranges, and the exact decision on 0.
  std::vector<KRange> clear_ranges() {
    std::vector<KRange> clear;
    if (is_finite(own_.base)) clear = proven_ranges(manoeuvre_, exact_, interrupt_);
    if (queried_.lo > 0 || queried_.hi < 0) return clear;
    const auto after = std::find_if(clear.begin(), clear.end(), [](const KRange& r) { return r.to >= 0; });
    const bool has_0 = after != clear.end() && after->from <= 0;
    if (is_clear(0) == has_0) return clear;
    if (!has_0) {
      clear.insert(after, {0, 0});
      return clear;
    }
    const KRange around = *after;
    auto place = clear.erase(after);
    if (around.to > 0) place = clear.insert(place, {min_number, around.to});
    if (around.from < 0) clear.insert(place, {around.from, -min_number});
    return clear;
  }

  /// Rows of the clear ranges and of the blocked ones between them.
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
    const double k = from > 0 ? from : to < 0 ? to : 0;
    rows_.push_back({queried_.manoeuvre, clear, from, to, k, {}, {}, {}});
    if (question_.wants_motion) rows_.back().record = changed_record(question_, own_, queried_, k);
    if (question_.wants_plan) rows_.back().plan = changed_plan(question_, own_, queried_, k);
  }

  /// Names the blockers of both ends of blocked rows, and of the ends that clear rows share with them.
  void find_ends() {
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
      if (!can_be_stored(k)) return std::nullopt;
      const std::vector<Intruder> touching = touching_at(k);
      return touching.empty() ? std::nullopt : exact_.first_touching(records_at(k), touching);
    };
    if (auto found = end_is_clear ? std::nullopt : at(end)) return found;
    const double room = std::abs(other - end), direction = other > end ? 1 : -1;
    bool passed_0 = end == 0 || (end > 0) == (other > 0);
    for (double step = (queried_.hi - queried_.lo) * 0x1p-42; step < room; step *= 2) {
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

  const std::vector<Intruder> no_intruders_{};
  const AvoidQuestion& question_;
  const OwnState& own_;
  QueriedChanges queried_;
  Interrupt& interrupt_;
  ManoeuvreCase manoeuvre_;
  ExactAvoidance exact_;
  std::vector<AvoidRow> rows_;
};

}  // namespace

std::vector<AvoidRow> avoid(const AvoidQuestion& question, Interrupt& interrupt) {
  const FloatEnvironment environment;
  require_valid(question);
  std::vector<AvoidRow> rows;
  if (question.own->size() == 0) return rows;
  const OwnState own(question);
  if (!own.is_there({question.now, question.h})) return rows;
  for (const QueriedChanges& queried : queried_changes(question, own)) {
    std::vector<AvoidRow> some = ManoeuvreRows(question, own, queried, interrupt).rows();
    std::move(some.begin(), some.end(), std::back_inserter(rows));
  }
  return rows;
}

}  // namespace foresee
