#include "query/avoid/avoid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/axes.h"
#include "base/float_environment.h"
#include "motion/swept_box.h"
#include "query/avoid/clear_ranges.h"
#include "query/avoid/initial_state.h"
#include "query/avoid/intruders.h"
#include "query/avoid/own_state.h"
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
        changes_(changes_of(question, own, queried)),
        turns_(turns_with_course(question, *changes_)),
        interrupt_(interrupt),
        exact_(question, scenes(), interrupt) {}

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
  ExactAvoidance::Scenes scenes() {
    ExactAvoidance::Scenes near;
    const auto search = [&](const SearchTarget& others, std::optional<std::int64_t> itself) {
      near.push_back(intruders(question_, *changes_, queried_, others, itself, reach_to(others), interrupt_));
    };
    search(question_.others, question_.own->ids[0]);
    if (question_.also) search(*question_.also, std::nullopt);
    near_ = near;
    return near;
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
    return changes_->turns() && none(own_.base.v) && none(own_.base.a) && !turns_;
  }

  OwnMotion motion_at(double k) const { return k == 0 ? own_.stored : changes_->changed(k); }
  std::vector<double> record_at(double k) const {
    return k == 0 ? own_.record : own_.record_of(motion_at(k));
  }
  /// What this touches at first touches already: the object at the change; for a delay, at its stored start.
  std::vector<double> record_at_first() const { return own_.record_of(changes_->unchanged()); }

  /// The intruders that a change touches, by exact contact.
  std::vector<Intruder> touching_at(double k) {
    if (k == 0 || !(changes_->starts_vary() || turns_)) return exact_.touching(record_at(k));
    if (changes_->starts_vary() && question_.touching == Touching::part)
      return exact_.touching(record_at(k), &no_intruders_);
    const std::vector<Intruder> first = exact_.touching_at_start(record_at_first());
    return exact_.touching(record_at(k), &first);
  }
  bool is_clear(double k) { return can_be_stored(motion_at(k)) && touching_at(k).empty(); }

  /// As finite numbers, and as an outline in this pose.
  bool can_be_stored(const OwnMotion& motion) const {
    if (!is_finite(motion)) return false;
    if (!turns_) return true;
    try {
      question_.form->extents(motion.heading);
    } catch (const Error&) {
      return false;
    }
    return true;
  }

  /// The proven ranges, and the exact decision on 0.
  std::vector<KRange> clear_ranges() {
    std::vector<KRange> clear;
    if (is_finite(own_.base))
      clear = with_axes(question_.own->layout.axes, [&]<int D>(Axes<D>) { return proven<D>(); });
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

  template <int D>
  std::vector<KRange> proven() {
    const auto marked = [&](const std::vector<Intruder>& some) {
      std::vector<std::vector<std::uint8_t>> marks;
      for (const auto& near : near_) marks.emplace_back(near->size());
      for (const Intruder& intruder : some) marks[static_cast<std::size_t>(intruder.table)][intruder.row] = 1;
      return marks;
    };
    const auto first = marked(exact_.touching_at_start(record_at_first()));
    const auto at_start = changes_->starts_vary() ? marked(touching_at_rest()) : first;
    struct Ordered {
      double nearness;
      std::size_t table;
      std::int64_t id;
      IntruderCertificate<D> certificate;
    };
    std::vector<Ordered> ordered;
    const Bodies own = question_.own->bodies();
    std::vector<Bodies> others;
    for (const auto& near : near_) others.push_back(near->bodies());
    const Horizon horizon{question_.now, question_.h};
    std::shared_ptr<const OwnOutline> own_outline;
    for (std::size_t table = 0; table < near_.size(); ++table) {
      const Bodies& there = others[table];
      const PairRule rule(own.layout, there.layout, question_.within, question_.within_z);
      const bool outlines = rule.pieces == PieceKind::planar;
      if (outlines && !own_outline) own_outline = std::make_shared<OwnOutline>(own, 0, turns_);
      for (std::size_t i = 0; i < there.count; ++i) {
        if (i % 4096 == 0) interrupt_.check();
        const bool touches = first[table][i] != 0;
        if (touches && question_.touching == Touching::ignore) continue;
        const auto extents = extents_of_both<D>(rule, own.row(0), there.row(i), changes_->reference().t);
        auto encounter = encounter_of<D>(changes_->reference(), horizon, there, there.row(i), extents);
        if (encounter.begin > encounter.end) continue;
        const double far = (encounter.x.abs() - encounter.extents.half).maxCoeff() - encounter.extents.radius;
        const auto pair = outlines ? std::make_shared<const OutlinePair>(own_outline, there, i) : nullptr;
        const auto known = at_first<D>(encounter, touches, at_start[table][i] != 0);
        if (needs_exact_state(encounter, touches)) {
          const Intruder intruder{static_cast<int>(table), static_cast<std::uint32_t>(i)};
          take_exact_state(encounter, exact_.initial_state(record_at_first(), intruder),
                           changes_->starts_vary());
        }
        ordered.push_back({far, table, near_[table]->ids[i], {encounter, known, std::move(pair)}});
      }
    }
    std::sort(ordered.begin(), ordered.end(), [](const Ordered& a, const Ordered& b) {
      return std::tie(a.nearness, a.table, a.id) < std::tie(b.nearness, b.table, b.id);
    });
    std::vector<IntruderCertificate<D>> certificates;
    for (Ordered& one : ordered) certificates.push_back(std::move(one.certificate));
    return ClearRanges<D>(*changes_, std::move(certificates), interrupt_).between(queried_.lo, queried_.hi);
  }

  /// The intruders that the object touches at any time if it remains at its start.
  std::vector<Intruder> touching_at_rest() {
    OwnMotion resting = own_.stored;
    resting.t = changes_->reference().t, resting.until = std::numeric_limits<double>::infinity();
    resting.v = resting.a = resting.force = {};
    return exact_.touching(own_.record_of(resting), &no_intruders_);
  }

  /// For a delay only the state of a resting intruder is known: it has the same position at every start.
  template <int D>
  typename IntruderCertificate<D>::AtFirst at_first(const Encounter<D>& encounter, bool touches,
                                                    bool touches_at_start) const {
    using AtFirst = typename IntruderCertificate<D>::AtFirst;
    if (changes_->starts_vary()) {
      const bool rests = (encounter.v == 0).all() && (encounter.ev == 0).all() && !encounter.bends() &&
                         !encounter.extents.grows;
      return rests && !touches_at_start ? AtFirst::apart : AtFirst::unknown;
    }
    if (touches) return AtFirst::touches;
    return encounter.begin > 0 || turns_ ? AtFirst::unknown : AtFirst::apart;
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
    if (question_.wants_motion) rows_.back().record = record_at(k);
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
      if (!can_be_stored(motion_at(k))) return std::nullopt;
      const std::vector<Intruder> touching = touching_at(k);
      return touching.empty() ? std::nullopt : exact_.first_touching(record_at(k), touching);
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
  std::unique_ptr<Changes> changes_;
  bool turns_;  ///< the own outline rotates with the course
  Interrupt& interrupt_;
  ExactAvoidance::Scenes near_;
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
  if (life_of(own.stored.t, own.stored.until, {question.now, question.h}).none) return rows;
  for (const QueriedChanges& queried : queried_changes(question, own)) {
    std::vector<AvoidRow> some = ManoeuvreRows(question, own, queried, interrupt).rows();
    std::move(some.begin(), some.end(), std::back_inserter(rows));
  }
  return rows;
}

}  // namespace foresee
